/* Numbers that a study tries: decimal, short, and the doubles that their text reads back to. */
#include "random.h"
#include "study/decimal.h"
#include "suite.h"
#include <math.h>
#include <string.h>

START_TEST(rounding_gives_the_double_nearest_to_the_decimal) {
  ck_assert(decimal_digits(0.1 + 0.2, 10) == 0.3); /* 0.30000000000000004 */
  ck_assert(decimal_digits(1234567, 3) == 1.23e6);
  ck_assert(decimal_digits(-0.00098765, 2) == -0.00099);
  ck_assert(decimal_digits(0, 5) == 0);
}
END_TEST

START_TEST(the_unit_is_a_power_of_ten_between_a_fourth_and_a_fortieth_of_the_tolerance) {
  uint64_t seed = 71;
  for (int i = 0; i < 1000; i++) {
    const double tolerance = pow(10, 6 * random_uniform(&seed)), unit = decimal_unit(tolerance);
    ck_assert_msg(unit <= tolerance / 4 && unit > tolerance / 40.0001, "tolerance %g, unit %g", tolerance,
                  unit);
    ck_assert_double_eq_tol(log10(unit), rint(log10(unit)), 1e-12); /* a few units in the last place */
  }
}
END_TEST

START_TEST(a_multiple_is_the_nearest_one_and_prints_without_a_tail) {
  uint64_t seed = 72;
  ck_assert(decimal_multiple(0.1234567, 1e-3) == 0.123);
  for (int i = 0; i < 1000; i++) {
    const double value = 5 * (1 + random_uniform(&seed)), multiple = decimal_multiple(value, 1e-4);
    char text[DECIMAL_SIZE];
    decimal_print(multiple, text);
    ck_assert_msg(fabs(multiple - value) <= 0.5e-4 * (1 + 1e-9), "%.17g became %.17g", value, multiple);
    ck_assert_msg(strlen(text) <= strlen("9.9999"), "%.17g is printed as %s", multiple, text);
    ck_assert_msg(strtod(text, NULL) == multiple, "%s reads back to another number", text);
  }
}
END_TEST

int main(void) {
  return suite_run("decimal",
                   (SuiteTests){rounding_gives_the_double_nearest_to_the_decimal,
                                the_unit_is_a_power_of_ten_between_a_fourth_and_a_fortieth_of_the_tolerance,
                                a_multiple_is_the_nearest_one_and_prints_without_a_tail, NULL});
}
