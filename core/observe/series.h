/* series.xdmf: the snapshots of a folder as one time series (XDMF 3, quadratic triangles, data in the vtkhdf
 * files), and snapshots.hdf.series, the same list for ParaView's own reader of VTKHDF files (the name that
 * ParaView 5.11 knows; later ones know it too).
 *
 * Both are rewritten whole after each snapshot and name files relative to their own folder, which may be
 * moved. */
#ifndef CAPSELLA_OBSERVE_SERIES_H
#define CAPSELLA_OBSERVE_SERIES_H

#include "base/status.h"
#include "observe/snapshot.h"

typedef struct {
  int number;
  double t;
} SeriesEntry;

/* Starts from `Series series = {0}`. */
typedef struct {
  SeriesEntry *entry;
  size_t count, capacity;
} Series;

void series_free(Series *series);

/* Takes in the snapshots numbered up to and including `newest` that a folder already holds (a resumed run).
 * A damaged one is left out with a warning in the log (may be NULL). */
Status series_restore(Series *series, const char *folder, int newest, Log *log, Error *error);

/* Adds the snapshot just written as `number` (an entry of the same number is replaced, later ones go) and
 * writes both files.  Every snapshot of a series has the same mesh sizes and fields. */
Status series_add(Series *series, const char *folder, int number, const Snapshot *snapshot, Error *error);

#endif
