/* Steps where damage grows that positions do not show: runaway in one node of many, jumps, fixed steps. */
#include "steps.h"
#include "suite.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 10000, N = 3 * NODES };

/* One coordinate of many moves: x' = 1 before x = 0.5, from where damage d = x - 0.5 softens what holds it,
 * x' = 1/(1 - d).  With u = x - 0.5 that is u - u^2/2 = t - 0.5: full damage after half a unit of time. */
typedef struct {
  double accepted_d, trial_d;
  double jump; /* damage jumps to 1 at this x; INFINITY: it grows as above */
} Runaway;

static double damage_at(const Runaway *runaway, double x) {
  if (isfinite(runaway->jump)) return x >= runaway->jump ? 1 : 0;
  return fmin(fmax(x - 0.5, 0), 1);
}

static Status runaway_evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  (void)t;
  (void)dt;
  (void)error;
  Runaway *runaway = context;
  runaway->trial_d = fmax(runaway->accepted_d, damage_at(runaway, x[0]));
  for (int i = 1; i < N; i++) f[i] = 0;
  f[0] = isfinite(runaway->jump) ? 1 : 1 / fmax(1 - runaway->trial_d, 0.01);
  return STATUS_OK;
}

static double runaway_growth(void *context) {
  const Runaway *runaway = context;
  return runaway->trial_d - runaway->accepted_d;
}

static Rhs runaway_rhs(Runaway *runaway) {
  return (Rhs){.n = N, .context = runaway, .evaluate = runaway_evaluate, .damage_growth = runaway_growth};
}

static void accept(Stepper *s, Runaway *runaway) {
  stepper_accept(s);
  runaway->accepted_d = runaway->trial_d;
}

/* Time at which d = 0.9, from the dense output; the largest growth of a step goes to *growth. */
static double time_of_rupture(Rhs rhs, IntegratorKind kind, double tolerance, double *growth) {
  static const double zero[N];
  Runaway *runaway = rhs.context;
  Stepper s = started(rhs, automatic(kind, tolerance), zero);
  *growth = 0;
  for (;;) {
    must_propose(&s, 2);
    if (s.x1[0] >= 1.4) break;
    *growth = fmax(*growth, runaway->trial_d - runaway->accepted_d);
    accept(&s, runaway);
  }
  double before = s.memory.t, after = s.t1, x[N];
  while (after - before > 1e-12) {
    const double middle = 0.5 * (before + after);
    stepper_interpolate(&s, middle, x, NULL);
    *(x[0] >= 1.4 ? &after : &before) = middle;
  }
  stepper_free(&s);
  return after;
}

static const double EXACT_TIME = 0.5 + 0.9 - 0.405;

START_TEST(a_runaway_in_one_node_of_ten_thousand_is_followed_as_the_tolerance_says) {
  for (int k = 0; k < N_KINDS; k++)
    for (double tolerance = 1e-3; tolerance > 1e-6; tolerance *= 0.1) {
      Runaway runaway = {.jump = INFINITY};
      double growth;
      const double t = time_of_rupture(runaway_rhs(&runaway), KINDS[k], tolerance, &growth);
      ck_assert_double_le(growth, 5 * sqrt(tolerance));
      /* n steps of growth 1/n leave an error of at most 1/n^2, that is 25 tolerance */
      ck_assert_double_eq_tol(t, EXACT_TIME, 25 * tolerance);
    }
}
END_TEST

START_TEST(the_mean_over_the_nodes_alone_would_miss_it) {
  Runaway runaway = {.jump = INFINITY};
  Rhs rhs = runaway_rhs(&runaway);
  double growth;
  const double followed = time_of_rupture(rhs, INTEGRATOR_RKC2, 1e-3, &growth);
  rhs.damage_growth = NULL;
  runaway = (Runaway){.jump = INFINITY};
  const double missed = time_of_rupture(rhs, INTEGRATOR_RKC2, 1e-3, &growth);
  ck_assert_double_gt(growth, 1.5 * 5 * sqrt(1e-3));
  ck_assert_double_gt(fabs(missed - EXACT_TIME), 2 * fabs(followed - EXACT_TIME));
}
END_TEST

START_TEST(a_jump_of_damage_is_approached_down_to_steps_of_ten_tolerances) {
  static const double zero[N];
  for (int k = 0; k < N_KINDS; k++)
    for (double tolerance = 1e-3; tolerance > 1e-6; tolerance *= 0.1) {
      Runaway runaway = {.jump = 0.6180339887};
      Stepper s = started(runaway_rhs(&runaway), automatic(KINDS[k], tolerance), zero);
      double jump_step = 0;
      while (s.memory.t < 1) {
        must_propose(&s, 1);
        if (runaway.trial_d > runaway.accepted_d) jump_step = s.t1 - s.memory.t;
        accept(&s, &runaway);
      }
      ck_assert_double_gt(jump_step, 0);
      ck_assert_double_le(jump_step, 10 * tolerance);
      ck_assert_double_ge(jump_step, 0.1 * 10 * tolerance); /* and no shorter than one cut more */
      ck_assert_double_le(s.memory.error_max, tolerance);
      stepper_free(&s);
    }
}
END_TEST

START_TEST(fixed_steps_take_damage_as_it_comes) {
  static const double zero[N];
  Runaway runaway = {.jump = 0.55};
  Stepper s = started(runaway_rhs(&runaway), fixed(INTEGRATOR_RKC2, 0.1), zero);
  while (s.memory.t < 1) {
    must_propose(&s, 1);
    accept(&s, &runaway);
  }
  ck_assert_double_eq(s.memory.steps, 10);
  ck_assert_double_eq(s.memory.rejected_steps, 0);
  ck_assert_double_eq(runaway.accepted_d, 1);
  stepper_free(&s);
}
END_TEST

START_TEST(a_step_rejected_for_damage_is_told_so) {
  static const double zero[N];
  Runaway runaway = {.jump = 0.55};
  Stepper s = started(runaway_rhs(&runaway), automatic(INTEGRATOR_RKC2, 1e-4), zero);
  char *text = NULL;
  size_t length = 0;
  FILE *stream = open_memstream(&text, &length);
  ck_assert_ptr_nonnull(stream);
  Log log = {.file = stream, .quiet = true};
  while (s.memory.t < 1) {
    Error error;
    ck_assert_int_eq(stepper_propose(&s, 1, &log, &error), STATUS_OK);
    accept(&s, &runaway);
  }
  fclose(stream);
  ck_assert_ptr_nonnull(strstr(text, "damage grows by 20 times what a step may bring")); /* 1 for 0.05 */
  free(text);
  stepper_free(&s);
}
END_TEST

int main(void) {
  return suite_run("stepper_damage",
                   (SuiteTests){a_runaway_in_one_node_of_ten_thousand_is_followed_as_the_tolerance_says,
                                the_mean_over_the_nodes_alone_would_miss_it,
                                a_jump_of_damage_is_approached_down_to_steps_of_ten_tolerances,
                                fixed_steps_take_damage_as_it_comes, a_step_rejected_for_damage_is_told_so,
                                NULL});
}
