/* Seconds for reports; never used to decide anything. */
#ifndef CAPSELLA_BASE_TIMER_H
#define CAPSELLA_BASE_TIMER_H

double timer_wall_seconds(void); /* monotonic, from an arbitrary start */
double timer_cpu_seconds(void);  /* of this process, all threads */

/* The median of n > 0 measured times, which it sorts. */
double timer_median(double *times, int n);

#endif
