/* The cost of a whole program. */
#include "benchmark/process.h"

#include "suite.h"
#include <string.h>

START_TEST(sleeping_costs_time_but_no_work) {
  Error error;
  ProcessCost cost;
  ck_assert_msg(process_measure((const char *const[]){"/bin/sleep", "0.02", NULL}, &cost, &error) ==
                    STATUS_OK,
                "%s", error.text);
  ck_assert_double_ge(cost.seconds, 0.02);
  ck_assert_double_lt(cost.cpu_seconds, 0.02); /* to start it takes a millisecond or two */
}
END_TEST

START_TEST(a_program_that_fails_or_is_missing_is_an_error) {
  Error error;
  ProcessCost cost;
  ck_assert_int_eq(process_measure((const char *const[]){"/bin/sh", "-c", "exit 3", NULL}, &cost, &error),
                   STATUS_FAILED);
  ck_assert_str_eq(error.text, "/bin/sh -c: expected to end with 0, found 3");
  ck_assert_int_eq(process_measure((const char *const[]){"/no/such/program", NULL}, &cost, &error),
                   STATUS_FAILED);
  ck_assert(strncmp(error.text, "/no/such/program: cannot be started: ", 37) == 0);
}
END_TEST

int main(void) {
  return suite_run("process", (SuiteTests){sleeping_costs_time_but_no_work,
                                           a_program_that_fails_or_is_missing_is_an_error, NULL});
}
