/* The inner stages of a step: what the coarse rule and what it lacks at the start of the step make of the
 * velocity. */
#include "coupling/stepper.h"

#include "capsule.h"
#include "ode.h"
#include "suite.h"

static void must(Status status, const Error *error) {
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error->text);
}

START_TEST(a_stage_at_the_start_of_the_step_is_the_full_velocity) {
  Capsule capsule;
  Error error;
  capsule_open(&capsule, 2, SIMPLE_SHEAR, 0.3, true);
  capsule_use_coarse(&capsule);
  const Rhs rhs = system_rhs(&capsule.system);
  const int n = capsule.shell.n;
  double *x = zeros(n), *v = zeros(n), *stage = zeros(n);
  for (uint64_t seed = 1; seed <= 3; seed++) {
    shell_crumple(&capsule.shell, 1, 0.01, seed, x);
    system_constrain(&capsule.system, x);
    must(rhs.evaluate(&capsule.system, x, 0, 0, v, &error), &error);
    must(rhs.open_step(&capsule.system, x, 0, v, &error), &error);
    must(rhs.stage(&capsule.system, x, 0, 0, stage, &error), &error);
    /* The load is solved for anew, from the last one, to its own tolerance; v and lack are of size one. */
    ck_assert_double_lt(largest_difference(n, stage, v), 1e-12);
  }
  free(x);
  free(v);
  free(stage);
  capsule_close(&capsule);
}
END_TEST

START_TEST(stages_away_from_the_start_are_off_in_proportion_to_the_way) {
  Capsule capsule;
  Error error;
  capsule_open(&capsule, 2, SIMPLE_SHEAR, 0.3, true);
  capsule_use_coarse(&capsule);
  const Rhs rhs = system_rhs(&capsule.system);
  const int n = capsule.shell.n;
  double *start = zeros(n), *x = zeros(n), *v0 = zeros(n), *v = zeros(n), *stage = zeros(n);
  shell_crumple(&capsule.shell, 1, 0, 1, start);
  system_constrain(&capsule.system, start);
  must(rhs.evaluate(&capsule.system, start, 0, 0, v0, &error), &error);
  for (double h = 0.1; h > 0.01; h /= 2) {
    must(rhs.open_step(&capsule.system, start, 0, v0, &error), &error);
    for (int i = 0; i < n; i++) x[i] = start[i] + h * v0[i];
    must(rhs.evaluate(&capsule.system, x, 0, h, v, &error), &error);
    must(rhs.stage(&capsule.system, x, 0, h, stage, &error), &error);
    const double share = largest_difference(n, stage, v) / largest_difference(n, v, v0);
    printf("h = %g: off by %.2e of the change of v\n", h, share);
    ck_assert_double_lt(share, 0.01); /* the coarse rule is no better on so few elements */
    ck_assert_double_gt(share, 1e-6); /* it is a coarse rule that was asked */
  }
  free(start);
  free(x);
  free(v0);
  free(v);
  free(stage);
  capsule_close(&capsule);
}
END_TEST

/* Positions at t = 0.4 after `steps` steps of rkc2 on a soft capsule, with coarse inner stages or not. */
static double *after_steps(int steps, bool is_coarse) {
  Capsule capsule;
  Stepper stepper;
  Error error;
  const double end = 0.4;
  const StepperOptions options = {
      .integrator = INTEGRATOR_RKC2, .fixed_step = end / steps, .tolerance = 1e-3};
  capsule_open(&capsule, 1, SIMPLE_SHEAR, 0.3, true);
  if (is_coarse) capsule_use_coarse(&capsule);
  must(stepper_new(&stepper, system_rhs(&capsule.system), options, &error), &error);
  must(stepper_start(&stepper, 0, capsule.shell.mesh.X, &error), &error);
  while (stepper.memory.t < end) {
    must(stepper_propose(&stepper, end, NULL, &error), &error);
    stepper_accept(&stepper);
  }
  ck_assert_int_eq((int)stepper.memory.steps, steps);
  ck_assert_int_eq(capsule.system.coarse_evaluations > 0, is_coarse);
  double *x = zeros(capsule.shell.n);
  memcpy(x, stepper.x, (size_t)capsule.shell.n * sizeof *x);
  stepper_free(&stepper);
  capsule_close(&capsule);
  return x;
}

/* Down to where single precision shows, at 3e-7. */
START_TEST(coarse_stages_keep_the_second_order) {
  const int n = 3 * 162;
  double *converged = after_steps(256, false);
  double before[2] = {0, 0};
  for (int steps = 16; steps <= 64; steps *= 2) {
    for (int is_coarse = 0; is_coarse < 2; is_coarse++) {
      double *x = after_steps(steps, is_coarse);
      const double off = largest_difference(n, x, converged), ratio = before[is_coarse] / off;
      printf("%d steps, %s: off by %.2e, ratio %.2f\n", steps, is_coarse ? "coarse" : "full", off, ratio);
      if (steps > 16) ck_assert_double_eq_tol(ratio, 4, 0.4);
      before[is_coarse] = off;
      free(x);
    }
  }
  free(converged);
}
END_TEST

START_TEST(coarse_evaluations_are_counted_among_all) {
  Capsule capsule;
  Error error;
  capsule_open(&capsule, 1, SIMPLE_SHEAR, 0.3, true);
  capsule_use_coarse(&capsule);
  const Rhs rhs = system_rhs(&capsule.system);
  const int n = capsule.shell.n;
  const double *X = capsule.shell.mesh.X;
  double *v = zeros(n), *stage = zeros(n);
  must(rhs.evaluate(&capsule.system, X, 0, 0, v, &error), &error);
  must(rhs.open_step(&capsule.system, X, 0, v, &error), &error);
  for (int k = 0; k < 3; k++) must(rhs.stage(&capsule.system, X, 0, 0, stage, &error), &error);
  ck_assert_int_eq((int)capsule.system.evaluations, 5);
  ck_assert_int_eq((int)capsule.system.coarse_evaluations, 4);
  free(v);
  free(stage);
  capsule_close(&capsule);
}
END_TEST

START_TEST(stages_may_be_summed_in_full_from_some_step_on) {
  Capsule capsule;
  Error error;
  capsule_open(&capsule, 1, SIMPLE_SHEAR, 0.3, true);
  capsule_use_coarse(&capsule);
  const Rhs rhs = system_rhs(&capsule.system);
  const int n = capsule.shell.n;
  double *x = zeros(n), *v = zeros(n), *stage = zeros(n);
  shell_crumple(&capsule.shell, 1, 0, 1, x);
  must(rhs.evaluate(&capsule.system, x, 0, 0, v, &error), &error);
  ck_assert(system_sum_in_full(&capsule.system));
  ck_assert(!system_sum_in_full(&capsule.system)); /* already */
  must(rhs.open_step(&capsule.system, capsule.shell.mesh.X, 0, v, &error), &error);
  must(rhs.stage(&capsule.system, x, 0, 0, stage, &error), &error);
  ck_assert_double_lt(largest_difference(n, stage, v), 1e-8); /* as the mass solve leaves it */
  ck_assert_int_eq((int)capsule.system.coarse_evaluations, 0);
  free(x);
  free(v);
  free(stage);
  capsule_close(&capsule);
}
END_TEST

START_TEST(stages_that_are_no_capsule_are_refused) {
  Capsule capsule;
  Error error;
  capsule_open(&capsule, 1, SIMPLE_SHEAR, 0.3, true);
  capsule_use_coarse(&capsule);
  const Rhs rhs = system_rhs(&capsule.system);
  const int n = capsule.shell.n;
  double *x = zeros(n), *v = zeros(n), *stage = zeros(n);
  shell_inflate(&capsule.shell, 1.1, x);
  must(rhs.evaluate(&capsule.system, x, 0, 0, v, &error), &error);
  must(rhs.open_step(&capsule.system, x, 0, v, &error), &error);
  x[30] = NAN;
  ck_assert_int_eq(rhs.stage(&capsule.system, x, 0, 0, stage, &error), STATUS_REJECT);
  ck_assert_int_eq(rhs.open_step(&capsule.system, x, 0, v, &error), STATUS_REJECT);
  memset(x, 0, (size_t)n * sizeof *x);
  ck_assert_int_eq(rhs.stage(&capsule.system, x, 0, 0, stage, &error), STATUS_REJECT);
  shell_inflate(&capsule.shell, 1.1, x); /* and nothing of it is left over */
  must(rhs.stage(&capsule.system, x, 0, 0, stage, &error), &error);
  ck_assert_double_lt(largest_difference(n, stage, v), 1e-12);
  free(x);
  free(v);
  free(stage);
  capsule_close(&capsule);
}
END_TEST

int main(void) {
  return suite_run("system stages",
                   (SuiteTests){a_stage_at_the_start_of_the_step_is_the_full_velocity,
                                stages_away_from_the_start_are_off_in_proportion_to_the_way,
                                coarse_stages_keep_the_second_order, coarse_evaluations_are_counted_among_all,
                                stages_may_be_summed_in_full_from_some_step_on,
                                stages_that_are_no_capsule_are_refused, NULL});
}
