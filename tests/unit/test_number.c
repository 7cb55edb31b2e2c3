/* Doubles as text: exact, short, and the same for every NaN. */
#include "observe/number.h"

#include "suite.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static const char *printed(double value) {
  static char text[NUMBER_SIZE];
  number_print(value, text);
  return text;
}

START_TEST(numbers_written_by_hand_come_back_as_written) {
  ck_assert_str_eq(printed(0.05), "0.05");
  ck_assert_str_eq(printed(10), "10");
  ck_assert_str_eq(printed(1e-5), "1e-05");
  ck_assert_str_eq(printed(-0.7), "-0.7");
  ck_assert_str_eq(printed(-0.0), "-0");
}
END_TEST

START_TEST(any_bits_read_back_to_the_same_bits) {
  uint64_t state = 20240731; /* seed of xorshift64 */
  const double edges[] = {DBL_MIN, DBL_MAX,   DBL_TRUE_MIN, DBL_EPSILON,
                          1.0 / 3, 0.1 + 0.2, HUGE_VAL,     -HUGE_VAL};
  for (int k = 0; k < 20000; k++) {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    double value, back;
    memcpy(&value, &state, sizeof value);
    if (k < (int)(sizeof edges / sizeof *edges)) value = edges[k];
    if (isnan(value)) continue;
    back = strtod(printed(value), NULL);
    ck_assert_msg(memcmp(&value, &back, sizeof value) == 0, "%a came back as %a (seed 20240731)", value,
                  back);
  }
}
END_TEST

START_TEST(no_shorter_text_is_left_out) {
  ck_assert_str_eq(printed(0.1 + 0.2), "0.30000000000000004"); /* 17 digits are needed */
  ck_assert_str_eq(printed(1.0 / 3), "0.3333333333333333");    /* 16 are enough */
}
END_TEST

START_TEST(every_nan_is_nan) {
  ck_assert_str_eq(printed(NAN), "nan");
  ck_assert_str_eq(printed(copysign(NAN, -1)), "nan");
}
END_TEST

int main(void) {
  return suite_run("number", (SuiteTests){numbers_written_by_hand_come_back_as_written,
                                          any_bits_read_back_to_the_same_bits, no_shorter_text_is_left_out,
                                          every_nan_is_nan, NULL});
}
