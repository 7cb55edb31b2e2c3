/* Whether the membrane comes near to itself, where a fluid moves it: told when the film between two of its
 * parts is thinner than the mesh resolves, and the end of a run when they touch or cross. */
#ifndef CAPSELLA_RUN_CONTACT_GUARD_H
#define CAPSELLA_RUN_CONTACT_GUARD_H

#include "base/log.h"
#include "base/status.h"
#include "run/record.h"

/* Looks at the end of the proposed step when it is due: after some evaluations of the velocity, beside which
 * the look costs little, and at the end of the run.  STATUS_FAILED with time and place when the membrane
 * touches or crosses itself. */
Status contact_guard(Record *record, Log *log, Error *error);

/* The record has been restored from a snapshot. */
void contact_guard_resume(Record *record);

#endif
