/* Places in front of messages. */
#include "config/place.h"
#include "suite.h"

START_TEST(a_place_is_file_line_and_column) {
  Error error;
  const SourcePlace place = {"scene.yaml", 3, 5};
  ck_assert_int_eq(place_error(&place, &error, "expected %d, found %d", 1, 2), STATUS_INPUT);
  ck_assert_str_eq(error.text, "scene.yaml:3:5: expected 1, found 2");
}
END_TEST

START_TEST(a_setting_has_no_line) {
  Error error;
  const SourcePlace place = {"--set a=b", 0, 0};
  place_error(&place, &error, "100 %% wrong");
  ck_assert_str_eq(error.text, "--set a=b: 100 % wrong");
}
END_TEST

START_TEST(a_message_that_is_there_keeps_its_code) {
  Error error;
  const SourcePlace place = {"scene.yaml", 3, 5}, unknown = {0};
  error_set(&error, STATUS_FAILED, "no");
  ck_assert_int_eq(place_prefix(&unknown, &error), STATUS_FAILED);
  ck_assert_str_eq(error.text, "no");
  ck_assert_int_eq(place_prefix(&place, &error), STATUS_FAILED);
  ck_assert_str_eq(error.text, "scene.yaml:3:5: no");
}
END_TEST

int main(void) {
  return suite_run("place", (SuiteTests){a_place_is_file_line_and_column, a_setting_has_no_line,
                                         a_message_that_is_there_keeps_its_code, NULL});
}
