/* Random scatter against the theory of its distributions.  The seeds are fixed, so that a statistical test
 * either always passes or never; they stand in the messages. */
#include "laws/scatter.h"

#include "base/array.h"
#include "suite.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { N = 40000 };
static const long long SEED = 2021;

static double *scores(long long seed) {
  Error error;
  double *score = NULL;
  ck_assert_int_eq(ARRAY_NEW(&score, N, &error), STATUS_OK);
  ck_assert_int_eq(scatter_scores(seed, 0, N, NULL, score, &error), STATUS_OK);
  return score;
}

static int rising(const void *a, const void *b) {
  const double p = *(const double *)a, q = *(const double *)b;
  return (p > q) - (p < q);
}

/* Largest distance between the empirical distribution and a cumulative one (Kolmogorov & Smirnov). */
static double distance(double *value, double (*cumulative)(double)) {
  double largest = 0;
  qsort(value, N, sizeof *value, rising);
  for (int i = 0; i < N; i++) {
    const double p = cumulative(value[i]);
    largest = fmax(largest, fmax(fabs(p - (double)i / N), fabs(p - (double)(i + 1) / N)));
  }
  return largest;
}

static double weibull(double s) {
  return 1 - exp(-pow(s / 1.3, 5));
}
static double normal(double s) {
  return 0.5 * erfc(-(s - 2) / 0.4 / sqrt(2));
}
static double log_normal(double s) { /* mean 2, deviation 0.5: sigma^2 = log(1 + 1/16) */
  const double sigma = sqrt(log(1.0625)), mu = log(2) - 0.5 * sigma * sigma;
  return 0.5 * erfc(-(log(s) - mu) / sigma / sqrt(2));
}
static double uniform(double s) {
  return (s - 0.5) / 1.5;
}

/* A distance above 1.95/sqrt(N) has a probability of 0.1 % (Kolmogorov's limit law). */
START_TEST(values_are_distributed_as_they_should_be) {
  const double limit = 1.95 / sqrt(N);
  double *score = scores(SEED), *value = scores(SEED);
  for (int i = 0; i < N; i++) value[i] = scatter_weibull(score[i], 1.3, 5);
  ck_assert_msg(distance(value, weibull) < limit, "Weibull, seed %lld", SEED);
  for (int i = 0; i < N; i++) value[i] = scatter_normal(score[i], 2, 0.4);
  ck_assert_msg(distance(value, normal) < limit, "normal, seed %lld", SEED);
  for (int i = 0; i < N; i++) value[i] = scatter_log_normal(score[i], 2, 0.5);
  ck_assert_msg(distance(value, log_normal) < limit, "log-normal, seed %lld", SEED);
  for (int i = 0; i < N; i++) value[i] = scatter_uniform(score[i], 0.5, 2);
  ck_assert_msg(distance(value, uniform) < limit, "uniform, seed %lld", SEED);
  array_free(score);
  array_free(value);
}
END_TEST

START_TEST(quantiles_far_out_on_both_sides_are_exact) {
  /* P(score <= -6) = 9.865876450376946e-10 (tables) */
  const double p = 9.865876450376946e-10;
  ck_assert_double_eq_tol(scatter_uniform(-6, 0, 1) / p, 1, 1e-12);
  ck_assert_double_eq_tol(scatter_weibull(-6, 1, 1) / p, 1, 1e-9); /* p + p^2/2 */
  ck_assert_double_eq_tol(scatter_weibull(6, 1, 1), -log(p), 1e-12);
  ck_assert_double_eq_tol(scatter_weibull(0, 1, 1), log(2), 1e-15);
}
END_TEST

/* Mean of a Weibull distribution: scale Gamma(1 + 1/m); Gamma(3/2) = sqrt(pi)/2. */
START_TEST(the_scale_of_a_mean_follows_the_gamma_function) {
  ck_assert_double_eq_tol(scatter_weibull_scale(1, 2) * sqrt(atan(1)), 1, 1e-14);
  ck_assert_double_eq_tol(scatter_weibull_scale(3, 1), 3, 1e-14);
}
END_TEST

START_TEST(the_same_seed_gives_the_same_scores_and_another_gives_others) {
  double *a = scores(1), *b = scores(1), *c = scores(2);
  ck_assert_mem_eq(a, b, N * sizeof *a);
  ck_assert_mem_ne(a, c, N * sizeof *a);
  array_free(a);
  array_free(b);
  array_free(c);
}
END_TEST

/* Scores at two points r apart over many seeds: mean of products is exp(-r^2/(2 L^2)), with an error of
 * about sqrt(2/n) = 0.032 for n = 2000 seeds; four of these are allowed. */
START_TEST(correlation_falls_with_distance_as_stated) {
  enum { SEEDS = 2000, FIRST = 100 };
  const double L = 0.3, point[4][3] = {{0, 1, 0}, {0.1, 1, 0}, {0, 1, 0.3}, {0, -1, 0}};
  const double expected[4] = {1, exp(-0.5 / 9), exp(-0.5), 0};
  double sum[4] = {0};
  Error error;
  for (int k = 0; k < SEEDS; k++) {
    double score[4];
    ck_assert_int_eq(scatter_scores(FIRST + k, L, 4, point, score, &error), STATUS_OK);
    for (int i = 0; i < 4; i++) sum[i] += score[0] * score[i] / SEEDS;
  }
  for (int i = 0; i < 4; i++)
    ck_assert_msg(fabs(sum[i] - expected[i]) < 4 * sqrt(2.0 / SEEDS),
                  "point %d: expected a correlation of %g, found %g (seeds %d to %d)", i, expected[i], sum[i],
                  FIRST, FIRST + SEEDS - 1);
}
END_TEST

START_TEST(a_correlated_field_does_not_depend_on_what_else_is_asked_for) {
  const double point[3][3] = {{0, 1, 0}, {0.1, 0.9, 0}, {1, 0, 0}};
  double all[3], one;
  Error error;
  ck_assert_int_eq(scatter_scores(SEED, 0.2, 3, point, all, &error), STATUS_OK);
  ck_assert_int_eq(scatter_scores(SEED, 0.2, 1, &point[2], &one, &error), STATUS_OK);
  ck_assert_double_eq(one, all[2]);
}
END_TEST

int main(void) {
  return suite_run("scatter",
                   (SuiteTests){values_are_distributed_as_they_should_be,
                                quantiles_far_out_on_both_sides_are_exact,
                                the_scale_of_a_mean_follows_the_gamma_function,
                                the_same_seed_gives_the_same_scores_and_another_gives_others,
                                correlation_falls_with_distance_as_stated,
                                a_correlated_field_does_not_depend_on_what_else_is_asked_for, NULL});
}
