#include "study/study_progress.h"

#include "base/timer.h"
#include <math.h>
#include <unistd.h>

enum { LINE_SIZE = 160 };
static const double REDRAW_SECONDS = 0.1;

void study_progress_start(StudyProgress *progress, FILE *stream, bool quiet, int jobs) {
  *progress = (StudyProgress){.stream = quiet ? NULL : stream, .jobs = jobs};
  progress->redraw = progress->stream && isatty(fileno(progress->stream));
}

/* Unknown before a case has been timed. */
static void print_left(const StudyProgress *progress, char text[TIMER_TEXT]) {
  const double each = progress->timed > 0 ? progress->seconds / (double)progress->timed : NAN;
  timer_print(each * (double)(progress->expected - progress->ended) / progress->jobs, text);
}

void study_progress_clear(StudyProgress *progress) {
  if (!progress->stream || progress->drawn_width == 0) return;
  fprintf(progress->stream, "\r%*s\r", progress->drawn_width, "");
  fflush(progress->stream);
  progress->drawn_width = 0;
}

void study_progress_ended(StudyProgress *progress, const ProgressCase *item) {
  char left[TIMER_TEXT];
  progress->ended++;
  progress->failed += item->reason != NULL;
  if (item->seconds > 0) {
    progress->timed++;
    progress->seconds += item->seconds;
  }
  if (!progress->stream || progress->redraw) return;
  print_left(progress, left);
  fprintf(progress->stream, "case %ld of %ld: %s: %s%s%s", progress->ended, progress->expected, item->label,
          item->outcome, item->reason ? ": " : "", item->reason ? item->reason : "");
  if (item->seconds > 0)
    fprintf(progress->stream, " (%.3g s; left %s)\n", item->seconds, left);
  else
    fprintf(progress->stream, " (known)\n");
  fflush(progress->stream);
}

void study_progress_show(StudyProgress *progress, int running) {
  char line[LINE_SIZE], left[TIMER_TEXT];
  const double now = timer_wall_seconds();
  if (!progress->redraw || now - progress->last_drawn < REDRAW_SECONDS) return;
  print_left(progress, left);
  snprintf(line, sizeof line, "%ld of %ld cases  %d running  %ld failed  left %s", progress->ended,
           progress->expected, running, progress->failed, left);
  const int width = fprintf(progress->stream, "\r%-*s", progress->drawn_width, line);
  fflush(progress->stream);
  progress->drawn_width = width > 0 ? width - 1 : 0;
  progress->last_drawn = now;
}
