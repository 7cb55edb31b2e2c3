/* Times for reports. */
#include "base/timer.h"

#include "suite.h"
#include <math.h>

START_TEST(a_duration_is_minutes_and_seconds_or_hours_too) {
  static const struct {
    double seconds;
    const char *text;
  } cases[] = {{0, "0:00"},       {0.4, "0:00"},         {59.6, "1:00"}, {65, "1:05"},
               {3599.4, "59:59"}, {3600, "1:00:00"},     {-1, "?"},      {NAN, "?"},
               {INFINITY, "?"},   {3.59e6, "997:13:20"}, {3.6e6, "?"}};
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    char text[TIMER_TEXT];
    timer_print(cases[k].seconds, text);
    ck_assert_str_eq(text, cases[k].text);
  }
}
END_TEST

START_TEST(the_median_is_the_middle_of_the_sorted_times) {
  double odd[] = {3, 1, 2}, even[] = {4, 1, 3, 2};
  ck_assert_double_eq(timer_median(odd, 3), 2);
  ck_assert_double_eq(timer_median(even, 4), 3); /* the upper of the two in the middle */
}
END_TEST

int main(void) {
  return suite_run("timer", (SuiteTests){a_duration_is_minutes_and_seconds_or_hours_too,
                                         the_median_is_the_middle_of_the_sorted_times, NULL});
}
