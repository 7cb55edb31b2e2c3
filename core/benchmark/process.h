/* What a run of a whole program costs, from its start to its end. */
#ifndef CAPSELLA_BENCHMARK_PROCESS_H
#define CAPSELLA_BENCHMARK_PROCESS_H

#include "base/status.h"

typedef struct {
  double seconds, cpu_seconds; /* median of several */
} ProcessCost;

/* Runs argv[0] (a path) with argv (ended by NULL) and its output thrown away.  STATUS_FAILED when it cannot
 * be started or does not end with 0. */
Status process_measure(const char *const *argv, ProcessCost *cost, Error *error);

#endif
