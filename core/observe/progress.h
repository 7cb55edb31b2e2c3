/* The progress line of a run: redrawn in place on a terminal, one plain line per sample elsewhere, nothing
 * when quiet.  It writes to the stream it is given and decides nothing. */
#ifndef CAPSELLA_OBSERVE_PROGRESS_H
#define CAPSELLA_OBSERVE_PROGRESS_H

#include <stdbool.h>
#include <stdio.h>

typedef enum { PROGRESS_QUIET, PROGRESS_LINES, PROGRESS_REDRAW } ProgressMode;

typedef struct {
  FILE *stream;
  ProgressMode mode;
  double t_start, t_end;     /* of this process: a resumed run starts where its snapshot stands */
  double last_drawn_seconds; /* redrawing is held to ten times a second */
  int drawn_width;           /* columns on the terminal that the next line must cover */
} Progress;

typedef struct {
  double t;
  long long steps; /* accepted so far */
  double step;     /* size of the last one */
  double D12, d_max;
  double wall_seconds; /* since progress_start */
} ProgressState;

/* `stream` may be NULL (then quiet).  Picks the mode: REDRAW when the stream is a terminal. */
void progress_start(Progress *progress, FILE *stream, bool quiet, double t_start, double t_end);

/* After each accepted step; draws on a terminal only. */
void progress_step(Progress *progress, const ProgressState *state);

/* After each row of the history; a plain line elsewhere, as progress_step on a terminal. */
void progress_sample(Progress *progress, const ProgressState *state);

/* Clears the line on a terminal, so that a message can be printed; the next call draws it anew. */
void progress_clear(Progress *progress);

#endif
