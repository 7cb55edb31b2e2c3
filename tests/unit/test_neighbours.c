/* Levels of points, and what is expected from points of lower levels. */
#include "study/neighbours.h"
#include "suite.h"
#include <math.h>

enum { N_X = 8, N_Y = 3, N_Z = 2 };

static double x[N_X] = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4}, y[N_Y] = {1, 2, 3}, z[N_Z] = {NAN, NAN};

/* Two numeric axes and one of names between them. */
static Axis axes[3] = {{.numbers = y, .n = N_Y, .is_numeric = true},
                       {.numbers = z, .n = N_Z},
                       {.numbers = x, .n = N_X, .is_numeric = true}};
static const Study study = {.axes = axes, .n_axes = 3, .n_points = N_X * N_Y * N_Z};

static size_t point(int iy, int iz, int ix) {
  return (size_t)((iy * N_Z + iz) * N_X + ix);
}

START_TEST(corners_come_first_then_middles) {
  static const int along_x[N_X] = {0, 2, 3, 1, 3, 2, 3, 0}, along_y[N_Y] = {0, 1, 0};
  for (int i = 0; i < N_X; i++)
    for (int j = 0; j < N_Y; j++)
      for (int k = 0; k < N_Z; k++)
        ck_assert_int_eq(neighbours_level(&study, point(j, k, i)),
                         along_x[i] > along_y[j] ? along_x[i] : along_y[j]);
}
END_TEST

START_TEST(points_lean_on_lower_levels_of_the_same_name) {
  ck_assert(neighbours_lean(&study, point(1, 0, 3), point(0, 0, 0)));
  ck_assert(!neighbours_lean(&study, point(0, 0, 0), point(1, 0, 3)));
  ck_assert(!neighbours_lean(&study, point(1, 0, 3), point(0, 1, 0)));
  ck_assert(!neighbours_lean(&study, point(0, 0, 0), point(0, 0, 7)));
}
END_TEST

START_TEST(a_plane_is_expected_exactly) {
  double values[N_X * N_Y * N_Z];
  for (int i = 0; i < N_X; i++)
    for (int j = 0; j < N_Y; j++)
      for (int k = 0; k < N_Z; k++) values[point(j, k, i)] = 1 + 10 * k + 2 * x[i] - 0.3 * y[j];
  for (size_t p = 0; p < study.n_points; p++) {
    const double expected = neighbours_expect(&study, p, values);
    if (neighbours_level(&study, p) == 0)
      ck_assert(isnan(expected));
    else
      ck_assert_double_eq_tol(expected, values[p], 1e-6); /* weights of 1e8 to 1 in the fit */
  }
}
END_TEST

START_TEST(one_known_point_is_expected_everywhere_above_it) {
  double values[N_X * N_Y * N_Z];
  for (size_t p = 0; p < study.n_points; p++) values[p] = NAN;
  values[point(2, 1, 7)] = 0.9;
  ck_assert_double_eq_tol(neighbours_expect(&study, point(1, 1, 4), values), 0.9, 1e-12);
  ck_assert(isnan(neighbours_expect(&study, point(1, 0, 4), values)));
}
END_TEST

START_TEST(a_study_without_axes_has_one_point_of_level_0) {
  const Study single = {.n_points = 1};
  ck_assert_int_eq(neighbours_level(&single, 0), 0);
  ck_assert(isnan(neighbours_expect(&single, 0, (double[]){NAN})));
}
END_TEST

int main(void) {
  return suite_run("neighbours",
                   (SuiteTests){corners_come_first_then_middles, points_lean_on_lower_levels_of_the_same_name,
                                a_plane_is_expected_exactly, one_known_point_is_expected_everywhere_above_it,
                                a_study_without_axes_has_one_point_of_level_0, NULL});
}
