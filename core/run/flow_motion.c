/* The motion of a capsule that the flow carries. */
#include "run/motion.h"

#include <math.h>
#include <string.h>

static FlowMotion *self(Motion *motion) {
  return (FlowMotion *)motion;
}
static const Stepper *stepper_of(const Motion *motion) {
  return ((const FlowMotion *)motion)->stepper;
}

static Status propose(Motion *motion, double t_limit, double *t1, Log *log, Error *error) {
  Stepper *stepper = self(motion)->stepper;
  const double corner = broken_line_corner(self(motion)->system->flow->strength, motion->t);
  const Status status = stepper_propose(stepper, fmin(t_limit, corner), log, error);
  *t1 = stepper->t1;
  return status;
}

static void at(const Motion *motion, double t, double *x, double *v) {
  const Stepper *stepper = stepper_of(motion);
  const size_t bytes = (size_t)stepper->rhs.n * sizeof *x;
  if (t == stepper->memory.t) {
    memcpy(x, stepper->x, bytes);
    if (v) memcpy(v, stepper->v, bytes);
  } else if (t == stepper->t1) {
    memcpy(x, stepper->x1, bytes);
    if (v) memcpy(v, stepper->v1, bytes);
  } else {
    stepper_interpolate(stepper, t, x, v);
  }
}

static void shorten(Motion *motion, double t) {
  stepper_shorten(self(motion)->stepper, t);
}

static void accept(Motion *motion) {
  Stepper *stepper = self(motion)->stepper;
  motion->last_step = stepper->t1 - stepper->memory.t;
  stepper_accept(stepper);
  motion->t = stepper->memory.t;
}

static size_t restart_items(Motion *motion, RestartItem *items) {
  Stepper *stepper = self(motion)->stepper;
  CoupledSystem *system = self(motion)->system;
  const size_t n = (size_t)stepper->rhs.n;
  const RestartItem list[] = {
      {.name = "x", .count = n, .doubles = stepper->x},
      {.name = "v", .count = n, .doubles = stepper->v},
      {.name = "q", .count = n, .doubles = system->q},
      {.name = "power_iteration", .count = n, .doubles = stepper->direction},
      {.name = "stepper", .count = sizeof stepper->memory / sizeof(double), .doubles = &stepper->memory.t},
      {.name = "t", .count = 1, .doubles = &motion->t},
      {.name = "last_step", .count = 1, .doubles = &motion->last_step},
      {.name = "evaluations", .count = 1, .integers = &system->evaluations},
      {.name = "coarse_evaluations", .count = 1, .integers = &system->coarse_evaluations},
  };
  memcpy(items, list, sizeof list);
  return sizeof list / sizeof *list;
}

static long long evaluations(const Motion *motion) {
  return ((const FlowMotion *)motion)->system->evaluations;
}
static long long stage_evaluations(const Motion *motion) {
  return ((const FlowMotion *)motion)->system->coarse_evaluations;
}
static long long rejected(const Motion *motion) {
  return (long long)stepper_of(motion)->memory.rejected_steps;
}
static long long steps(const Motion *motion) {
  return (long long)stepper_of(motion)->memory.steps;
}

void flow_motion(FlowMotion *motion, CoupledSystem *system, Stepper *stepper) {
  *motion = (FlowMotion){
      .base = {.propose = propose,
               .at = at,
               .shorten = shorten,
               .accept = accept,
               .restart_items = restart_items,
               .evaluations = evaluations,
               .stage_evaluations = stage_evaluations,
               .rejected = rejected,
               .steps = steps,
               .t = stepper->memory.t,
               .R = system->R,
               .q = system->q},
      .system = system,
      .stepper = stepper,
  };
}
