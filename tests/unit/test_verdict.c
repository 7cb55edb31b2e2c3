/* What criteria say, as a table and as JSON: the same figures, and nothing where nothing is known. */
#include "observe/verdict.h"

#include "base/file.h"
#include "scratch.h"
#include "suite.h"
#include <math.h>

static const Verdict VERDICTS[] = {
    {"one",
     "marigo",
     {.t_c = 1.5,
      .t_l = 2.25,
      .d_max = 1,
      .t = 2.25,
      .site = {{0, 1, 0}, {0, 1.25, 0}, 0, 90},
      .damaged_area_fraction = 0.5,
      .thickness_min = 0.75,
      .T1_max = 1.25}},
    {"two", "acme.other", {.t_c = NAN, .t_l = NAN, .d_max = 0, .t = 10, .thickness_min = 0.7, .T1_max = 1.5}},
};

START_TEST(the_table_has_a_row_for_each_criterion_with_as_many_cells_as_the_header) {
  Error error;
  Text text = {0};
  const char *path = scratch_path("criteria.csv");
  ck_assert_int_eq(verdicts_write(VERDICTS, 2, path, &error), STATUS_OK);
  ck_assert_int_eq(file_read(path, 1 << 16, &text, &error), STATUS_OK);
  int lines = 0, commas[3] = {0};
  for (const char *at = text.data; *at; at++) {
    if (*at == '\n') lines++;
    if (*at == ',') commas[lines]++;
  }
  ck_assert_int_eq(lines, 3);
  ck_assert_int_eq(commas[1], commas[0]);
  ck_assert_int_eq(commas[2], commas[0]);
  ck_assert_ptr_nonnull(
      strstr(text.data, "\none,marigo,ruptured,1.5,2.25,1,2.25,0,1,0,0,1.25,0,0,90,0.5,0.75,"));
  ck_assert_ptr_nonnull(
      strstr(text.data, "\ntwo,acme.other,whole,nan,nan,0,10,nan,nan,nan,nan,nan,nan,nan,nan,0,0.7,"));
  text_free(&text);
}
END_TEST

START_TEST(json_has_null_for_what_did_not_happen) {
  Error error;
  Text text = {0};
  Json json;
  json_begin(&json, &text, &error);
  json_open_object(&json, NULL);
  verdicts_print_json(VERDICTS, 2, &json);
  json_close(&json);
  ck_assert_int_eq(json_end(&json), STATUS_OK);
  const char *second = strstr(text.data, "\"name\": \"two\"");
  ck_assert_ptr_nonnull(second);
  ck_assert_ptr_nonnull(strstr(second, "\"t_c\": null"));
  ck_assert_ptr_nonnull(strstr(second, "\"site\": null"));
  ck_assert_ptr_nonnull(strstr(text.data, "\"t_l\": 2.25"));
  ck_assert_ptr_nonnull(strstr(text.data, "\"thickness\": 0.75"));
  text_free(&text);
}
END_TEST

START_TEST(damage_that_stays_below_one_is_called_so) {
  ck_assert_str_eq(verdict_name(&(Finding){.t_c = 1, .t_l = NAN}), "damaged");
}
END_TEST

int main(void) {
  if (!scratch_make()) return 1;
  const int failed = suite_run(
      "verdict",
      (SuiteTests){the_table_has_a_row_for_each_criterion_with_as_many_cells_as_the_header,
                   json_has_null_for_what_did_not_happen, damage_that_stays_below_one_is_called_so, NULL});
  scratch_remove();
  return failed;
}
