/* One step of a run, without what is written of it, and when a run has become steady. */
#ifndef CAPSELLA_RUN_MARCH_H
#define CAPSELLA_RUN_MARCH_H

#include "base/log.h"
#include "base/status.h"
#include "observe/history.h"
#include "run/record.h"
#include <stdbool.h>

/* Proposes a step to t_limit at most, and finds first damage and rupture in it; record->t1 is its end.  Where
 * the scene stops at rupture, the step ends there and `ruptured` is true.  Samples inside the step are taken
 * now. */
Status march_propose(Record *record, double t_limit, Log *log, bool *ruptured, Error *error);

/* Takes the end of the proposed step as the accepted state. */
Status march_accept(Record *record, Error *error);

/* The load at time t of the proposed step, or at the accepted time: it last belonged to another state. */
Status march_renew_load(Record *record, double t, Error *error);

/* The trial state of a step that failed is gone: goes back to the accepted one. */
Status march_fall_back(Record *record, Error *error);

/* Watches the rates of D12 and d_max from sample to sample. */
void march_watch_steady(Record *record, const HistoryRow *row);

/* Keeps the largest wrinkles. */
void march_watch_wrinkles(Record *record, const HistoryRow *row);

/* Whether stop.steady asks for it and the rates have been below it for long enough. */
bool march_is_steady(const Record *record);

#endif
