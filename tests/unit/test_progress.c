/* The progress line: what it says, and that it is drawn only where it belongs. */
#define _XOPEN_SOURCE 700 /* a pseudo terminal */

#include "observe/progress.h"

#include "suite.h"
#include <fcntl.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

static const ProgressState HALFWAY = {
    .t = 5, .steps = 100, .step = 0.05, .D12 = 0.4321, .d_max = 0.1134, .wall_seconds = 20};
static const char HALFWAY_LINE[] = "t 5/10  step 100 (0.05)  D12 0.4321  d_max 0.1134  0.25/s  left 0:20";

static char buffer[4096];

/* What was written to a stream that is no terminal. */
static const char *content(FILE *stream) {
  rewind(stream);
  buffer[fread(buffer, 1, sizeof buffer - 1, stream)] = '\0';
  return buffer;
}

START_TEST(a_pipe_gets_one_plain_line_per_sample_and_none_per_step) {
  FILE *stream = tmpfile();
  Progress progress;
  progress_start(&progress, stream, false, 0, 10);
  progress_step(&progress, &HALFWAY);
  progress_sample(&progress, &HALFWAY);
  progress_step(&progress, &HALFWAY);
  progress_clear(&progress);
  char expected[256];
  snprintf(expected, sizeof expected, "%s\n", HALFWAY_LINE);
  ck_assert_str_eq(content(stream), expected);
  fclose(stream);
}
END_TEST

START_TEST(quiet_and_no_stream_write_nothing) {
  FILE *stream = tmpfile();
  Progress progress;
  progress_start(&progress, stream, true, 0, 10);
  progress_sample(&progress, &HALFWAY);
  ck_assert_str_eq(content(stream), "");
  progress_start(&progress, NULL, false, 0, 10);
  progress_sample(&progress, &HALFWAY);
  progress_clear(&progress);
  fclose(stream);
}
END_TEST

/* What a pseudo terminal was sent may arrive in parts: reads until `length` bytes are there. */
static void read_terminal(int terminal, size_t length) {
  size_t have = 0;
  while (have < length) {
    const ssize_t count = read(terminal, buffer + have, sizeof buffer - 1 - have);
    ck_assert_int_gt(count, 0);
    have += (size_t)count;
  }
  buffer[have] = '\0';
}

START_TEST(a_terminal_is_redrawn_in_place_at_most_ten_times_a_second) {
  int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  ck_assert(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
  FILE *stream = fopen(ptsname(terminal), "r+");
  ck_assert_ptr_nonnull(stream);
  Progress progress;
  progress_start(&progress, stream, false, 0, 10);
  ProgressState state = HALFWAY;
  progress_step(&progress, &state);
  for (int k = 0; k < 9; k++) { /* 0.09 s in all: nothing is due */
    state.wall_seconds += 0.01;
    progress_step(&progress, &state);
    progress_sample(&progress, &state);
  }
  progress_clear(&progress);
  char expected[512];
  const int width = (int)strlen(HALFWAY_LINE);
  snprintf(expected, sizeof expected, "\r%s\r%*s\r", HALFWAY_LINE, width, "");
  read_terminal(terminal, strlen(expected));
  ck_assert_str_eq(buffer, expected);
  fclose(stream);
  close(terminal);
}
END_TEST

START_TEST(a_shorter_line_covers_a_longer_one) {
  FILE *stream = tmpfile();
  Progress progress;
  progress_start(&progress, stream, false, 0, 10);
  progress.mode = PROGRESS_REDRAW;
  progress_step(&progress, &HALFWAY);
  ProgressState shorter = HALFWAY;
  shorter.steps = 1;
  shorter.wall_seconds = 40;
  progress_step(&progress, &shorter);
  const char *second = strrchr(content(stream), '\r') + 1;
  ck_assert_uint_eq(strlen(second), strlen(HALFWAY_LINE));
  fclose(stream);
}
END_TEST

START_TEST(a_resumed_run_counts_from_where_it_stands) {
  FILE *stream = tmpfile();
  Progress progress;
  progress_start(&progress, stream, false, 4, 10);
  progress_sample(&progress, &HALFWAY); /* one time unit in 20 s: five more take 100 s */
  ck_assert_ptr_nonnull(strstr(content(stream), "0.05/s  left 1:40\n"));
  fclose(stream);
}
END_TEST

START_TEST(long_and_unknown_times_are_legible) {
  FILE *stream = tmpfile();
  Progress progress;
  progress_start(&progress, stream, false, 0, 10);
  ProgressState state = HALFWAY;
  state.wall_seconds = 3600 * 25 + 61;
  progress_sample(&progress, &state);
  ck_assert_ptr_nonnull(strstr(content(stream), "left 25:01:01\n"));
  progress_sample(&progress, &(ProgressState){.D12 = NAN, .d_max = NAN}); /* nothing has happened yet */
  ck_assert_ptr_nonnull(strstr(content(stream), "D12 -  d_max -  0/s  left ?\n"));
  fclose(stream);
}
END_TEST

int main(void) {
  return suite_run("progress",
                   (SuiteTests){a_pipe_gets_one_plain_line_per_sample_and_none_per_step,
                                quiet_and_no_stream_write_nothing,
                                a_terminal_is_redrawn_in_place_at_most_ten_times_a_second,
                                a_shorter_line_covers_a_longer_one, a_resumed_run_counts_from_where_it_stands,
                                long_and_unknown_times_are_legible, NULL});
}
