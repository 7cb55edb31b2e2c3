/* The power iteration on matrices and equations whose spectral radius is known. */
#include "coupling/spectral_radius.h"

#include "ode.h"
#include "suite.h"
#include <string.h>

enum { MAX_N = 300 };

typedef struct {
  double rho;
  int evaluations;
  double direction[MAX_N];
} Estimate;

static void iterate(const Rhs *rhs, const double *x, Estimate *estimate) {
  double f[MAX_N], x_trial[MAX_N], f_trial[MAX_N];
  Error error;
  estimate->evaluations = 0;
  ck_assert_int_eq(rhs->evaluate(rhs->context, x, 0, 0, f, &error), STATUS_OK);
  ck_assert_int_eq(spectral_radius(rhs, 0, x, f, estimate->direction, x_trial, f_trial, &estimate->rho,
                                   &estimate->evaluations, &error),
                   STATUS_OK);
}

static Estimate estimate_radius(const Rhs *rhs, const double *x) {
  Estimate estimate;
  spectral_radius_seed(rhs->n, x, estimate.direction);
  iterate(rhs, x, &estimate);
  return estimate;
}

static void fill(int n, double value, double *x) {
  for (int i = 0; i < n; i++) x[i] = value;
}

START_TEST(a_lone_largest_rate_is_found_to_half_a_per_cent) {
  double rate[MAX_N], x[MAX_N];
  fill(MAX_N, 1, x);
  for (int i = 0; i < MAX_N; i++) rate[i] = -(i % 7);
  rate[123] = -40;
  Decay decay = {MAX_N, rate};
  const Rhs rhs = decay_rhs(&decay);
  const Estimate estimate = estimate_radius(&rhs, x);
  ck_assert_double_eq_tol(estimate.rho, 40, 0.2);
  ck_assert_int_le(estimate.evaluations, 15);
}
END_TEST

/* x' = H diag(rate) H x with the Householder reflection H = 1 - 2 w w^T/w^2: symmetric, eigenvalues rate. */
static Status reflected_evaluate(void *context, const double *x, double t, double dt, double *f,
                                 Error *error) {
  const Decay *decay = context;
  const int n = decay->n;
  double y[MAX_N];
  memcpy(y, x, (size_t)n * sizeof *y);
  for (int pass = 0; pass < 2; pass++) {
    double dot = 0, square = 0;
    for (int i = 0; i < n; i++) dot += (i % 5 + 1) * y[i];
    for (int i = 0; i < n; i++) square += (i % 5 + 1) * (i % 5 + 1);
    for (int i = 0; i < n; i++) y[i] -= 2 * dot / square * (i % 5 + 1);
    if (pass == 0)
      if (decay_evaluate(context, y, t, dt, y, error) != STATUS_OK) return STATUS_FAILED;
  }
  memcpy(f, y, (size_t)n * sizeof *f);
  return STATUS_OK;
}

/* Rates spread evenly from 0 to -100: no gap at the top, the worst that a membrane can offer. */
static void spread_rates(double *rate) {
  for (int i = 0; i < MAX_N; i++) rate[i] = -100.0 * i / (MAX_N - 1);
}

START_TEST(an_evenly_filled_spectrum_is_found_to_some_per_cent_and_from_below) {
  double rate[MAX_N], x[MAX_N];
  fill(MAX_N, 0.5, x);
  spread_rates(rate);
  Decay decay = {MAX_N, rate};
  const Rhs rhs = {.n = MAX_N, .context = &decay, .evaluate = reflected_evaluate};
  const Estimate estimate = estimate_radius(&rhs, x);
  ck_assert_double_le(estimate.rho, 100 * (1 + 1e-6)); /* |A v| <= rho |v| for a symmetric matrix */
  ck_assert_double_ge(estimate.rho, 93); /* the 1.15 that the stepper allows for covers twice that */
}
END_TEST

START_TEST(the_last_direction_saves_most_of_the_work) {
  double rate[MAX_N], x[MAX_N];
  fill(MAX_N, 0.5, x);
  spread_rates(rate);
  Decay decay = {MAX_N, rate};
  const Rhs rhs = decay_rhs(&decay);
  Estimate estimate = estimate_radius(&rhs, x);
  const double first = estimate.rho;
  iterate(&rhs, x, &estimate);
  ck_assert_int_le(estimate.evaluations, 3);
  ck_assert_double_ge(estimate.rho, first * (1 - 1e-6)); /* and it comes closer from below */
  ck_assert_double_le(estimate.rho, 100 * (1 + 1e-6));
}
END_TEST

/* x_i' = -k_i x_i^3, whose Jacobian is -3 k_i x_i^2. */
static Status cubic_evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  (void)context;
  (void)t;
  (void)dt;
  (void)error;
  for (int i = 0; i < 6; i++) f[i] = -(i + 1) * x[i] * x[i] * x[i];
  return STATUS_OK;
}

START_TEST(a_non_linear_equation_is_measured_where_it_stands) {
  const Rhs rhs = {.n = 6, .evaluate = cubic_evaluate};
  const double x[6] = {1, 2, 1, 1, 1, 1};     /* rates 3, 24, 9, 12, 15, 18 */
  const double x_far[6] = {1, 1, 1, 1, 1, 3}; /* the last: 162 */
  /* the second rate is 3/4 of the first: it stops when the ratio of norms changes by half a per cent */
  ck_assert_double_eq_tol(estimate_radius(&rhs, x).rho, 24, 0.03 * 24);
  ck_assert_double_eq_tol(estimate_radius(&rhs, x_far).rho, 162, 0.01 * 162);
}
END_TEST

START_TEST(the_estimate_is_the_same_every_time) {
  double rate[MAX_N], x[MAX_N], seed[MAX_N], again[MAX_N];
  for (int i = 0; i < MAX_N; i++) x[i] = 1 + i; /* places apart */
  spread_rates(rate);
  Decay decay = {MAX_N, rate};
  const Rhs rhs = decay_rhs(&decay);
  const Estimate one = estimate_radius(&rhs, x), two = estimate_radius(&rhs, x);
  ck_assert_double_eq(one.rho, two.rho);
  ck_assert_mem_eq(one.direction, two.direction, sizeof one.direction);
  spectral_radius_seed(MAX_N, x, seed);
  spectral_radius_seed(MAX_N, x, again);
  ck_assert_mem_eq(seed, again, sizeof seed);
  double sum = 0, square = 0;
  for (int i = 0; i < MAX_N; i++) {
    ck_assert_double_le(fabs(seed[i]), 1);
    sum += seed[i];
    square += seed[i] * seed[i];
  }
  /* evenly spread over -1 .. 1: mean 0 +- 0.1 (three deviations of 300 numbers), mean square 1/3 */
  ck_assert_double_eq_tol(sum / MAX_N, 0, 0.1);
  ck_assert_double_eq_tol(square / MAX_N, 1.0 / 3, 0.06);
}
END_TEST

START_TEST(the_seed_has_the_symmetries_of_the_nodes) {
  /* A node, its images under the eight changes of sign, and one on a mirror plane. */
  enum { IMAGES = 8 };
  const double X[3] = {0.3, -0.5, 0.8}, on_plane[3] = {0.6, 0, -0.8};
  double x[3 * (IMAGES + 1)], w[3 * (IMAGES + 1)];
  for (int code = 0; code < IMAGES; code++)
    for (int c = 0; c < 3; c++) x[3 * code + c] = code >> c & 1 ? -X[c] : X[c];
  memcpy(x + 3 * IMAGES, on_plane, sizeof on_plane);
  spectral_radius_seed(3 * (IMAGES + 1), x, w);
  for (int code = 0; code < IMAGES; code++)
    for (int c = 0; c < 3; c++) ck_assert_double_eq(w[3 * code + c], code >> c & 1 ? -w[c] : w[c]);
  ck_assert_double_eq(w[3 * IMAGES + 1], 0);
  ck_assert_double_ne(w[3 * IMAGES], 0);
  ck_assert_double_ne(w[0], w[1]);
}
END_TEST

START_TEST(a_refusal_is_passed_on) {
  const double rate[3] = {-1, -2, -3}, x[3] = {1, 1, 1}, f[3] = {-1, -2, -3};
  Decay decay = {3, rate};
  Watch w = watch(decay_rhs(&decay));
  w.code = STATUS_REJECT;
  w.first = w.last = 3;
  const Rhs rhs = watched(&w);
  double direction[3], x_trial[3], f_trial[3], rho = -1;
  int evaluations = 0;
  Error error;
  spectral_radius_seed(3, x, direction);
  ck_assert_int_eq(spectral_radius(&rhs, 0, x, f, direction, x_trial, f_trial, &rho, &evaluations, &error),
                   STATUS_REJECT);
  ck_assert_int_eq(evaluations, 3);
  ck_assert_double_eq(rho, -1); /* the last estimate stands */
}
END_TEST

/* The same rates, from a rule that is asked for differences in place of the equation itself. */
static long asked_of_the_cheap_rule;
static Status cheap_stage(void *context, const double *x, double t, double dt, double *f, Error *error) {
  asked_of_the_cheap_rule++;
  return decay_evaluate(context, x, t, dt, f, error);
}

START_TEST(a_cheaper_rule_is_asked_where_there_is_one) {
  const double rate[3] = {-1, -2, -30}, x[3] = {1, 1, 1};
  Decay decay = {3, rate};
  const double f[3] = {-1, -2, -30};
  const Rhs plain = decay_rhs(&decay);
  Rhs rhs = plain;
  rhs.stage = cheap_stage;
  double direction[3], x_trial[3], f_trial[3], rho;
  int evaluations = 0;
  Error error;
  spectral_radius_seed(3, x, direction);
  ck_assert_int_eq(spectral_radius(&rhs, 0, x, f, direction, x_trial, f_trial, &rho, &evaluations, &error),
                   STATUS_OK);
  ck_assert_double_eq_tol(rho, 30, 0.01 * 30);
  ck_assert_int_gt(evaluations, 1);
  ck_assert_int_eq(evaluations, (int)asked_of_the_cheap_rule);
  ck_assert_double_eq(rho, estimate_radius(&plain, x).rho);
}
END_TEST

static Status constant_evaluate(void *context, const double *x, double t, double dt, double *f,
                                Error *error) {
  (void)context;
  (void)x;
  (void)t;
  (void)dt;
  (void)error;
  fill(6, 1, f);
  return STATUS_OK;
}

START_TEST(an_equation_that_does_not_depend_on_x_has_radius_zero_and_a_direction_to_go_on_with) {
  const Rhs rhs = {.n = 6, .evaluate = constant_evaluate}, later = {.n = 6, .evaluate = cubic_evaluate};
  const double x[6] = {1, 1, 1, 1, 1, 1};
  Estimate estimate = estimate_radius(&rhs, x);
  ck_assert_double_eq(estimate.rho, 0);
  iterate(&later, x, &estimate); /* rates 3 .. 18 */
  ck_assert_double_eq_tol(estimate.rho, 18, 0.1 * 18);
}
END_TEST

START_TEST(the_origin_is_a_place_like_any_other) {
  const double rate[3] = {-1, -2, -30}, x[3] = {0, 0, 0};
  Decay decay = {3, rate};
  const Rhs rhs = decay_rhs(&decay);
  ck_assert_double_eq_tol(estimate_radius(&rhs, x).rho, 30, 0.01 * 30);
}
END_TEST

int main(void) {
  return suite_run(
      "spectral_radius",
      (SuiteTests){a_lone_largest_rate_is_found_to_half_a_per_cent,
                   an_evenly_filled_spectrum_is_found_to_some_per_cent_and_from_below,
                   the_last_direction_saves_most_of_the_work,
                   a_non_linear_equation_is_measured_where_it_stands, the_estimate_is_the_same_every_time,
                   the_seed_has_the_symmetries_of_the_nodes, a_refusal_is_passed_on,
                   a_cheaper_rule_is_asked_where_there_is_one,
                   an_equation_that_does_not_depend_on_x_has_radius_zero_and_a_direction_to_go_on_with,
                   the_origin_is_a_place_like_any_other, NULL});
}
