/* Columns of numbers: found by their names, wherever they stand. */
#include "observe/columns.h"

#include "scratch.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>

static const char *write_table(const char *text) {
  const char *path = scratch_path("table.csv");
  FILE *file = fopen(path, "w");
  ck_assert_ptr_nonnull(file);
  fputs(text, file);
  ck_assert_int_eq(fclose(file), 0);
  return path;
}

START_TEST(columns_come_in_the_order_asked_for) {
  Columns columns;
  Error error;
  const char *path = write_table("t,d_max,d\n0,0.25,-1e-3\n0.5,nan,2\n");
  ck_assert_int_eq(columns_read(&columns, path, (const char *[]){"d", "t", "d_max"}, 3, &error), STATUS_OK);
  ck_assert_uint_eq(columns.n_rows, 2);
  const double expected[3][2] = {{-1e-3, 2}, {0, 0.5}, {0.25, NAN}};
  for (int k = 0; k < 3; k++)
    for (int row = 0; row < 2; row++)
      if (isnan(expected[k][row]))
        ck_assert_double_nan(columns.values[k][row]);
      else
        ck_assert_double_eq(columns.values[k][row], expected[k][row]);
  columns_free(&columns);
}
END_TEST

START_TEST(a_row_without_its_end_is_left_out_and_a_missing_cell_is_no_number) {
  Columns columns;
  Error error;
  const char *path = write_table("t,d\n0,1\n1\n2,x\n3,4");
  ck_assert_int_eq(columns_read(&columns, path, (const char *[]){"d"}, 1, &error), STATUS_OK);
  ck_assert_uint_eq(columns.n_rows, 3);
  ck_assert_double_eq(columns.values[0][0], 1);
  ck_assert_double_nan(columns.values[0][1]);
  ck_assert_double_nan(columns.values[0][2]);
  columns_free(&columns);
}
END_TEST

START_TEST(a_column_that_is_not_there_is_named) {
  static const char *const tables[] = {"t,d_max\n0,1\n", "t", ""};
  for (int k = 0; k < 3; k++) {
    Columns columns;
    Error error;
    const char *path = write_table(tables[k]);
    ck_assert_int_eq(columns_read(&columns, path, (const char *[]){"d"}, 1, &error), STATUS_INPUT);
    ck_assert_ptr_nonnull(strstr(error.text, "`d`"));
    ck_assert_ptr_null(columns.values);
  }
}
END_TEST

START_TEST(a_missing_file_is_named) {
  Columns columns;
  Error error;
  ck_assert_int_eq(columns_read(&columns, scratch_path("none.csv"), (const char *[]){"d"}, 1, &error),
                   STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "none.csv"));
}
END_TEST

int main(void) {
  if (!scratch_make()) return 1;
  const int code =
      suite_run("columns", (SuiteTests){columns_come_in_the_order_asked_for,
                                        a_row_without_its_end_is_left_out_and_a_missing_cell_is_no_number,
                                        a_column_that_is_not_there_is_named, a_missing_file_is_named, NULL});
  scratch_remove();
  return code;
}
