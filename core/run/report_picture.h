/* The capsule of a run's folder as a picture for papers: deformed in two views, and at rest. */
#ifndef CAPSELLA_RUN_REPORT_PICTURE_H
#define CAPSELLA_RUN_REPORT_PICTURE_H

#include "base/status.h"
#include "base/text.h"

typedef struct {
  const char
      *field;  /* a field of the snapshots with one component: d, Y, T1, T2; NULL: d, or Y without damage */
  double time; /* the snapshot nearest to it; NAN: the newest */
} ReportChoice;

/* Appends an SVG document.  The place of first rupture, or of the largest damage, is marked once the run has
 * come to its end.  STATUS_INPUT: no snapshot, or no such field. */
Status report_picture(const char *folder, const ReportChoice *choice, Text *svg, Error *error);

#endif
