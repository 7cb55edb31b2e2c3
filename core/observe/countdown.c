#include "observe/countdown.h"

#include "base/timer.h"
#include <math.h>
#include <unistd.h>

static const double REDRAW_SECONDS = 0.1;

void countdown_start(Countdown *countdown, FILE *stream) {
  *countdown = (Countdown){.stream = isatty(fileno(stream)) ? stream : NULL,
                           .started = timer_wall_seconds(),
                           .last_drawn = -HUGE_VAL};
}

void countdown_show(Countdown *countdown, double done, double total, const char *what) {
  const double now = timer_wall_seconds();
  if (!countdown->stream || now - countdown->last_drawn < REDRAW_SECONDS) return;
  char line[80], left[TIMER_TEXT];
  timer_print(done > 0 ? (now - countdown->started) * (total - done) / done : NAN, left);
  snprintf(line, sizeof line, "%3.0f %%  left %s  %s", 100 * done / total, left, what);
  const int width = fprintf(countdown->stream, "\r%-*s", countdown->drawn_width, line);
  fflush(countdown->stream);
  countdown->drawn_width = width > 0 ? width - 1 : 0;
  countdown->last_drawn = now;
}

void countdown_clear(Countdown *countdown) {
  if (!countdown->stream || countdown->drawn_width == 0) return;
  fprintf(countdown->stream, "\r%*s\r", countdown->drawn_width, "");
  fflush(countdown->stream);
  countdown->drawn_width = 0;
}
