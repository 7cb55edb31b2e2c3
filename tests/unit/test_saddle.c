/* Quadratic forms under linear conditions, against solutions by hand. */
#include "linalg/saddle.h"

#include "suite.h"
#include <string.h>

START_TEST(the_nearest_point_of_a_plane_is_found) {
  /* x + 2 y + 2 z = 9 is 3 away from the origin, at (1, 2, 2). */
  const double H[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, plane[3] = {1, 2, 2}, g[3] = {0, 0, 0}, nine = 9;
  double x[3];
  Error error;
  ck_assert_int_eq(saddle_solve(3, 1, H, plane, g, &nine, x, &error), STATUS_OK);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(x[i], plane[i], 1e-14);
}
END_TEST

START_TEST(two_conditions_and_a_slope) {
  /* x^2 + x y + y^2 + z^2 - 3 z with x + y = 2 and x - z = 0: y = 2 - x, z = x leave 2 x^2 - 5 x + 4, least
   * at x = 5/4. */
  const double H[9] = {2, 1, 0, 1, 2, 0, 0, 0, 2}, B[6] = {1, 1, 0, 1, 0, -1}, g[3] = {0, 0, 3},
               d[2] = {2, 0};
  double x[3];
  Error error;
  ck_assert_int_eq(saddle_solve(3, 2, H, B, g, d, x, &error), STATUS_OK);
  ck_assert_double_eq_tol(x[0], 1.25, 1e-14);
  ck_assert_double_eq_tol(x[1], 0.75, 1e-14);
  ck_assert_double_eq_tol(x[2], 1.25, 1e-14);
}
END_TEST

START_TEST(conditions_that_say_the_same_twice_are_refused) {
  const double H[4] = {1, 0, 0, 1}, B[4] = {0, 0, 1, 1}, g[2] = {0, 0}, d[2] = {0, 1};
  double x[2];
  Error error;
  ck_assert_int_eq(saddle_solve(2, 2, H, B, g, d, x, &error), STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "dsysv"));
}
END_TEST

int main(void) {
  return suite_run("saddle", (SuiteTests){the_nearest_point_of_a_plane_is_found, two_conditions_and_a_slope,
                                          conditions_that_say_the_same_twice_are_refused, NULL});
}
