/* Charts of a history: what is said of one that is not that of a run. */
#include "run/report_curves.h"

#include "study_file.h"
#include "suite.h"

static void expect_refused(const char *history, const char *words) {
  Text svg = {0};
  Error error = {.text = "nothing"};
  scratch_write("history.csv", history);
  ck_assert_int_eq(report_curves(scratch_folder, &svg, &error), STATUS_IO);
  expect_words(&error, words);
  text_free(&svg);
}

START_TEST(a_history_without_rows_or_columns_is_told) {
  expect_refused("", "/history.csv: expected rows of figures, found none");
  expect_refused("t,D12\n", "/history.csv: expected rows of figures, found none");
  expect_refused("D12\n0\n0.1\n", "/history.csv: expected a column t, found none");
  expect_refused("t,D12\n0,0\n1,0.1\n", "/history.csv: expected a column beta, found none");
  expect_refused("t,p\n0,0\n1,0.1\n", "/history.csv: expected a column alpha, found none");
}
END_TEST

START_TEST(every_column_of_a_flow_is_drawn) {
  Text svg = {0};
  Error error;
  scratch_write("history.csv", "t,D12,beta,L1,L2,L3,area_strain,d_max,elastic_energy,dissipated_energy\n"
                               "0,0,0.7,1,1,1,0,0,0,0\n1,0.1,0.6,1.1,1,0.9,0.01,0.1,0.2,0.1\n");
  const Status status = report_curves(scratch_folder, &svg, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  ck_assert_ptr_nonnull(strstr(svg.data, "Taylor deformation D12"));
  ck_assert_ptr_nonnull(strstr(svg.data, "largest damage"));
  ck_assert_ptr_null(strstr(svg.data, "nan"));
  text_free(&svg);
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  const int failed = suite_run("report_curves", (SuiteTests){a_history_without_rows_or_columns_is_told,
                                                             every_column_of_a_flow_is_drawn, NULL});
  scratch_remove();
  return failed;
}
