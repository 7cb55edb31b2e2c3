/* table.csv as RFC 4180 has it. */
#include "base/array.h"
#include "study/table.h"
#include "study_file.h"
#include "suite.h"
#include <math.h>

/* Writes the table and gives what the file holds, cut to 4095 bytes. */
static const char *written(Table *table) {
  static char content[4096];
  Error error;
  Text text = {0};
  ck_assert_int_eq(table_write(table, scratch_folder, "table.csv"), STATUS_OK);
  ck_assert_int_eq(file_read(scratch_path("table.csv"), sizeof content, &text, &error), STATUS_OK);
  snprintf(content, sizeof content, "%s", text.data);
  text_free(&text);
  return content;
}

START_TEST(cells_with_commas_quotes_or_line_ends_are_quoted) {
  Table table;
  Error error;
  table_begin(&table, &error);
  table_text(&table, "plain");
  table_text(&table, "a, b");
  table_text(&table, "say \"no\"");
  table_text(&table, "two\nlines");
  table_text(&table, NULL);
  table_text(&table, "");
  table_end_row(&table);
  ck_assert_str_eq(written(&table), "plain,\"a, b\",\"say \"\"no\"\"\",\"two\nlines\",,\n");
}
END_TEST

START_TEST(numbers_are_as_short_as_they_read_back_and_no_number_is_an_empty_cell) {
  Table table;
  Error error;
  table_begin(&table, &error);
  table_component(&table, "rupture_X", "1");
  table_end_row(&table);
  table_number(&table, 0.1);
  table_number(&table, NAN);
  table_number(&table, 1.0 / 3.0);
  table_number(&table, INFINITY);
  table_end_row(&table);
  ck_assert_str_eq(written(&table), "rupture_X_1\n0.1,,0.3333333333333333,\n");
}
END_TEST

START_TEST(the_axes_of_a_point_stand_in_their_order) {
  Study study = study_that_varies("vary: {flow.capillary_number: [0.1, 0.2], time.end: [5, 6, 7]}\n");
  Table table;
  Error error;
  table_begin(&table, &error);
  table_axes_header(&table, &study);
  table_end_row(&table);
  for (size_t point = 2; point < 5; point++) {
    table_axes(&table, &study, point);
    table_end_row(&table);
  }
  ck_assert_str_eq(written(&table), "flow.capillary_number,time.end\n0.1,7\n0.2,5\n0.2,6\n");
  study_free(&study);
}
END_TEST

static int cells(const char *line) {
  int n = 1;
  for (; *line && *line != '\n'; line++) n += *line == ',';
  return n;
}

START_TEST(a_case_fills_the_columns_that_the_header_names) {
  char label[] = "Ca=1", reason[] = "no step is small enough";
  Case done = {.label = label,
               .state = CASE_DONE,
               .summary =
                   tree_of("{status: ruptured, t: 2.5, d_max: 1, rupture: {X: [1, 2, 3], x: [4, 5, 6], "
                           "angle_to_vorticity_deg: 90}}")};
  Case failed = {.label = label, .state = CASE_FAILED, .reason = reason}, waiting = {.label = label};
  Table table;
  Error error;
  table_begin(&table, &error);
  table_case_header(&table);
  table_end_row(&table);
  table_case(&table, &done);
  table_end_row(&table);
  table_case(&table, &failed);
  table_end_row(&table);
  table_case(&table, &waiting);
  table_end_row(&table);
  const char *header = written(&table), *first = strchr(header, '\n') + 1, *second = strchr(first, '\n') + 1,
             *third = strchr(second, '\n') + 1;
  ck_assert(strncmp(header, "case,status,t,", 14) == 0);
  ck_assert(strncmp(first, "Ca=1,ruptured,2.5,", 18) == 0 && strstr(first, ",1,2,3,4,5,6,90,,,\n"));
  ck_assert(strncmp(second, "Ca=1,failed,,", 13) == 0 && strstr(second, ",no step is small enough\n"));
  ck_assert(strncmp(third, "Ca=1,not run,,", 14) == 0);
  ck_assert_int_eq(cells(first), cells(header));
  ck_assert_int_eq(cells(second), cells(header));
  ck_assert_int_eq(cells(third), cells(header));
  yaml_tree_free(done.summary);
}
END_TEST

START_TEST(a_failure_on_the_way_is_told_at_the_end) {
  Table table;
  Error error;
  table_begin(&table, &error);
  array_fail_nth(1);
  table_text(&table, "lost");
  array_fail_nth(0);
  table_text(&table, "too late");
  ck_assert_int_eq(table_write(&table, scratch_folder, "table.csv"), STATUS_MEMORY);
  table_begin(&table, &error);
  table_text(&table, "kept");
  ck_assert_int_eq(table_write(&table, scratch_path("no/such/folder"), "table.csv"), STATUS_IO);
}
END_TEST

int main(void) {
  if (!scratch_make() || setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1) != 0) return 1;
  const int failed =
      suite_run("table", (SuiteTests){cells_with_commas_quotes_or_line_ends_are_quoted,
                                      numbers_are_as_short_as_they_read_back_and_no_number_is_an_empty_cell,
                                      the_axes_of_a_point_stand_in_their_order,
                                      a_case_fills_the_columns_that_the_header_names,
                                      a_failure_on_the_way_is_told_at_the_end, NULL});
  scratch_remove();
  return failed;
}
