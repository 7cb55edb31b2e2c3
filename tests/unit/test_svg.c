/* Words, numbers and ticks of SVG documents. */
#include "observe/svg.h"

#include "suite.h"
#include <stdio.h>

static void check_number(double value, const char *expected) {
  Error error;
  Text svg = {0};
  char whole[256];
  ck_assert_int_eq(svg_number(&svg, 1, 2.25, "end", value, &error), STATUS_OK);
  snprintf(whole, sizeof whole, "<text x=\"1.0\" y=\"2.2\" text-anchor=\"end\">%s</text>\n", expected);
  ck_assert_str_eq(svg.data, whole);
  text_free(&svg);
}
#define POWER(exponent) "<tspan dy=\"-5\" font-size=\"75%\">" exponent "</tspan>"

START_TEST(a_number_of_usual_size_is_written_out) {
  check_number(0, "0");
  check_number(-0.0, "0");
  check_number(0.001, "0.001");
  check_number(-0.25, "-0.25");
  check_number(3 * 0.1, "0.3");
  check_number(20000, "20000");
}
END_TEST

START_TEST(other_numbers_have_a_power_of_ten) {
  check_number(1e-4, "10" POWER("-4"));
  check_number(5e-4, "5·10" POWER("-4"));
  check_number(1e5, "10" POWER("5"));
  check_number(-2.5e7, "-2.5·10" POWER("7"));
  check_number(1e300, "10" POWER("300"));
}
END_TEST

START_TEST(words_are_escaped) {
  Error error;
  Text svg = {0};
  ck_assert_int_eq(svg_label(&svg, 0, 0, "start", "a < b & \"c\" > λ", &error), STATUS_OK);
  ck_assert_str_eq(
      svg.data,
      "<text x=\"0.0\" y=\"0.0\" text-anchor=\"start\">a &lt; b &amp; &quot;c&quot; &gt; λ</text>\n");
  text_free(&svg);
}
END_TEST

START_TEST(a_tick_step_is_one_two_or_five_times_a_power_of_ten) {
  /* round-off of pow: 1e-12 relative */
  ck_assert_double_eq_tol(svg_tick_step(1, 5), 0.2, 1e-12);
  ck_assert_double_eq_tol(svg_tick_step(5, 5), 1, 1e-12);
  ck_assert_double_eq_tol(svg_tick_step(26, 5), 5, 1e-12);
  ck_assert_double_eq_tol(svg_tick_step(0.045, 5), 0.01, 1e-14);
}
END_TEST

int main(void) {
  return suite_run("svg", (SuiteTests){a_number_of_usual_size_is_written_out,
                                       other_numbers_have_a_power_of_ten, words_are_escaped,
                                       a_tick_step_is_one_two_or_five_times_a_power_of_ten, NULL});
}
