/* What is to be found by trials, and where it is looked for: the keys `find`, `bracket` and `tolerance`. */
#ifndef CAPSELLA_STUDY_PLAN_H
#define CAPSELLA_STUDY_PLAN_H

#include "study/target.h"

enum { MOST_TARGETS = 8 };

typedef struct {
  Target target[MOST_TARGETS];
  size_t n_targets;
  double low, high, tolerance;
} Plan;

/* Reads the three keys, which must all be there.  STATUS_INPUT with the place of what is wrong. */
Status plan_read(const Study *study, Plan *plan, Error *error);

#endif
