/* Maps of fields over the membrane, from the snapshots of runs. */
#ifndef CAPSELLA_RUN_MAPS_H
#define CAPSELLA_RUN_MAPS_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>

enum { MAPS_MOST = 8 };

/* Columns: of one folder the snapshots nearest to the times (none: the newest), of several the newest of
 * each.  Rows: each field from each view. */
typedef struct {
  const char *folders[MAPS_MOST]; /* of runs */
  size_t n_folders;
  double times[MAPS_MOST];
  size_t n_times;
  const char *fields[MAPS_MOST];
  size_t n_fields;
  const char *views[MAPS_MOST];
  size_t n_views;
  double minimum, maximum; /* of the colours; equal: of each row by itself */
} MapsOptions;

/* Names, ending in NULL. */
extern const char *const MAPS_FIELDS[];
extern const char *const MAPS_VIEWS[];

/* Appends the SVG.  STATUS_INPUT: an unknown name, or no such snapshot. */
Status maps_print(const MapsOptions *options, Text *svg, Error *error);

#endif
