/* Every integrator of the table against exact solutions and the closed form of its stability polynomial. */
#include "coupling/integrator.h"
#include "coupling/rkc3.h"

#include "ode.h"
#include "suite.h"
#include <stdbool.h>
#include <string.h>

typedef struct {
  IntegratorKind kind;
  int stages;
} Method;

static const Method METHODS[] = {{INTEGRATOR_RK2, 2},    {INTEGRATOR_RKC2, 2},  {INTEGRATOR_RKC2, 3},
                                 {INTEGRATOR_RKC2, 5},   {INTEGRATOR_RKC2, 10}, {INTEGRATOR_RKC2, 31},
                                 {INTEGRATOR_RKC2, 200}, {INTEGRATOR_RKC3, 4},  {INTEGRATOR_RKC3, 5},
                                 {INTEGRATOR_RKC3, 8},   {INTEGRATOR_RKC3, 13}, {INTEGRATOR_RKC3, 24},
                                 {INTEGRATOR_RKC3, 40}};
enum { N_METHODS = sizeof METHODS / sizeof *METHODS, MAX_N = 64 };

static Status step(Method method, const Rhs *rhs, double t, double h, const double *x0, double *x1,
                   Error *error) {
  double f0[MAX_N], work[INTEGRATOR_WORK * MAX_N];
  const Status status = rhs->evaluate(rhs->context, x0, t, 0, f0, error);
  if (status != STATUS_OK) return status;
  return integrator_get(method.kind)->step(rhs, method.stages, t, h, x0, f0, x1, work, error);
}

static void must_step(Method method, const Rhs *rhs, double t, double h, const double *x0, double *x1) {
  Error error;
  ck_assert_int_eq(step(method, rhs, t, h, x0, x1, &error), STATUS_OK);
}

/* Error at t = 1 of n equal steps from t = 0 of the swinging problem. */
static double swing_error(Method method, int n) {
  const Rhs rhs = swing();
  double x[3], next[3], exact[3];
  swing_solution(0, x);
  for (int k = 0; k < n; k++) {
    must_step(method, &rhs, (double)k / n, 1.0 / n, x, next);
    memcpy(x, next, sizeof x);
  }
  swing_solution(1, exact);
  return largest_difference(3, x, exact);
}

static bool is_of_order_three(Method method) {
  return method.kind == INTEGRATOR_RKC3 && method.stages <= RKC3_MAX_STAGES;
}

START_TEST(the_error_falls_with_the_order_of_the_method) {
  for (int m = 0; m < N_METHODS; m++) {
    const double coarse = swing_error(METHODS[m], 80), fine = swing_error(METHODS[m], 160);
    ck_assert_double_lt(fine, is_of_order_three(METHODS[m]) ? 1e-5 : 1e-3);
    /* to within what the next term of the error still does at h = 1/80 */
    ck_assert_double_eq_tol(log2(coarse / fine), is_of_order_three(METHODS[m]) ? 3 : 2, 0.05);
  }
}
END_TEST

static Status clock_evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  (void)context;
  (void)x;
  (void)error;
  f[0] = t + dt;
  f[1] = 1;
  f[2] = -2 * (t + dt);
  return STATUS_OK;
}

START_TEST(each_stage_stands_at_its_time) {
  /* dx/dt = t is exact for a method of order two only when the times of the stages are those of the method;
   * round-off of the recurrence grows as eps s^2. */
  const Rhs rhs = {.n = 3, .evaluate = clock_evaluate};
  const double t = 0.3, h = 0.7, x0[3] = {1, 2, 3};
  for (int m = 0; m < N_METHODS; m++) {
    double x1[3];
    must_step(METHODS[m], &rhs, t, h, x0, x1);
    const double area = t * h + 0.5 * h * h, s = METHODS[m].stages;
    ck_assert_double_eq_tol(x1[0], x0[0] + area, 1e-15 * s * s);
    ck_assert_double_eq_tol(x1[1], x0[1] + h, 1e-15 * s * s);
    ck_assert_double_eq_tol(x1[2], x0[2] - 2 * area, 1e-15 * s * s);
  }
}
END_TEST

/* x_0' = 1 from x_0(t) = t: x_0 is the time that a stage stands for. */
static Status gap_evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  (void)error;
  double *gap = context;
  *gap = fmax(*gap, fabs(x[0] - (t + dt)));
  f[0] = f[1] = f[2] = 1;
  return STATUS_OK;
}

START_TEST(the_time_of_a_stage_is_the_time_that_its_positions_stand_for) {
  for (int m = 0; m < N_METHODS; m++) {
    double gap = 0;
    const Rhs rhs = {.n = 3, .context = &gap, .evaluate = gap_evaluate};
    const double x0[3] = {0.25, 0, 0}, s = METHODS[m].stages;
    double x1[3];
    must_step(METHODS[m], &rhs, 0.25, 0.5, x0, x1);
    ck_assert_double_le(gap, 1e-15 * s * s); /* round-off of the recurrence */
  }
}
END_TEST

START_TEST(evaluations_stay_inside_the_step_and_number_one_less_than_the_stages) {
  for (int m = 0; m < N_METHODS; m++) {
    Watch w = watch(swing());
    const Rhs rhs = watched(&w);
    double x0[3], x1[3];
    swing_solution(0.5, x0);
    must_step(METHODS[m], &rhs, 0.5, 0.125, x0, x1);
    ck_assert_int_eq((int)w.calls, METHODS[m].stages); /* one of them is f0 */
    ck_assert_double_ge(w.earliest, 0.5);
    ck_assert_double_le(w.latest, 0.625);
  }
}
END_TEST

START_TEST(a_refusal_at_any_stage_ends_the_step_with_its_message) {
  for (int m = 0; m < N_METHODS; m++)
    for (long call = 2; call <= METHODS[m].stages; call += 1 + METHODS[m].stages / 7) {
      Watch w = watch(swing());
      w.code = STATUS_REJECT;
      w.first = w.last = call;
      const Rhs rhs = watched(&w);
      double x0[3], x1[3];
      swing_solution(0, x0);
      Error error;
      ck_assert_int_eq(step(METHODS[m], &rhs, 0, 0.1, x0, x1, &error), STATUS_REJECT);
      ck_assert_str_eq(error.text, "the door is closed");
      ck_assert_int_eq((int)w.calls, (int)call);
    }
}
END_TEST

/* ---- stability ---- */

/* T_s(w) as cos or cosh of s times the angle. */
static double chebyshev_closed(int s, double w) {
  if (fabs(w) <= 1) return cos(s * acos(w));
  return (w < 0 && s % 2 ? -1 : 1) * cosh(s * acosh(fabs(w)));
}

/* What a step does to x' = z x / h: 1 + z + z^2/2 for the midpoint rule; a_s + b_s T_s(w0 + w1 z) for the
 * Chebyshev method with damping 2/13 (Sommeijer, Shampine & Verwer 1998, section 2), where T_s'' comes from
 * Chebyshev's equation (1 - w^2) T'' - w T' + s^2 T = 0. */
static double stability_polynomial(Method method, double z) {
  if (method.kind == INTEGRATOR_RK2) return 1 + z + 0.5 * z * z;
  const double s = method.stages, shift = 2.0 / 13 / (s * s), w0 = 1 + shift;
  const double angle = 2 * asinh(sqrt(0.5 * shift)); /* acosh(w0) without cancellation */
  const double T = cosh(s * angle), dT = s * sinh(s * angle) / sinh(angle);
  const double d2T = (s * s * T - w0 * dT) / (shift * (2 + shift));
  const double w1 = dT / d2T, b = d2T / (dT * dT);
  return 1 - b * T + b * chebyshev_closed(method.stages, w0 + w1 * z);
}

/* x1 / x0 of one step of x' = z x / h, at up to MAX_N values of z together. */
static void growth(Method method, int n, const double *z, double *factor) {
  double x0[MAX_N];
  Decay decay = {n, z};
  const Rhs rhs = decay_rhs(&decay);
  for (int i = 0; i < n; i++) x0[i] = 1;
  must_step(method, &rhs, 0, 1, x0, factor);
}

START_TEST(one_step_of_a_linear_problem_is_the_stability_polynomial) {
  for (int m = 0; m < N_METHODS; m++) {
    if (is_of_order_three(METHODS[m])) continue; /* there is no closed form */
    const double reach = integrator_get(METHODS[m].kind)->reach(METHODS[m].stages), s = METHODS[m].stages;
    double z[MAX_N], factor[MAX_N];
    for (int i = 0; i < MAX_N; i++) z[i] = -reach * i / (MAX_N - 1);
    growth(METHODS[m], MAX_N, z, factor);
    /* Round-off of the recurrence is eps s^2 in the stretch of z, which the slope of the polynomial at the
     * ends, s^2 over its length, carries on. */
    const double tolerance = 1e-14 + 1e-16 * s * s * s * s;
    for (int i = 0; i < MAX_N; i++)
      ck_assert_double_eq_tol(factor[i], stability_polynomial(METHODS[m], z[i]), tolerance);
  }
}
END_TEST

START_TEST(two_chebyshev_stages_are_a_method_of_order_two_and_nothing_more) {
  const double z[3] = {-1.5, -0.5, 0.25};
  double factor[3];
  growth((Method){INTEGRATOR_RKC2, 2}, 3, z, factor);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(factor[i], 1 + z[i] + 0.5 * z[i] * z[i], 1e-14);
}
END_TEST

START_TEST(everything_decays_within_reach_and_grows_a_third_beyond_it) {
  for (int m = 0; m < N_METHODS; m++) {
    const double reach = integrator_get(METHODS[m].kind)->reach(METHODS[m].stages);
    double z[MAX_N], factor[MAX_N];
    for (int sweep = 0; sweep < 20; sweep++) {
      for (int i = 0; i < MAX_N; i++) z[i] = -0.98 * reach * (sweep + (i + 1.0) / MAX_N) / 20;
      growth(METHODS[m], MAX_N, z, factor);
      for (int i = 0; i < MAX_N; i++) ck_assert_double_lt(fabs(factor[i]), 1);
    }
    z[0] = -1.3 * reach; /* an odd number of stages holds out beyond its reach, but not so far */
    growth(METHODS[m], 1, z, factor);
    ck_assert_double_gt(fabs(factor[0]), 1);
  }
}
END_TEST

START_TEST(a_stiff_problem_stays_bounded_over_a_thousand_steps) {
  for (int m = 0; m < N_METHODS; m++) {
    const Integrator *integrator = integrator_get(METHODS[m].kind);
    const double reach = integrator->reach(METHODS[m].stages);
    const double rate[3] = {-0.98 * reach, -0.5 * reach, -1e-3};
    Decay decay = {3, rate};
    const Rhs rhs = decay_rhs(&decay);
    double x[3] = {1, 1, 1}, next[3];
    const int steps = METHODS[m].stages > 50 ? 100 : 1000;
    for (int k = 0; k < steps; k++) {
      must_step(METHODS[m], &rhs, k, 1, x, next);
      memcpy(x, next, sizeof x);
    }
    ck_assert_double_lt(fabs(x[0]), 1e-2); /* the damping at the end of the interval, 0.95 a step or less */
    ck_assert_double_lt(fabs(x[1]), 1e-2);
    ck_assert_double_eq_tol(x[2], exp(-1e-3 * steps), 1e-6);
  }
}
END_TEST

/* x' = (real + i imaginary) x, of x[0] + i x[1] */
static Status spiral_evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  (void)t;
  (void)dt;
  (void)error;
  const double *z = context;
  f[0] = z[0] * x[0] - z[1] * x[1];
  f[1] = z[1] * x[0] + z[0] * x[1];
  f[2] = 0;
  return STATUS_OK;
}

START_TEST(what_decays_while_it_turns_decays_too) {
  /* A membrane that tank-treads turns its modes by some tenths of a radian in a step. */
  for (int m = 0; m < N_METHODS; m++) {
    if (METHODS[m].kind == INTEGRATOR_RK2) continue; /* its stability region is narrow at the end */
    const double reach = integrator_get(METHODS[m].kind)->reach(METHODS[m].stages);
    for (int i = 1; i <= 100; i++) {
      double z[2] = {-0.97 * reach * i / 100, 0.3}, x1[3];
      const Rhs rhs = {.n = 3, .context = z, .evaluate = spiral_evaluate};
      if (z[0] > -0.3) continue;
      must_step(METHODS[m], &rhs, 0, 1, (const double[3]){1, 0, 0}, x1);
      ck_assert_double_lt(hypot(x1[0], x1[1]), 1);
    }
  }
}
END_TEST

START_TEST(order_three_takes_all_the_stages_it_needs) {
  /* The step of a linear problem agrees with the exponential up to the cube: what is left is of order four.
   */
  for (int m = 0; m < N_METHODS; m++) {
    if (!is_of_order_three(METHODS[m])) continue;
    const double z[2] = {-0.02, -0.01};
    double factor[2];
    growth(METHODS[m], 2, z, factor);
    const double coarse = fabs(factor[0] - exp(z[0])), fine = fabs(factor[1] - exp(z[1]));
    ck_assert_double_lt(fine, 1e-9);
    ck_assert_double_eq_tol(log2(coarse / fine), 4, 0.05);
  }
}
END_TEST

START_TEST(weights_of_order_three_are_of_order_one) {
  /* Large weights that cancel would amplify what the stages do wrong.  No polynomial of order three is
   * bounded on more than 0.49 s^2 (van der Houwen's optimal polynomials tend to it). */
  const Integrator *rkc3 = integrator_get(INTEGRATOR_RKC3);
  for (int s = RKC3_MIN_STAGES; s <= RKC3_MAX_STAGES; s++) {
    double b[RKC3_MAX_STAGES], sum = 0, size = 0;
    Error error;
    ck_assert_int_eq(rkc3_weights(s, b, &error), STATUS_OK);
    for (int j = 0; j < s; j++) {
      sum += b[j];
      size += fabs(b[j]);
    }
    ck_assert_double_eq_tol(sum, 1, 1e-12);
    ck_assert_double_eq(b[1], 0);
    ck_assert_double_lt(size, 30);
    ck_assert_double_lt(rkc3->reach(s), 0.49 * s * s);
    ck_assert_double_gt(rkc3->reach(s), 0.16 * s * s);
    if (s >= 8) ck_assert_double_gt(rkc3->reach(s), 0.38 * s * s);
  }
}
END_TEST

START_TEST(all_numbers_of_stages_of_order_three_are_stable_within_reach) {
  enum { POINTS = 600 };
  const Integrator *rkc3 = integrator_get(INTEGRATOR_RKC3);
  static double z[POINTS], x0[POINTS], x1[POINTS], work[INTEGRATOR_WORK * POINTS];
  Decay decay = {POINTS, z};
  const Rhs rhs = decay_rhs(&decay);
  for (int s = RKC3_MIN_STAGES; s <= RKC3_MAX_STAGES; s++) {
    for (int i = 0; i < POINTS; i++) {
      z[i] = -rkc3->reach(s) * (i + 1) / POINTS;
      x0[i] = 1;
    }
    Error error;
    ck_assert_int_eq(rkc3->step(&rhs, s, 0, 1, x0, z, x1, work, &error), STATUS_OK);
    /* away from 0 damped by a twentieth, which also bears eigenvalues that are not quite real */
    for (int i = 0; i < POINTS; i++)
      ck_assert_double_lt(fabs(x1[i]), z[i] < -1 - 0.05 * rkc3->reach(s) ? 0.96 : 1);
  }
}
END_TEST

START_TEST(the_reach_grows_as_two_thirds_of_the_square_of_the_stages) {
  const Integrator *rkc2 = integrator_get(INTEGRATOR_RKC2);
  for (int s = rkc2->min_stages; s <= rkc2->max_stages; s++) {
    const double expected = 2.0 / 3 * ((double)s * s - 1) * (1 - 2.0 / 15 * 2.0 / 13);
    /* The formula of the source is the first order in the damping: the next is about (2/13)^2 / 10. */
    ck_assert_double_eq_tol(rkc2->reach(s) / expected, 1, 0.003);
  }
  ck_assert_double_eq(integrator_get(INTEGRATOR_RK2)->reach(2), 2);
}
END_TEST

START_TEST(the_fewest_stable_stages_are_chosen) {
  const Integrator *rkc2 = integrator_get(INTEGRATOR_RKC2);
  for (double h_rho = 0; h_rho <= rkc2->reach(rkc2->max_stages); h_rho = 1.3 * h_rho + 0.1) {
    const int s = integrator_stages(rkc2, h_rho);
    ck_assert_int_ge(s, rkc2->min_stages);
    ck_assert_double_ge(rkc2->reach(s), h_rho);
    if (s > rkc2->min_stages) ck_assert_double_lt(rkc2->reach(s - 1), h_rho);
  }
  ck_assert_int_eq(integrator_stages(rkc2, 1.001 * rkc2->reach(rkc2->max_stages)), 0);
  ck_assert_int_eq(integrator_stages(integrator_get(INTEGRATOR_RK2), 2), 2);
  ck_assert_int_eq(integrator_stages(integrator_get(INTEGRATOR_RK2), 2.001), 0);
}
END_TEST

START_TEST(each_kind_of_a_scene_has_the_integrator_of_that_name) {
  ck_assert_str_eq(integrator_get(INTEGRATOR_RK2)->name, "rk2");
  ck_assert_str_eq(integrator_get(INTEGRATOR_RKC2)->name, "rkc2");
  ck_assert_str_eq(integrator_get(INTEGRATOR_RKC3)->name, "rkc3");
}
END_TEST

int main(void) {
  return suite_run(
      "integrator",
      (SuiteTests){the_error_falls_with_the_order_of_the_method, each_stage_stands_at_its_time,
                   the_time_of_a_stage_is_the_time_that_its_positions_stand_for,
                   evaluations_stay_inside_the_step_and_number_one_less_than_the_stages,
                   a_refusal_at_any_stage_ends_the_step_with_its_message,
                   one_step_of_a_linear_problem_is_the_stability_polynomial,
                   two_chebyshev_stages_are_a_method_of_order_two_and_nothing_more,
                   everything_decays_within_reach_and_grows_a_third_beyond_it,
                   a_stiff_problem_stays_bounded_over_a_thousand_steps, what_decays_while_it_turns_decays_too,
                   order_three_takes_all_the_stages_it_needs, weights_of_order_three_are_of_order_one,
                   all_numbers_of_stages_of_order_three_are_stable_within_reach,
                   the_reach_grows_as_two_thirds_of_the_square_of_the_stages,
                   the_fewest_stable_stages_are_chosen, each_kind_of_a_scene_has_the_integrator_of_that_name,
                   NULL});
}
