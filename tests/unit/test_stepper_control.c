/* The stepper on small equations: stability, dense output, invariants, restart. */
#include "steps.h"
#include "suite.h"
#include <string.h>

/* ---- stability ---- */

static const double STIFF[3] = {-100, -1, -10}, ONES[3] = {1, 1, 1};

START_TEST(a_fixed_step_beyond_the_limit_is_refused_with_the_limit) {
  Decay decay = {3, STIFF};
  Stepper s;
  Error error;
  ck_assert_int_eq(stepper_new(&s, decay_rhs(&decay), fixed(INTEGRATOR_RK2, 0.025), &error), STATUS_OK);
  ck_assert_int_eq(stepper_start(&s, 0, ONES, &error), STATUS_INPUT);
  ck_assert_int_eq(error.code, STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "0.025"));
  ck_assert_ptr_nonnull(strstr(error.text, "limit 0.0185 "));
  ck_assert_ptr_nonnull(strstr(error.text, "at most 0.018")); /* what to write instead */
  stepper_free(&s);
}
END_TEST

START_TEST(a_fixed_step_within_the_limit_runs_and_decays) {
  Decay decay = {3, STIFF};
  Stepper s = started(decay_rhs(&decay), fixed(INTEGRATOR_RK2, 0.018), ONES);
  ck_assert_double_eq_tol(stepper_stability_limit(&s), 0.02, 1e-4);
  go_to(&s, 5);
  ck_assert_double_lt(fabs(s.x[0]), 1e-8);
  ck_assert_double_eq_tol(s.x[1], exp(-5), 1e-5);
  ck_assert_double_eq(s.memory.unstable_steps, 0);
  stepper_free(&s);
}
END_TEST

START_TEST(allow_unstable_lets_the_same_step_through) {
  Decay decay = {3, STIFF};
  StepperOptions options = fixed(INTEGRATOR_RK2, 0.025);
  options.allow_unstable = true;
  Stepper s = started(decay_rhs(&decay), options, ONES);
  go_to(&s, 1);
  ck_assert_double_gt(fabs(s.x[0]), 10); /* and it shows */
  ck_assert_double_eq(s.memory.unstable_steps, 40);
  stepper_free(&s);
}
END_TEST

/* x' = -10 (1 + 2 t) x: what is stable at the start is not so later. */
static Status stiffening_evaluate(void *context, const double *x, double t, double dt, double *f,
                                  Error *error) {
  (void)context;
  (void)error;
  for (int i = 0; i < 3; i++) f[i] = -10 * (1 + 2 * (t + dt)) * x[i];
  return STATUS_OK;
}

START_TEST(a_fixed_step_that_becomes_unstable_is_stopped_on_the_way) {
  const Rhs rhs = {.n = 3, .evaluate = stiffening_evaluate};
  Stepper s =
      started(rhs, fixed(INTEGRATOR_RK2, 0.02), ONES); /* limit 0.2/(1 + 2t)/1.08: reached at t = 4.13 */
  Error error;
  Status status = STATUS_OK;
  while (status == STATUS_OK && s.memory.t < 20) {
    status = stepper_propose(&s, 20, NULL, &error);
    if (status == STATUS_OK) stepper_accept(&s);
  }
  ck_assert_int_eq(status, STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "stability limit"));
  ck_assert_double_ge(s.memory.t, 4.1);
  ck_assert_double_le(s.memory.t, 4.2 + 26 * 0.02); /* the radius is measured every 25 steps */
  stepper_free(&s);
}
END_TEST

START_TEST(automatic_steps_stay_stable_where_the_error_would_let_them_grow) {
  /* A stiff decay to zero: its error is nothing, and only stability holds the step back. */
  const Rhs rhs = {.n = 3, .evaluate = stiffening_evaluate};
  for (int k = 0; k < N_KINDS; k++) {
    Stepper s = started(rhs, automatic(KINDS[k], 1e-2), ONES);
    go_to(&s, 20);
    for (int i = 0; i < 3; i++) ck_assert_double_lt(fabs(s.x[i]), 1e-2);
    if (KINDS[k] == INTEGRATOR_RK2) /* int rho dt / 2 = 2100 at the limit; no rejection storms */
      ck_assert_double_gt(s.memory.steps, 2100);
    else /* stages take the place of steps */
      ck_assert_double_lt(s.memory.steps, 500);
    ck_assert_double_lt(s.memory.rejected_steps, 0.05 * s.memory.steps + 10);
    stepper_free(&s);
  }
}
END_TEST

START_TEST(no_automatic_step_is_longer_than_the_limit_allows) {
  /* Any error is within this tolerance: nothing else holds the step back. */
  const Rhs rhs = {.n = 3, .evaluate = stiffening_evaluate};
  for (int k = 0; k < N_KINDS; k++) {
    Stepper s = started(rhs, automatic(KINDS[k], 1e6), ONES);
    while (s.memory.t < 2) {
      must_propose(&s, 2);
      ck_assert_double_lt(s.t1 - s.memory.t, stepper_stability_limit(&s));
      stepper_accept(&s);
    }
    stepper_free(&s);
  }
}
END_TEST

START_TEST(without_any_stiffness_the_error_alone_decides) {
  double width = 1;
  const Rhs rhs = {.n = 3, .context = &width, .evaluate = pulse_evaluate}; /* does not depend on x */
  Stepper s = started(rhs, automatic(INTEGRATOR_RK2, 1e-4), (const double[3]){0, 0, 0});
  ck_assert_double_eq(stepper_stability_limit(&s), INFINITY);
  go_to(&s, 2);
  ck_assert_double_eq_tol(s.x[0], 0.5, 1e-3); /* 2 atan(1)/pi */
  stepper_free(&s);
}
END_TEST

/* ---- dense output ---- */

/* Largest error in a step of length h whose two ends are exact; of the positions, and of the velocities. */
static void dense_error(double h, double *of_x, double *of_v) {
  Stepper s = started(swing(), fixed(INTEGRATOR_RK2, h), SWING_START);
  const double t0 = 0.8;
  Error error;
  s.memory.t = t0;
  s.t1 = t0 + h;
  swing_solution(s.memory.t, s.x);
  swing_solution(s.t1, s.x1);
  swing_evaluate(NULL, s.x, s.memory.t, 0, s.v, &error);
  swing_evaluate(NULL, s.x1, s.t1, 0, s.v1, &error);
  *of_x = *of_v = 0;
  for (int k = 1; k < 16; k++) {
    const double t = t0 + h * k / 16;
    double x[3], v[3], exact_x[3], exact_v[3];
    stepper_interpolate(&s, t, x, v);
    swing_solution(t, exact_x);
    swing_evaluate(NULL, exact_x, t, 0, exact_v, &error);
    *of_x = fmax(*of_x, largest_difference(3, x, exact_x));
    *of_v = fmax(*of_v, largest_difference(3, v, exact_v));
  }
  stepper_free(&s);
}

START_TEST(between_exact_ends_the_dense_output_errs_by_h4_in_x_and_h3_in_v) {
  double x_coarse, v_coarse, x_fine, v_fine;
  dense_error(0.05, &x_coarse, &v_coarse);
  dense_error(0.025, &x_fine, &v_fine);
  ck_assert_double_eq_tol(log2(x_coarse / x_fine), 4, 0.1); /* cubic Hermite: h^4/384 x'''' */
  ck_assert_double_eq_tol(log2(v_coarse / v_fine), 3, 0.15);
}
END_TEST

START_TEST(the_dense_output_meets_both_ends) {
  Stepper s = started(swing(), automatic(INTEGRATOR_RKC2, 1e-4), SWING_START);
  go_to(&s, 0.5);
  must_propose(&s, 2);
  double x[3], v[3];
  stepper_interpolate(&s, s.memory.t, x, v);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(x[i], s.x[i], 1e-15);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(v[i], s.v[i], 1e-13); /* eps / h of the differences */
  stepper_interpolate(&s, s.t1, x, NULL);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(x[i], s.x1[i], 1e-15);
  stepper_interpolate(&s, s.t1, x, v);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(v[i], s.v1[i], 1e-13);
  stepper_free(&s);
}
END_TEST

START_TEST(a_shortened_step_ends_where_the_dense_output_says_and_the_run_goes_on_from_there) {
  Stepper s = started(swing(), automatic(INTEGRATOR_RKC2, 1e-6), SWING_START);
  go_to(&s, 0.5);
  must_propose(&s, 2);
  const double t = s.memory.t + 0.37 * (s.t1 - s.memory.t);
  double x[3], v[3], exact[3];
  stepper_interpolate(&s, t, x, v);
  stepper_shorten(&s, t);
  ck_assert_double_eq(s.t1, t);
  ck_assert_mem_eq(s.x1, x, sizeof x);
  ck_assert_mem_eq(s.v1, v, sizeof v);
  stepper_accept(&s);
  ck_assert_double_eq(s.memory.t, t);
  go_to(&s, 1);
  swing_solution(1, exact);
  ck_assert_double_lt(largest_difference(3, s.x, exact), 1e-4); /* as without the interruption */
  stepper_free(&s);
}
END_TEST

/* ---- invariants and restart ---- */

static void onto_the_circle(void *context, double *x) {
  (void)context;
  const double radius = hypot(x[0], x[1]);
  x[0] /= radius;
  x[1] /= radius;
}

START_TEST(an_invariant_of_the_equation_is_kept_at_every_end_and_in_between) {
  Rhs rhs = swing();
  rhs.constrain = onto_the_circle;
  for (int k = 0; k < N_KINDS; k++) {
    Stepper s = started(rhs, automatic(KINDS[k], 1e-3), SWING_START);
    while (s.memory.t < 2) {
      double x[3];
      must_propose(&s, 2);
      ck_assert_double_eq_tol(hypot(s.x1[0], s.x1[1]), 1, 1e-15);
      stepper_interpolate(&s, 0.3 * s.memory.t + 0.7 * s.t1, x, NULL);
      ck_assert_double_eq_tol(hypot(x[0], x[1]), 1, 1e-15);
      stepper_accept(&s);
    }
    stepper_free(&s);
  }
}
END_TEST

START_TEST(a_restored_stepper_goes_on_bitwise_the_same) {
  for (int k = 0; k < N_KINDS; k++) {
    const StepperOptions options = automatic(KINDS[k], 1e-5);
    Stepper one = started(swing(), options, SWING_START), two;
    Error error;
    go_to(&one, 0.7);
    ck_assert_int_eq(stepper_new(&two, swing(), options, &error), STATUS_OK);
    two.memory = one.memory;
    memcpy(two.x, one.x, 3 * sizeof *one.x);
    memcpy(two.v, one.v, 3 * sizeof *one.v);
    memcpy(two.direction, one.direction, 3 * sizeof *one.direction);
    go_to(&one, 2.5);
    go_to(&two, 2.5);
    ck_assert_mem_eq(two.x, one.x, 3 * sizeof *one.x);
    ck_assert_mem_eq(two.v, one.v, 3 * sizeof *one.v);
    ck_assert_mem_eq(&two.memory, &one.memory, sizeof one.memory);
    ck_assert_double_gt(one.memory.steps, 60); /* with radii measured in between */
    stepper_free(&one);
    stepper_free(&two);
  }
}
END_TEST

int main(void) {
  return suite_run(
      "stepper_control",
      (SuiteTests){
          a_fixed_step_beyond_the_limit_is_refused_with_the_limit,
          a_fixed_step_within_the_limit_runs_and_decays, allow_unstable_lets_the_same_step_through,
          a_fixed_step_that_becomes_unstable_is_stopped_on_the_way,
          automatic_steps_stay_stable_where_the_error_would_let_them_grow,
          no_automatic_step_is_longer_than_the_limit_allows, without_any_stiffness_the_error_alone_decides,
          between_exact_ends_the_dense_output_errs_by_h4_in_x_and_h3_in_v, the_dense_output_meets_both_ends,
          a_shortened_step_ends_where_the_dense_output_says_and_the_run_goes_on_from_there,
          an_invariant_of_the_equation_is_kept_at_every_end_and_in_between,
          a_restored_stepper_goes_on_bitwise_the_same, NULL});
}
