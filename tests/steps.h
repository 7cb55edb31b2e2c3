/* Steppers on small equations, for tests: started, and taken to a time. */
#ifndef CAPSELLA_TESTS_STEPS_H
#define CAPSELLA_TESTS_STEPS_H

#include "coupling/stepper.h"
#include "ode.h"
#include <check.h>

static const IntegratorKind KINDS[] = {INTEGRATOR_RK2, INTEGRATOR_RKC2, INTEGRATOR_RKC3};
enum { N_KINDS = sizeof KINDS / sizeof *KINDS };

static inline StepperOptions automatic(IntegratorKind kind, double tolerance) {
  return (StepperOptions){.integrator = kind, .is_auto = true, .tolerance = tolerance};
}
static inline StepperOptions fixed(IntegratorKind kind, double step) {
  return (StepperOptions){.integrator = kind, .fixed_step = step, .tolerance = 1e-3};
}

/* A stepper at t = 0 that must start. */
static inline Stepper started(Rhs rhs, StepperOptions options, const double *x) {
  Stepper s;
  Error error;
  ck_assert_int_eq(stepper_new(&s, rhs, options, &error), STATUS_OK);
  const Status status = stepper_start(&s, 0, x, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return s;
}

static inline void must_propose(Stepper *s, double t_limit) {
  Error error;
  const Status status = stepper_propose(s, t_limit, NULL, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
}

static inline void go_to(Stepper *s, double t) {
  for (int k = 0; k < 1000000 && s->memory.t < t; k++) {
    must_propose(s, t);
    ck_assert_double_gt(s->t1, s->memory.t);
    ck_assert_double_le(s->t1, t);
    stepper_accept(s);
  }
}

static const double SWING_START[3] = {1, 0, 1};

#endif
