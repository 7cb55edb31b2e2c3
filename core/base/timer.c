#include "base/timer.h"

#include <math.h>
#include <stdio.h>
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

void timer_print(double time, char text[TIMER_TEXT]) {
  if (!(time >= 0 && time < 3.6e6)) {
    snprintf(text, TIMER_TEXT, "?");
    return;
  }
  const long s = lround(time);
  if (s >= 3600)
    snprintf(text, TIMER_TEXT, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
  else
    snprintf(text, TIMER_TEXT, "%ld:%02ld", s / 60, s % 60);
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

double timer_median(double *times, int n) {
  qsort(times, (size_t)n, sizeof *times, compare);
  return times[n / 2];
}
