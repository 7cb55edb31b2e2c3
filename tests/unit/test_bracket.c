/* A search by brackets ends at the right place, from whatever guess, in few trials when the guess is good. */
#include "random.h"
#include "study/bracket.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>

/* Searches for the step at `truth`; returns the number of trials. */
static int search(Bracket *bracket, double truth) {
  double trial[2];
  int trials = 0;
  for (int n; (n = bracket_next(bracket, trial)) > 0 && trials < 1000;)
    for (int i = 0; i < n; i++, trials++) {
      ck_assert(trial[i] >= bracket->low && trial[i] <= bracket->high);
      ck_assert(trial[i] != bracket->no && trial[i] != bracket->yes);
      bracket_learn(bracket, trial[i], trial[i] > truth);
    }
  return trials;
}

START_TEST(a_good_guess_takes_two_trials) {
  Bracket bracket;
  bracket_start(&bracket, 0.1, 1.2, 0.005, 0.7302, 0.0025);
  ck_assert_int_eq(search(&bracket, 0.731), 2);
  ck_assert(bracket_is_closed(&bracket));
  ck_assert(bracket.no == 0.728 && bracket.yes == 0.733);
  ck_assert(bracket_value(&bracket) == 0.7305);
}
END_TEST

/* Bounds: going outward doubles the step, going inward halves it. */
START_TEST(any_guess_leads_to_the_answer_within_the_tolerance) {
  enum { CASES = 2000 };
  uint64_t seed = 20261122;
  printf("seed %llu\n", (unsigned long long)seed);
  for (int k = 0; k < CASES; k++) {
    const double truth = 0.65 + 0.5499 * random_uniform(&seed), guess = 0.65 + 0.7 * random_uniform(&seed);
    const double tolerance = pow(10, -2.5 + 1.5 * random_uniform(&seed));
    const double reach = tolerance * (1 + 20 * fabs(random_uniform(&seed)));
    Bracket bracket;
    bracket_start(&bracket, 0.1, 1.2, tolerance, guess, reach);
    const int trials = search(&bracket, truth);
    ck_assert_msg(bracket_is_closed(&bracket), "truth %g guess %g tolerance %g reach %g: %g %g", truth, guess,
                  tolerance, reach, bracket.no, bracket.yes);
    ck_assert(bracket.no <= truth && truth <= bracket.yes);
    ck_assert_double_le(fabs(bracket_value(&bracket) - truth), 0.5 * tolerance * (1 + 1e-6));
    ck_assert_int_le(trials, 2 * bracket_plain_trials(0.1, 1.2, tolerance));
  }
}
END_TEST

START_TEST(a_condition_that_holds_everywhere_or_nowhere_is_told) {
  Bracket bracket;
  bracket_start(&bracket, 0.1, 1.2, 0.005, NAN, 0.1);
  search(&bracket, 2);
  ck_assert(isnan(bracket.yes) && bracket.no == 1.2 && isnan(bracket_value(&bracket)));
  bracket_start(&bracket, 0.1, 1.2, 0.005, 0.3, 0.1);
  search(&bracket, 0);
  ck_assert(isnan(bracket.no) && bracket.yes == 0.1 && isnan(bracket_value(&bracket)));
}
END_TEST

START_TEST(plain_halving_of_the_bracket_is_counted_right) {
  for (int k = 0; k < 3; k++) {
    const double tolerance[] = {0.1, 0.01, 0.003};
    double no = 0.1, yes = 1.2;
    int trials = 2;
    for (; yes - no > tolerance[k]; trials++) {
      const double middle = 0.5 * (no + yes);
      *(middle > 0.73 ? &yes : &no) = middle;
    }
    ck_assert_int_eq(bracket_plain_trials(0.1, 1.2, tolerance[k]), trials);
  }
}
END_TEST

int main(void) {
  return suite_run("bracket", (SuiteTests){a_good_guess_takes_two_trials,
                                           any_guess_leads_to_the_answer_within_the_tolerance,
                                           a_condition_that_holds_everywhere_or_nowhere_is_told,
                                           plain_halving_of_the_bracket_is_counted_right, NULL});
}
