/* How far a job of known size is, and how long the rest will take: one line, redrawn in place on a terminal
 * and left out elsewhere. */
#ifndef CAPSELLA_OBSERVE_COUNTDOWN_H
#define CAPSELLA_OBSERVE_COUNTDOWN_H

#include <stdio.h>

typedef struct {
  FILE *stream; /* NULL: no terminal */
  double started, last_drawn;
  int drawn_width;
} Countdown;

/* Nothing is drawn unless the stream is a terminal. */
void countdown_start(Countdown *countdown, FILE *stream);

/* `done` of `total` have been done and `what` is next: redraws, at most ten times a second. */
void countdown_show(Countdown *countdown, double done, double total, const char *what);

/* Clears the line, so that something can be printed. */
void countdown_clear(Countdown *countdown);

#endif
