#include "base/timer.h"

#include <stdlib.h>
#include <time.h>

static double seconds(clockid_t clock) {
  struct timespec now;
  clock_gettime(clock, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double timer_wall_seconds(void) {
  return seconds(CLOCK_MONOTONIC);
}
double timer_cpu_seconds(void) {
  return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

double timer_median(double *times, int n) {
  qsort(times, (size_t)n, sizeof *times, compare);
  return times[n / 2];
}
