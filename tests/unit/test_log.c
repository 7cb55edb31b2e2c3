/* The log of a run: a line is in the file at once, warnings are counted, no log is allowed. */
#include "base/file.h"
#include "base/log.h"
#include "suite.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static void expect_content(const char *path, const char *content) {
  Error error;
  Text text = {0};
  ck_assert_int_eq(file_read(path, 1000, &text, &error), STATUS_OK);
  ck_assert_str_eq(text.data, content);
  text_free(&text);
}

START_TEST(lines_are_in_the_file_before_it_is_closed) {
  char path[] = "/tmp/capsella-log-XXXXXX";
  close(mkstemp(path));
  Error error;
  Log log;
  ck_assert_int_eq(log_open(&log, path, true, &error), STATUS_OK);
  log_note(&log, "mesh: %d elements", 1280);
  log_warning(&log, "Y_D is %g", 0.5);
  expect_content(path, "mesh: 1280 elements\nwarning: Y_D is 0.5\n");
  ck_assert_int_eq(log.warnings, 1);
  log_close(&log);

  ck_assert_int_eq(log_open(&log, path, true, &error), STATUS_OK);
  log_note(&log, "resumed");
  log_close(&log);
  expect_content(path, "mesh: 1280 elements\nwarning: Y_D is 0.5\nresumed\n");
  remove(path);
}
END_TEST

START_TEST(a_new_run_keeps_its_own_lines_only) {
  char path[] = "/tmp/capsella-log-XXXXXX";
  close(mkstemp(path));
  Error error;
  Log log;
  ck_assert_int_eq(log_open(&log, path, true, &error), STATUS_OK);
  log_note(&log, "an earlier run");
  log_close(&log);
  ck_assert_int_eq(log_open(&log, path, true, &error), STATUS_OK);
  log_note(&log, "a new one");
  log_drop_earlier(&log);
  log_note(&log, "goes on");
  expect_content(path, "a new one\ngoes on\n");
  log_drop_earlier(&log);
  log_close(&log);
  expect_content(path, "a new one\ngoes on\n");
  log_drop_earlier(NULL);
  remove(path);
}
END_TEST

/* In a child: a process does not lock itself out. */
static int open_in_child(const char *path) {
  const pid_t child = fork();
  if (child == 0) {
    Error error;
    Log log;
    const Status status = log_open(&log, path, true, &error);
    _exit(status == STATUS_IO && strstr(error.text, "another run") ? 3 : status == STATUS_OK ? 0 : 1);
  }
  int status = 0;
  ck_assert_int_eq(waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

START_TEST(the_log_of_a_run_that_goes_on_is_taken) {
  char path[] = "/tmp/capsella-log-XXXXXX";
  close(mkstemp(path));
  Error error;
  Log log;
  ck_assert_int_eq(log_open(&log, path, true, &error), STATUS_OK);
  ck_assert_int_eq(open_in_child(path), 3);
  log_close(&log);
  ck_assert_int_eq(open_in_child(path), 0);
  remove(path);
}
END_TEST

START_TEST(a_missing_log_swallows_the_line) {
  log_note(NULL, "nothing");
  log_warning(NULL, "nothing");
  log_close(NULL);
  Log nowhere = {.quiet = true};
  log_note(&nowhere, "nothing");
  log_warning(&nowhere, "counted");
  ck_assert_int_eq(nowhere.warnings, 1);
}
END_TEST

START_TEST(a_log_that_cannot_be_opened_is_an_error) {
  Error error;
  Log log;
  ck_assert_int_eq(log_open(&log, "/no/such/folder/log.txt", true, &error), STATUS_IO);
  log_note(&log, "swallowed");
}
END_TEST

int main(void) {
  return suite_run("log",
                   (SuiteTests){lines_are_in_the_file_before_it_is_closed, a_missing_log_swallows_the_line,
                                a_log_that_cannot_be_opened_is_an_error, a_new_run_keeps_its_own_lines_only,
                                the_log_of_a_run_that_goes_on_is_taken, NULL});
}
