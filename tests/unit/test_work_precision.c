/* What is concluded from a grid of run time against error; the runs themselves are those of the benchmark. */
#include "benchmark/work_precision.h"

#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Points of given cost and error, without runs. */
static WorkPoint point(double cpu_seconds, double shape, double D12) {
  return (WorkPoint){.run = {.cpu_seconds = cpu_seconds}, .error = {.shape = shape, .D12 = D12}};
}

START_TEST(errors_are_relative_but_for_angle_area_and_damage) {
  const RunState best = {.D12 = 0.5, .beta = 0.3, .L = {3, 1, 2}, .area_strain = 0.25, .d_max = 0.2};
  RunState state = best;
  state.D12 = 0.501;
  WorkError error = work_error(&state, &best);
  ck_assert_double_eq_tol(error.D12, 2e-3, 1e-12);
  ck_assert_double_eq_tol(error.shape, 2e-3, 1e-12);
  ck_assert_double_eq(error.d_max, 0);
  state.L[0] = 3.03;
  ck_assert_double_eq_tol(work_error(&state, &best).shape, 1e-2, 1e-12);
  state.beta = 0.3 - 0.02 * 3.14159265358979;
  ck_assert_double_eq_tol(work_error(&state, &best).shape, 2e-2, 1e-12);
  state.area_strain = 0.22;
  ck_assert_double_eq_tol(work_error(&state, &best).shape, 3e-2, 1e-12);
  state.d_max = 0.19;
  ck_assert_double_eq_tol(work_error(&state, &best).d_max, 1e-2, 1e-12);
  ck_assert_double_eq_tol(work_error(&state, &best).shape, 3e-2, 1e-12);
}
END_TEST

START_TEST(the_front_holds_what_nothing_beats) {
  WorkPoint points[] = {point(1, 1e-2, 0), point(2, 1e-3, 0), point(3, 2e-3, 0), point(4, 1e-4, 0),
                        point(5, 1e-4, 0)};
  const bool expected[] = {true, true, false, true, false};
  work_mark_front(points, 5);
  for (int k = 0; k < 5; k++) ck_assert_int_eq(points[k].is_on_front, expected[k]);
}
END_TEST

START_TEST(the_cheapest_point_within_an_error_is_found) {
  const WorkPoint points[] = {point(1, 1e-2, 1e-3), point(2, 1e-3, 1e-2), point(4, 1e-4, 1e-4)};
  ck_assert_ptr_eq(work_cheapest(points, 3, offsetof(WorkError, shape), 2e-3), &points[1]);
  ck_assert_ptr_eq(work_cheapest(points, 3, offsetof(WorkError, D12), 2e-3), &points[0]);
  ck_assert_ptr_eq(work_cheapest(points, 3, offsetof(WorkError, shape), 1e-4), &points[2]);
  ck_assert_ptr_null(work_cheapest(points, 3, offsetof(WorkError, shape), 1e-5));
}
END_TEST

START_TEST(parts_that_cancel_are_no_merit) {
  WorkPoint points[] = {point(1, 1e-4, 1e-4), point(2, 1e-3, 1e-3)};
  points[0].space = points[0].time = 5e-3;
  ck_assert_double_eq(work_counted(&points[0], 1e-4), 5e-3);
  ck_assert_double_eq(work_counted(&points[0], 6e-3), 6e-3);
  ck_assert_ptr_eq(work_cheapest(points, 2, offsetof(WorkError, shape), 1e-3), &points[1]);
  work_mark_front(points, 2);
  ck_assert(points[0].is_on_front && points[1].is_on_front);
}
END_TEST

START_TEST(the_largest_part_of_an_error_is_named) {
  ck_assert_str_eq(work_dominating(&(WorkPoint){.space = 3, .quadrature = 2, .time = 1}), "space");
  ck_assert_str_eq(work_dominating(&(WorkPoint){.space = 1, .quadrature = 2, .time = 1}), "quadrature");
  ck_assert_str_eq(work_dominating(&(WorkPoint){.space = 1, .quadrature = 1, .time = 2}), "time");
}
END_TEST

START_TEST(the_exponent_of_a_power_law_is_found) {
  const double x[] = {1280, 5120, 20480, 81920};
  double y[4];
  for (int k = 0; k < 4; k++) y[k] = 3e-4 * pow(x[k], 1.2);
  ck_assert_double_eq_tol(work_exponent(4, x, y), 1.2, 1e-12); /* round-off of logarithms */
  y[0] *= 1.1;
  y[3] *= 1.1; /* curvature, not slope */
  ck_assert_double_eq_tol(work_exponent(4, x, y), 1.2, 1e-12);
  ck_assert(isnan(work_exponent(1, x, y)));
}
END_TEST

typedef struct {
  char interpolation[16], method[16], integrator[8], tolerance[8];
  double measured, expected;
} Timed;

/* The points of the tables in docs/benchmarks.md, with what is expected of each. */
static int read_table(Timed *timed, int capacity) {
  char line[512];
  int n = 0, elements;
  FILE *page = fopen(SOURCE_DIR "/docs/benchmarks.md", "r");
  ck_assert_ptr_nonnull(page);
  while (n < capacity && fgets(line, sizeof line, page)) {
    Timed *t = &timed[n];
    if (sscanf(line, "| %d | %15s | %15s | %7s %7s | %*f | %lf | %*d | %*f", &elements, t->interpolation,
               t->method, t->integrator, t->tolerance, &t->measured) != 6)
      continue;
    const int subdivisions = (int)lround(log2(elements / 20) / 2);
    t->expected = work_expected_seconds(
        &(WorkKnobs){subdivisions, t->interpolation, t->method, t->integrator, t->tolerance});
    n++;
  }
  fclose(page);
  return n;
}

/* Another machine has other seconds, but much the same ratios; runs below a second are repeated, and matter
 * little to the time left. */
START_TEST(expected_seconds_follow_those_of_the_page_within_a_factor_of_four) {
  Timed timed[WORK_POINTS * 2 + 2];
  const int n = read_table(timed, WORK_POINTS * 2 + 2);
  double measured = 0, expected = 0;
  int compared = 0;
  for (int k = 0; k < n; k++) {
    measured += timed[k].measured;
    expected += timed[k].expected;
  }
  for (int k = 0; k < n; k++) {
    if (timed[k].measured < 1) continue;
    const double ratio = timed[k].expected / timed[k].measured * (measured / expected);
    ck_assert_msg(ratio > 0.25 && ratio < 4, "%s %s %s: %g s expected, %g s measured", timed[k].method,
                  timed[k].integrator, timed[k].tolerance, timed[k].expected, timed[k].measured);
    compared++;
  }
  ck_assert_int_gt(compared, 20);
}
END_TEST

int main(void) {
  return suite_run("work_precision",
                   (SuiteTests){errors_are_relative_but_for_angle_area_and_damage,
                                the_front_holds_what_nothing_beats,
                                the_cheapest_point_within_an_error_is_found, parts_that_cancel_are_no_merit,
                                the_largest_part_of_an_error_is_named, the_exponent_of_a_power_law_is_found,
                                expected_seconds_follow_those_of_the_page_within_a_factor_of_four, NULL});
}
