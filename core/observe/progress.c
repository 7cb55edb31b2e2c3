/* One line of at most 80 columns; how it is drawn depends on what the stream is. */
#include "observe/progress.h"

#include "base/timer.h"
#include <math.h>
#include <unistd.h>

enum { LINE_SIZE = 192, FIGURE_SIZE = 24 };
static const double REDRAW_SECONDS = 0.1;

void progress_start(Progress *progress, FILE *stream, bool quiet, double t_start, double t_end) {
  *progress =
      (Progress){.stream = stream, .t_start = t_start, .t_end = t_end, .last_drawn_seconds = -HUGE_VAL};
  if (quiet || !stream)
    progress->mode = PROGRESS_QUIET;
  else
    progress->mode = isatty(fileno(stream)) ? PROGRESS_REDRAW : PROGRESS_LINES;
}

/* Four decimals, or "-" where there is no figure. */
static void print_figure(double value, char text[FIGURE_SIZE]) {
  snprintf(text, FIGURE_SIZE, isfinite(value) ? "%.4f" : "-", value);
}

static void print_line(const Progress *progress, const ProgressState *state, char line[LINE_SIZE]) {
  const double elapsed = state->wall_seconds;
  const double rate = elapsed > 0 ? (state->t - progress->t_start) / elapsed : 0; /* time units per second */
  char D12[FIGURE_SIZE], d_max[FIGURE_SIZE], left[TIMER_TEXT];
  print_figure(state->D12, D12);
  print_figure(state->d_max, d_max);
  timer_print((progress->t_end - state->t) / rate, left);
  snprintf(line, LINE_SIZE, "t %.4g/%g  step %lld (%.2g)  D12 %s  d_max %s  %.3g/s  left %s", state->t,
           progress->t_end, state->steps, state->step, D12, d_max, rate, left);
}

static void redraw(Progress *progress, const ProgressState *state) {
  char line[LINE_SIZE];
  print_line(progress, state, line);
  int width = fprintf(progress->stream, "\r%-*s", progress->drawn_width, line);
  fflush(progress->stream);
  progress->drawn_width = width > 0 ? width - 1 : 0;
  progress->last_drawn_seconds = state->wall_seconds;
}

void progress_step(Progress *progress, const ProgressState *state) {
  bool is_due = state->wall_seconds - progress->last_drawn_seconds >= REDRAW_SECONDS;
  if (progress->mode == PROGRESS_REDRAW && is_due) redraw(progress, state);
}

void progress_sample(Progress *progress, const ProgressState *state) {
  if (progress->mode == PROGRESS_LINES) {
    char line[LINE_SIZE];
    print_line(progress, state, line);
    fprintf(progress->stream, "%s\n", line);
    fflush(progress->stream);
  }
  progress_step(progress, state);
}

void progress_clear(Progress *progress) {
  if (progress->mode != PROGRESS_REDRAW || progress->drawn_width == 0) return;
  fprintf(progress->stream, "\r%*s\r", progress->drawn_width, "");
  fflush(progress->stream);
  progress->drawn_width = 0;
}
