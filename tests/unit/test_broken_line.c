/* Functions that are linear between points. */
#include "base/broken_line.h"
#include "suite.h"

static const double POINTS[][2] = {{0, 2}, {1, 4}, {3, 0}};
static const BrokenLine LINE = {POINTS, 3};

START_TEST(values_are_linear_between_the_points_and_constant_beyond) {
  const double t[] = {-1, 0, 0.25, 1, 2, 3, 10}, value[] = {2, 2, 2.5, 4, 2, 0, 0};
  for (int i = 0; i < 7; i++) ck_assert_double_eq(broken_line_value(LINE, t[i]), value[i]);
}
END_TEST

START_TEST(a_corner_belongs_to_the_piece_behind_it) {
  const double t[] = {0, 0.5, 1, 2, 3}, slope[] = {2, 2, -2, -2, -2};
  for (int i = 0; i < 5; i++) ck_assert_double_eq(broken_line_slope(LINE, t[i]), slope[i]);
}
END_TEST

START_TEST(the_next_corner_lies_behind_the_time_asked_for) {
  const double t[] = {-1, 0, 0.5, 1, 2.9, 3}, corner[] = {0, 1, 1, 3, 3, INFINITY};
  for (int i = 0; i < 6; i++) ck_assert_double_eq(broken_line_corner(LINE, t[i]), corner[i]);
}
END_TEST

START_TEST(one_point_is_a_constant_without_corners) {
  const BrokenLine constant = {POINTS, 1};
  ck_assert_double_eq(broken_line_value(constant, 5), 2);
  ck_assert_double_eq(broken_line_corner(constant, 0), INFINITY);
  ck_assert_double_eq(broken_line_corner((BrokenLine){0}, 0), INFINITY); /* nor has none at all */
}
END_TEST

int main(void) {
  return suite_run("broken_line", (SuiteTests){values_are_linear_between_the_points_and_constant_beyond,
                                               a_corner_belongs_to_the_piece_behind_it,
                                               the_next_corner_lies_behind_the_time_asked_for,
                                               one_point_is_a_constant_without_corners, NULL});
}
