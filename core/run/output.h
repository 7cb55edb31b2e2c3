/* What a run writes into its folder, and how it is taken up again from there. */
#ifndef CAPSELLA_RUN_OUTPUT_H
#define CAPSELLA_RUN_OUTPUT_H

#include "base/log.h"
#include "base/status.h"
#include "base/text.h"
#include "observe/history.h"
#include "observe/series.h"
#include "run/nodal_fields.h"
#include "run/parameter_cells.h"
#include "run/record.h"
#include "run/simulation.h"

typedef struct {
  const char *folder;
  Text resolved; /* the scene with every default, as written to resolved.yaml and kept in each snapshot */
  History history;
  Series series;
  ParameterCells parameters;
  long long next_sample,
      next_snapshot;         /* due at next * history_every, next * snapshot_every after the start */
  long long snapshot_number; /* of the next snapshot file */
  double last_row_t;         /* time of the last row; NAN: none */
  double last_snapshot_t;    /* time of the last snapshot; NAN: none */
  NodalFields nodal;
} Output;

/* Makes ready; nothing is written yet. */
Status output_open(Output *output, const char *folder, const Simulation *simulation, Error *error);
void output_close(Output *output);

/* A new run: removes what an earlier one has left in the folder, writes resolved.yaml, starts the history. */
Status output_start(Output *output, const Simulation *simulation, Error *error);

/* Time of the next sample or snapshot; INFINITY when none is asked for. */
double output_next_sample(const Output *output, const Simulation *simulation);
double output_next_snapshot(const Output *output, const Simulation *simulation);

Status output_row(Output *output, const HistoryRow *row, Error *error);

/* The accepted state, with the record's probe there. */
Status output_snapshot(Output *output, Simulation *simulation, Record *record, Error *error);

/* Restores simulation and record from the newest whole snapshot of the folder, where nothing is changed;
 * `number` is -1 when there is none. */
Status output_restore(Output *output, Simulation *simulation, Record *record, Log *log, int *number,
                      Error *error);

/* Restores simulation and record from the newest whole snapshot of the folder, and takes up history and
 * series where that stands.  `found` is false when there is none: the run then starts anew. */
Status output_resume(Output *output, Simulation *simulation, Record *record, Log *log, bool *found,
                     Error *error);

#endif
