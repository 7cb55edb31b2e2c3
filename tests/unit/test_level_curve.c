/* Where a sampled curve passes a level, against curves whose crossing is known in closed form. */
#include "study/level_curve.h"
#include "suite.h"
#include <math.h>

static void add(LevelCurve *curve, double x, double y) {
  Error error;
  ck_assert_int_eq(level_curve_add(curve, x, y, &error), STATUS_OK);
}

START_TEST(a_power_law_is_met_exactly) {
  LevelCurve curve = {0};
  for (int k = 5; k >= 1; k--) add(&curve, 0.1 * k, 3 * pow(0.1 * k, 1.7)); /* in any order */
  for (double x = 0.11; x < 0.5; x += 0.013) {
    const LevelCrossing crossing = level_curve_cross(&curve, 3 * pow(x, 1.7));
    ck_assert_double_eq_tol(crossing.x, x, 1e-12);
    ck_assert_double_le(crossing.error, 1e-12);
    ck_assert(crossing.low <= x && x <= crossing.high);
  }
  level_curve_free(&curve);
}
END_TEST

/* y = x exp(x): in logarithms neither a line nor a parabola. */
START_TEST(the_stated_error_bounds_the_true_one) {
  LevelCurve curve = {0};
  for (int k = 0; k < 7; k++)
    add(&curve, 0.1 * pow(12, k / 6.0), 0.1 * pow(12, k / 6.0) * exp(0.1 * pow(12, k / 6.0)));
  double worst = 0;
  for (double x = 0.105; x < 1.2; x += 0.011) {
    const LevelCrossing crossing = level_curve_cross(&curve, x * exp(x));
    const double error = fabs(crossing.x - x);
    ck_assert_msg(error <= crossing.error + 1e-12, "x %g: error %g, stated %g", x, error, crossing.error);
    worst = fmax(worst, error);
  }
  ck_assert_double_le(worst, 2e-3); /* third differences of ln x over ln y: measured 1e-3 */
  level_curve_free(&curve);
}
END_TEST

START_TEST(a_level_outside_the_samples_is_not_passed) {
  LevelCurve curve = {0};
  ck_assert(isnan(level_curve_cross(&curve, 1).x));
  add(&curve, 1, 1);
  add(&curve, 2, 2);
  const LevelCrossing below = level_curve_cross(&curve, 0.5), above = level_curve_cross(&curve, 3);
  ck_assert(isnan(below.x) && isnan(below.low) && below.high == 1);
  ck_assert(isnan(above.x) && above.low == 2 && isnan(above.high));
  level_curve_free(&curve);
}
END_TEST

START_TEST(two_samples_give_the_line_and_no_claim) {
  LevelCurve curve = {0};
  add(&curve, 1, 1);
  add(&curve, 2, 5);
  add(&curve, 2, 2); /* replaces */
  const LevelCrossing crossing = level_curve_cross(&curve, 1.5);
  ck_assert_double_eq_tol(crossing.x, 1.5, 1e-12);
  ck_assert_double_eq_tol(crossing.error, 0.5, 1e-12);
  level_curve_free(&curve);
}
END_TEST

int main(void) {
  return suite_run("level_curve",
                   (SuiteTests){a_power_law_is_met_exactly, the_stated_error_bounds_the_true_one,
                                a_level_outside_the_samples_is_not_passed,
                                two_samples_give_the_line_and_no_claim, NULL});
}
