/* The capsule in the data of a page: states from snapshots, packed. */
#ifndef CAPSELLA_RUN_PAGE_SURFACES_H
#define CAPSELLA_RUN_PAGE_SURFACES_H

#include "base/log.h"
#include "config/scene.h"
#include "observe/page.h"

/* A snapshot to show, and its name in the page; without one it is shown by its time. */
typedef struct {
  char *path, *label; /* label may be NULL */
} PageState;

/* Writes the member "surface": the states that can be read and have the mesh of the first of these, or as
 * many of them as keep the page small, the first and the last among them; null when there is none.  The flow
 * is that of `scene`.  What cannot be read is told to the log (may be NULL). */
Status page_put_surfaces(Page *page, const Scene *scene, const PageState *states, size_t count, Log *log);

/* The same for the snapshots of a run's folder. */
Status page_put_snapshots(Page *page, const Scene *scene, Log *log);

#endif
