/* The progress of a study: one line redrawn on a terminal, one plain line for each case that has ended
 * elsewhere, nothing when quiet. */
#ifndef CAPSELLA_STUDY_STUDY_PROGRESS_H
#define CAPSELLA_STUDY_STUDY_PROGRESS_H

#include <stdbool.h>
#include <stdio.h>

typedef struct {
  FILE *stream; /* NULL: quiet */
  bool redraw;
  int jobs;
  long expected, ended, failed; /* cases */
  long timed;                   /* of those ended, by a process of this study */
  double seconds;               /* that they took together */
  double last_drawn;
  int drawn_width;
} StudyProgress;

void study_progress_start(StudyProgress *progress, FILE *stream, bool quiet, int jobs);

typedef struct {
  const char *label, *outcome, *reason; /* reason: NULL or of a failure */
  double seconds;                       /* 0: taken over from disk */
} ProgressCase;

/* A case has ended. */
void study_progress_ended(StudyProgress *progress, const ProgressCase *item);

/* `running` cases are under way: redraws on a terminal, at most ten times a second. */
void study_progress_show(StudyProgress *progress, int running);

void study_progress_clear(StudyProgress *progress);

#endif
