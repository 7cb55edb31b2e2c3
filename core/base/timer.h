/* Seconds for reports; never used to decide anything. */
#ifndef CAPSELLA_BASE_TIMER_H
#define CAPSELLA_BASE_TIMER_H

double timer_wall_seconds(void); /* monotonic, from an arbitrary start */
double timer_cpu_seconds(void);  /* of this process, all threads */

/* "1:05" or "2:00:00"; "?" for what is not a time, or beyond all patience. */
enum { TIMER_TEXT = 24 };
void timer_print(double seconds, char text[TIMER_TEXT]);

/* The median of n > 0 measured times, which it sorts. */
double timer_median(double *times, int n);

#endif
