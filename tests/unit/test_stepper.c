/* The stepper on small equations with known solutions: landing, error control, refusals. */
#include "steps.h"
#include "suite.h"
#include <string.h>

/* ---- landing ---- */

START_TEST(steps_land_exactly_on_the_times_asked_for) {
  const double times[] = {0.1, 1.0 / 3, 0.35, 0.7, 1, 1 + 1e-9, 2.2};
  for (int k = 0; k < N_KINDS; k++)
    for (int is_auto = 0; is_auto < 2; is_auto++) {
      Stepper s = started(swing(), is_auto ? automatic(KINDS[k], 1e-4) : fixed(KINDS[k], 0.01), SWING_START);
      for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        go_to(&s, times[i]);
        ck_assert_double_eq(s.memory.t, times[i]);
      }
      stepper_free(&s);
    }
}
END_TEST

START_TEST(a_fixed_step_divides_an_interval_into_equal_parts) {
  for (int k = 0; k < N_KINDS; k++) {
    Stepper s = started(swing(), fixed(KINDS[k], 0.1), SWING_START);
    while (s.memory.t < 3) {
      must_propose(&s, 3);
      ck_assert_double_eq_tol(s.t1 - s.memory.t, 0.1, 1e-12); /* no crumb at the end from round-off */
      stepper_accept(&s);
    }
    ck_assert_double_eq(s.memory.steps, 30);
    stepper_free(&s);
  }
}
END_TEST

START_TEST(the_last_step_before_a_landing_is_no_crumb) {
  Stepper s = started(swing(), automatic(INTEGRATOR_RK2, 1e-4), SWING_START);
  for (int landing = 1; landing <= 20; landing++) {
    double longest = 0, shortest = INFINITY;
    while (s.memory.t < 0.1 * landing) {
      must_propose(&s, 0.1 * landing);
      const double h = s.t1 - s.memory.t;
      longest = fmax(longest, h);
      shortest = fmin(shortest, h);
      stepper_accept(&s);
    }
    /* left < 2 h is halved, which leaves at least h/2; the controller may shrink from one to the next */
    ck_assert_double_ge(shortest, 0.3 * longest);
  }
  stepper_free(&s);
}
END_TEST

/* ---- what the right-hand side is asked ---- */

typedef struct {
  double accepted_t, asked_t, asked_dt, asked_x[3];
  bool came_from_elsewhere;
} Protocol;

static Status protocol_evaluate(void *context, const double *x, double t, double dt, double *f,
                                Error *error) {
  Protocol *p = context;
  if (t != p->accepted_t) p->came_from_elsewhere = true;
  p->asked_t = t;
  p->asked_dt = dt;
  memcpy(p->asked_x, x, sizeof p->asked_x);
  return swing_evaluate(NULL, x, t, dt, f, error);
}

START_TEST(evaluations_start_from_the_accepted_time_and_the_last_is_at_the_end_of_the_step) {
  /* A law with memory sees both times, and its trial state must belong to the end of the step. */
  for (int k = 0; k < N_KINDS; k++) {
    Protocol p = {0};
    const Rhs rhs = {.n = 3, .context = &p, .evaluate = protocol_evaluate};
    Stepper s = started(rhs, automatic(KINDS[k], 1e-5), SWING_START);
    while (s.memory.t < 2) {
      p.accepted_t = s.memory.t;
      must_propose(&s, 2);
      ck_assert_double_eq_tol(p.asked_t + p.asked_dt, s.t1, 1e-15); /* one rounding */
      ck_assert_mem_eq(p.asked_x, s.x1, sizeof p.asked_x);
      stepper_accept(&s);
    }
    ck_assert_double_gt(s.memory.steps, 30); /* the radius was measured again on the way */
    ck_assert(!p.came_from_elsewhere);
    stepper_free(&s);
  }
}
END_TEST

/* ---- a cheaper rule for inner stages ---- */

/* The swing with a cheap rule that is exact at the start of the step and falls behind by `slope` times the
 * way from there; it counts what it is asked. */
typedef struct {
  double slope, x0[3], t0;
  long evaluations, stages, opened;
  Status refuse_open;
} Cheap;

static Status cheap_evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  ((Cheap *)context)->evaluations++;
  return swing_evaluate(NULL, x, t, dt, f, error);
}

static Status cheap_open(void *context, const double *x, double t, const double *f, Error *error) {
  Cheap *cheap = context;
  double exact[3];
  cheap->opened++;
  if (cheap->refuse_open != STATUS_OK) return error_set(error, cheap->refuse_open, "no place to start from");
  swing_evaluate(NULL, x, t, 0, exact, error);
  ck_assert_double_lt(largest_difference(3, exact, f), 1e-14);
  memcpy(cheap->x0, x, sizeof cheap->x0);
  cheap->t0 = t;
  return STATUS_OK;
}

static Status cheap_stage(void *context, const double *x, double t, double dt, double *f, Error *error) {
  Cheap *cheap = context;
  cheap->stages++;
  ck_assert_double_eq(t, cheap->t0); /* the step was opened where it starts */
  swing_evaluate(NULL, x, t, dt, f, error);
  for (int i = 0; i < 3; i++) f[i] += cheap->slope * (x[i] - cheap->x0[i]);
  return STATUS_OK;
}

static Rhs cheap_rhs(Cheap *cheap) {
  return (Rhs){
      .n = 3, .context = cheap, .evaluate = cheap_evaluate, .open_step = cheap_open, .stage = cheap_stage};
}

START_TEST(a_step_is_opened_once_and_evaluated_in_full_once) {
  Cheap cheap = {.slope = 0.01};
  Stepper s = started(cheap_rhs(&cheap), automatic(INTEGRATOR_RKC2, 1e-4), SWING_START);
  ck_assert_int_eq((int)cheap.evaluations, 1);
  ck_assert_int_eq((int)cheap.opened, 1); /* the radius is measured by the cheap rule */
  ck_assert_int_gt((int)cheap.stages, 2);
  go_to(&s, 2);
  ck_assert_double_gt(s.memory.steps, 30); /* the radius was measured again on the way */
  const double trials = s.memory.steps + s.memory.rejected_steps;
  ck_assert_double_eq((double)cheap.evaluations, 1 + trials);
  ck_assert_double_eq((double)cheap.opened,
                      1 + s.memory.steps); /* a rejected trial stands on the same start */
  stepper_free(&s);
}
END_TEST

/* A cheap rule that falls behind by c times the way adds c h^2 / 2 to the end of the step, which the estimate
 * counts 0.8 times: it is none of a method of order two. */
START_TEST(the_error_of_a_step_sees_what_the_cheap_rule_lacks) {
  const double h = 0.05, slopes[] = {0.1, 0.3, 1};
  for (size_t k = 0; k < sizeof slopes / sizeof *slopes; k++) {
    Cheap exact = {0}, cheap = {.slope = slopes[k]};
    Cheap *const rules[] = {&exact, &cheap};
    double end[2][3], estimate[2];
    for (int is_cheap = 0; is_cheap < 2; is_cheap++) {
      Stepper s =
          started(cheap_rhs(rules[is_cheap]), automatic(INTEGRATOR_RKC2, 1), (const double[3]){1, 0, 1});
      s.memory.h_next = h;
      must_propose(&s, 1);
      ck_assert_double_eq(s.t1, h);
      memcpy(end[is_cheap], s.x1, sizeof s.x1[0] * 3);
      estimate[is_cheap] = s.memory.error_before;
      stepper_free(&s);
    }
    const double added = largest_difference(3, end[1], end[0]);
    ck_assert_double_eq_tol(added / (0.5 * slopes[k] * h * h), 1, 0.05);
    ck_assert_double_ge(estimate[1], 0.75 * added - estimate[0]);
    ck_assert_double_le(estimate[1], 0.85 * added + estimate[0]);
  }
}
END_TEST

/* ---- the error ---- */

static double swing_error(IntegratorKind kind, double tolerance) {
  double exact[3];
  Stepper s = started(swing(), automatic(kind, tolerance), SWING_START);
  go_to(&s, 2);
  swing_solution(2, exact);
  const double error = largest_difference(3, s.x, exact);
  ck_assert_double_le(s.memory.rejected_steps, 0.1 * s.memory.steps + 3); /* the controller foresees */
  stepper_free(&s);
  return error;
}

START_TEST(the_error_follows_the_tolerance) {
  /* What is held to the tolerance goes as h^3, and the error of a run as h to the order of the method: with
   * each decade a factor of 4.6 for order 2 and of 10 for order 3, here within what rounding the number of
   * steps leaves. */
  for (int k = 0; k < N_KINDS; k++) {
    const double factor = KINDS[k] == INTEGRATOR_RKC3 ? 10 : 4.64;
    double before = swing_error(KINDS[k], 1e-3);
    ck_assert_double_lt(before, 0.1);
    for (double tolerance = 1e-4; tolerance > 1e-8; tolerance *= 0.1) {
      const double now = swing_error(KINDS[k], tolerance);
      ck_assert_double_gt(before / now, 0.65 * factor);
      ck_assert_double_lt(before / now, 1.5 * factor);
      before = now;
    }
  }
}
END_TEST

START_TEST(a_sudden_pulse_is_noticed_and_resolved) {
  double width = 1e-3;
  const Rhs rhs = {.n = 3, .context = &width, .evaluate = pulse_evaluate};
  for (int k = 0; k < N_KINDS; k++) {
    Stepper s = started(rhs, automatic(KINDS[k], 1e-5), (const double[3]){0, 0, 0});
    go_to(&s, 2);
    ck_assert_double_gt(s.memory.rejected_steps, 0);
    ck_assert_double_eq_tol(s.x[0], 1 - 2 * width / 3.14159265358979323846, 1e-3);
    stepper_free(&s);
  }
}
END_TEST

START_TEST(the_error_of_a_step_is_the_root_mean_square_over_the_nodes) {
  /* For x' = k x the midpoint rule gives 0.8 (x0 - x1) + 0.4 h (v0 + v1) = (k h)^3 / 5 exactly. */
  const double rate[6] = {-1, -2, -3, 0, 0, 0}, h = 0.01, tolerance = 1e-4;
  const double square = (1 + 64 + 729) * pow(0.2 * h * h * h, 2);
  for (int nodes = 1; nodes <= 2; nodes++) { /* a second one rests */
    Decay decay = {3 * nodes, rate};
    Stepper s =
        started(decay_rhs(&decay), automatic(INTEGRATOR_RK2, tolerance), (const double[6]){1, 1, 1, 1, 1, 1});
    must_propose(&s, h);
    ck_assert_double_eq_tol(s.memory.error_before * tolerance / sqrt(square / nodes), 1, 1e-9); /* eps/e */
    stepper_free(&s);
  }
}
END_TEST

/* ---- rejection ---- */

START_TEST(a_rejected_trial_leaves_the_accepted_state_bitwise_alone) {
  for (int k = 0; k < N_KINDS; k++) {
    Watch w = watch(swing());
    w.code = STATUS_REJECT;
    Stepper s = started(watched(&w), automatic(KINDS[k], 1e-4), SWING_START);
    go_to(&s, 0.5);
    double x[3], v[3];
    memcpy(x, s.x, sizeof x);
    memcpy(v, s.v, sizeof v);
    const StepperMemory before = s.memory;
    w.first = w.calls + 1;
    w.last = w.calls + 3;
    must_propose(&s, 2);
    ck_assert_double_gt(s.memory.rejected_steps, before.rejected_steps);
    ck_assert_mem_eq(s.x, x, sizeof x);
    ck_assert_mem_eq(s.v, v, sizeof v);
    ck_assert_double_eq(s.memory.t, before.t);
    ck_assert_double_eq(s.memory.steps, before.steps);
    stepper_free(&s);
  }
}
END_TEST

START_TEST(a_wall_is_approached_with_ever_smaller_steps_and_then_named) {
  for (int k = 0; k < N_KINDS; k++) {
    Watch w = watch(swing());
    w.code = STATUS_REJECT;
    w.beyond = 0.5;
    Stepper s = started(watched(&w), automatic(KINDS[k], 1e-4), SWING_START);
    Error error;
    Status status = STATUS_OK;
    for (int step = 0; step < 1000 && status == STATUS_OK; step++) {
      status = stepper_propose(&s, 1, NULL, &error);
      if (status == STATUS_OK) stepper_accept(&s);
    }
    ck_assert_int_eq(status, STATUS_FAILED);
    ck_assert_int_eq(error.code, STATUS_FAILED);
    ck_assert_ptr_nonnull(strstr(error.text, "the door is closed"));
    ck_assert_ptr_nonnull(strstr(error.text, "t = 0.5"));
    ck_assert_double_le(s.memory.t, 0.5);
    ck_assert_double_eq_tol(s.memory.t, 0.5, 1e-8);
    ck_assert(!s.has_proposal);
    stepper_free(&s);
  }
}
END_TEST

START_TEST(a_fixed_step_that_is_rejected_ends_the_run_with_the_cause) {
  Watch w = watch(swing());
  w.code = STATUS_REJECT;
  w.beyond = 0.5;
  Stepper s = started(watched(&w), fixed(INTEGRATOR_RK2, 0.2), SWING_START);
  go_to(&s, 0.4);
  Error error;
  ck_assert_int_eq(stepper_propose(&s, 1, NULL, &error), STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "fixed step 0.2"));
  ck_assert_ptr_nonnull(strstr(error.text, "the door is closed"));
  stepper_free(&s);
}
END_TEST

START_TEST(a_failure_that_no_smaller_step_can_cure_ends_at_once) {
  Watch w = watch(swing());
  w.code = STATUS_MEMORY;
  Stepper s = started(watched(&w), automatic(INTEGRATOR_RKC2, 1e-4), SWING_START);
  w.first = w.calls + 1;
  w.last = w.first + 1000;
  Error error;
  ck_assert_int_eq(stepper_propose(&s, 1, NULL, &error), STATUS_MEMORY);
  ck_assert_int_eq((int)(w.calls - w.first), 0); /* asked once */
  ck_assert_str_eq(error.text, "the door is closed");
  stepper_free(&s);
}
END_TEST

/* Not a number in one node of two, for one evaluation. */
typedef struct {
  int node;
  long calls, bad_call;
} Blank;

static Status blank_evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  Blank *blank = context;
  swing_evaluate(NULL, x, t, dt, f, error);
  swing_evaluate(NULL, x + 3, t, dt, f + 3, error);
  if (++blank->calls == blank->bad_call) f[3 * blank->node] = NAN;
  return STATUS_OK;
}

START_TEST(a_value_that_is_not_a_number_rejects_the_step_whichever_node_holds_it) {
  for (int k = 0; k < N_KINDS; k++)
    for (int node = 0; node < 2; node++) {
      Blank blank = {.node = node};
      const Rhs rhs = {.n = 6, .context = &blank, .evaluate = blank_evaluate};
      Stepper s = started(rhs, automatic(KINDS[k], 1e-4), (const double[6]){1, 0, 1, 1, 0, 1});
      go_to(&s, 0.5);
      const double rejected = s.memory.rejected_steps;
      blank.bad_call = blank.calls + 1;
      must_propose(&s, 1);
      ck_assert_double_eq(s.memory.rejected_steps, rejected + 1);
      for (int i = 0; i < 6; i++) ck_assert(isfinite(s.x1[i]) && isfinite(s.v1[i]));
      stepper_free(&s);
    }
}
END_TEST

START_TEST(an_equation_without_values_ends_in_a_failure_and_not_in_a_loop) {
  for (int k = 0; k < N_KINDS; k++)
    for (int is_auto = 0; is_auto < 2; is_auto++) {
      const double nowhere[3] = {NAN, NAN, NAN};
      Decay decay = {3, nowhere};
      const StepperOptions options = is_auto ? automatic(KINDS[k], 1e-4) : fixed(KINDS[k], 0.1);
      Stepper s;
      Error error;
      ck_assert_int_eq(stepper_new(&s, decay_rhs(&decay), options, &error), STATUS_OK);
      Status status = stepper_start(&s, 0, SWING_START, &error);
      if (status == STATUS_OK) status = stepper_propose(&s, 1, NULL, &error);
      ck_assert_int_ne(status, STATUS_OK);
      stepper_free(&s);
    }
}
END_TEST

START_TEST(an_inadmissible_start_is_refused_with_its_cause) {
  Watch w = watch(swing());
  w.code = STATUS_REJECT;
  w.beyond = -1;
  Stepper s;
  Error error;
  ck_assert_int_eq(stepper_new(&s, watched(&w), automatic(INTEGRATOR_RK2, 1e-4), &error), STATUS_OK);
  ck_assert_int_ne(stepper_start(&s, 0, SWING_START, &error), STATUS_OK);
  ck_assert_str_eq(error.text, "the door is closed");
  stepper_free(&s);
}
END_TEST

int main(void) {
  return suite_run(
      "stepper", (SuiteTests){steps_land_exactly_on_the_times_asked_for,
                              a_fixed_step_divides_an_interval_into_equal_parts,
                              the_last_step_before_a_landing_is_no_crumb,
                              evaluations_start_from_the_accepted_time_and_the_last_is_at_the_end_of_the_step,
                              a_step_is_opened_once_and_evaluated_in_full_once,
                              the_error_of_a_step_sees_what_the_cheap_rule_lacks,
                              the_error_follows_the_tolerance, a_sudden_pulse_is_noticed_and_resolved,
                              the_error_of_a_step_is_the_root_mean_square_over_the_nodes,
                              a_rejected_trial_leaves_the_accepted_state_bitwise_alone,
                              a_wall_is_approached_with_ever_smaller_steps_and_then_named,
                              a_fixed_step_that_is_rejected_ends_the_run_with_the_cause,
                              a_failure_that_no_smaller_step_can_cure_ends_at_once,
                              a_value_that_is_not_a_number_rejects_the_step_whichever_node_holds_it,
                              an_equation_without_values_ends_in_a_failure_and_not_in_a_loop,
                              an_inadmissible_start_is_refused_with_its_cause, NULL});
}
