/* Errors: codes, messages, context in front, and what happens when a message is too long. */
#include "base/status.h"
#include "suite.h"
#include <stdlib.h>
#include <string.h>

START_TEST(error_keeps_code_and_message) {
  Error error;
  ck_assert_int_eq(error_set(&error, STATUS_INPUT, "expected %d, found %s", 3, "four"), STATUS_INPUT);
  ck_assert_int_eq(error.code, STATUS_INPUT);
  ck_assert_str_eq(error.text, "expected 3, found four");
}
END_TEST

START_TEST(prefix_goes_in_front_and_keeps_the_code) {
  Error error;
  error_set(&error, STATUS_IO, "no such file");
  ck_assert_int_eq(error_prefix(&error, "%s:%d: ", "scene.yaml", 7), STATUS_IO);
  ck_assert_str_eq(error.text, "scene.yaml:7: no such file");
}
END_TEST

START_TEST(long_messages_are_cut_and_still_end) {
  Error error;
  char words[2 * sizeof error.text];
  memset(words, 'x', sizeof words - 1);
  words[sizeof words - 1] = '\0';
  error_set(&error, STATUS_FAILED, "%s", words);
  ck_assert_uint_eq(strlen(error.text), sizeof error.text - 1);
  error_prefix(&error, "where: ");
  ck_assert_uint_eq(strlen(error.text), sizeof error.text - 1);
  ck_assert_mem_eq(error.text, "where: xxx", 10);
  error_prefix(&error, "%s", words);
  ck_assert_uint_eq(strlen(error.text), sizeof error.text - 1);
}
END_TEST

static Status three_steps(int failing, int *done, Error *error) {
  Status status = STATUS_OK;
  for (int step = 0; step < 3; step++) {
    TRY(step == failing ? error_set(error, STATUS_FAILED, "step %d", step) : STATUS_OK);
    ++*done;
  }
cleanup:
  return status;
}

START_TEST(try_leaves_at_the_first_failure) {
  Error error;
  int done = 0;
  ck_assert_int_eq(three_steps(1, &done, &error), STATUS_FAILED);
  ck_assert_int_eq(done, 1);
  ck_assert_str_eq(error.text, "step 1");
  done = 0;
  ck_assert_int_eq(three_steps(-1, &done, &error), STATUS_OK);
  ck_assert_int_eq(done, 3);
}
END_TEST

int main(void) {
  return suite_run("status",
                   (SuiteTests){error_keeps_code_and_message, prefix_goes_in_front_and_keeps_the_code,
                                long_messages_are_cut_and_still_end, try_leaves_at_the_first_failure, NULL});
}
