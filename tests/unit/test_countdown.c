/* The line of a job of known size: what it says, and that it is drawn on a terminal alone. */
#define _XOPEN_SOURCE 700 /* a pseudo terminal */

#include "observe/countdown.h"

#include "base/timer.h"
#include "suite.h"
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

START_TEST(a_stream_that_is_no_terminal_gets_nothing) {
  FILE *stream = tmpfile();
  Countdown countdown;
  countdown_start(&countdown, stream);
  countdown_show(&countdown, 1, 2, "half");
  countdown_clear(&countdown);
  ck_assert_int_eq(ftell(stream), 0);
  fclose(stream);
}
END_TEST

/* What the terminal has been sent. */
static const char *received(int terminal, size_t length) {
  static char buffer[1024];
  size_t have = 0;
  while (have < length) {
    const ssize_t count = read(terminal, buffer + have, sizeof buffer - 1 - have);
    ck_assert_int_gt(count, 0);
    have += (size_t)count;
  }
  buffer[have] = '\0';
  return buffer;
}

START_TEST(a_terminal_is_told_share_time_left_and_what_is_next_at_most_ten_times_a_second) {
  static const char FIRST[] = "  0 %  left ?  first of four, of which nobody knows";
  static const char SECOND[] = " 25 %  left 0:30  third of four";
  char expected[256];
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  ck_assert(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
  FILE *stream = fopen(ptsname(terminal), "r+");
  Countdown countdown;
  countdown_start(&countdown, stream);
  countdown_show(&countdown, 0, 4, "first of four, of which nobody knows");
  countdown_show(&countdown, 0, 4, "too soon after the last");
  countdown.started = timer_wall_seconds() - 10; /* a quarter in 10 s: the rest in 30 */
  countdown.last_drawn = countdown.started;
  countdown_show(&countdown, 1, 4, "third of four");
  countdown_show(&countdown, 2, 4, "too soon, too");
  countdown_clear(&countdown);
  snprintf(expected, sizeof expected, "\r%s\r%-*s\r%*s\r", FIRST, (int)strlen(FIRST), SECOND,
           (int)strlen(FIRST), "");
  ck_assert_str_eq(received(terminal, strlen(expected)), expected);
  countdown_clear(&countdown); /* nothing is there to be cleared: this must not block the end */
  fclose(stream);
  close(terminal);
}
END_TEST

int main(void) {
  return suite_run(
      "countdown",
      (SuiteTests){a_stream_that_is_no_terminal_gets_nothing,
                   a_terminal_is_told_share_time_left_and_what_is_next_at_most_ten_times_a_second, NULL});
}
