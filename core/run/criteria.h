/* The criteria of a scene along its run: damage laws that look on, each with the times at which its damage
 * begins and reaches 1, and what the membrane looks like then. */
#ifndef CAPSELLA_RUN_CRITERIA_H
#define CAPSELLA_RUN_CRITERIA_H

#include "base/status.h"
#include "membrane/observer.h"
#include "observe/verdict.h"
#include "run/simulation.h"

typedef struct Record Record;

typedef struct {
  Observers observers;
  Finding *finding; /* [observers.n] complete once d has reached 1; else t_c and the like alone */
} Criteria;

/* Nothing is set up for a scene without criteria. */
Status criteria_new(Criteria *criteria, const Simulation *simulation, Error *error);
void criteria_free(Criteria *criteria);

/* The record stands at the start of a new run. */
Status criteria_begin(Record *record, Error *error);

/* Takes the proposed step in: events inside it, then its end.  Leaves the probe anywhere in the step. */
Status criteria_advance(Record *record, Error *error);

/* verdicts [observers.n] at the probed time, which is that of the accepted state. */
Status criteria_verdicts(Record *record, Verdict *verdicts, Error *error);

#endif
