/* The motion of a capsule that the flow carries, with damage: positions in a step, and a restart in its
 * midst. */
#include "run/motion.h"

#include "capsule.h"
#include "suite.h"

/* A soft capsule under strong shear, so that damage grows at once. */
static const double STRONG_SHEAR[3][3] = {{0, 0, 4}, {0, 0, 0}, {0, 0, 0}};

typedef struct {
  Capsule capsule;
  Stepper stepper;
  FlowMotion motion;
} Voyage;

static void voyage_open_with(Voyage *v, bool is_coarse, bool start) {
  const StepperOptions options = {.integrator = INTEGRATOR_RKC2, .is_auto = true, .tolerance = 1e-4};
  Error error;
  shell_open_damaged(&v->capsule.shell, 1);
  capsule_immerse(&v->capsule, STRONG_SHEAR, 0.5, FLUID_FAST, true);
  if (is_coarse) capsule_use_coarse(&v->capsule);
  ck_assert_int_eq(stepper_new(&v->stepper, system_rhs(&v->capsule.system), options, &error), STATUS_OK);
  if (start) ck_assert_int_eq(stepper_start(&v->stepper, 0, v->capsule.shell.mesh.X, &error), STATUS_OK);
  flow_motion(&v->motion, &v->capsule.system, &v->stepper);
}

static void voyage_open(Voyage *v, bool start) {
  voyage_open_with(v, false, start);
}

static void voyage_close(Voyage *v) {
  stepper_free(&v->stepper);
  capsule_close(&v->capsule);
}

static double propose(Voyage *v, double t_limit) {
  Error error;
  double t1;
  const Status status = v->motion.base.propose(&v->motion.base, t_limit, &t1, NULL, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return t1;
}

static void accept(Voyage *v) {
  v->motion.base.accept(&v->motion.base);
  membrane_commit(v->capsule.shell.membrane);
}

static void go_to(Voyage *v, double t) {
  while (v->motion.base.t < t) {
    propose(v, t);
    accept(v);
  }
}

static double largest_damage(const Voyage *v) {
  const Membrane *membrane = v->capsule.shell.membrane;
  double largest = 0;
  for (int k = 0; k < membrane_points(membrane); k++)
    largest = fmax(largest, membrane_accepted(membrane)->d[k]);
  return largest;
}

START_TEST(positions_and_velocities_are_those_of_the_stepper_at_both_ends) {
  Voyage v;
  voyage_open(&v, true);
  go_to(&v, 0.05);
  const double t1 = propose(&v, 1);
  const Motion *motion = &v.motion.base;
  const size_t bytes = (size_t)v.capsule.shell.n * sizeof(double);
  double *x = zeros(v.capsule.shell.n), *u = zeros(v.capsule.shell.n);
  motion->at(motion, motion->t, x, u);
  ck_assert_mem_eq(x, v.stepper.x, bytes);
  ck_assert_mem_eq(u, v.stepper.v, bytes);
  motion->at(motion, t1, x, u);
  ck_assert_mem_eq(x, v.stepper.x1, bytes);
  ck_assert_mem_eq(u, v.stepper.v1, bytes);
  const double middle = 0.5 * (motion->t + t1);
  motion->at(motion, middle, x, NULL);
  stepper_interpolate(&v.stepper, middle, u, NULL);
  ck_assert_mem_eq(x, u, bytes);
  free(x);
  free(u);
  voyage_close(&v);
}
END_TEST

START_TEST(the_membrane_of_a_proposal_stands_at_its_end) {
  Voyage v;
  voyage_open(&v, true);
  go_to(&v, 0.05);
  const double t1 = propose(&v, 1), t = v.motion.base.t;
  const size_t bytes = (size_t)v.capsule.shell.n * sizeof(double);
  const size_t points = (size_t)membrane_points(v.capsule.shell.membrane) * sizeof(double);
  double *R = zeros(v.capsule.shell.n), *d = malloc(points);
  memcpy(d, membrane_trial(v.capsule.shell.membrane)->d, points);
  Error error;
  ck_assert_int_eq(membrane_force(v.capsule.shell.membrane, v.stepper.x1, t, t1 - t, R, &error), STATUS_OK);
  ck_assert_mem_eq(R, v.motion.base.R, bytes);
  ck_assert_mem_eq(d, membrane_trial(v.capsule.shell.membrane)->d, points);
  free(R);
  free(d);
  voyage_close(&v);
}
END_TEST

/* What a restart keeps of the motion and of the membrane, from one to the other. */
static void restore(Voyage *to, Voyage *from) {
  RestartItem source[MOTION_RESTART_ITEMS], target[MOTION_RESTART_ITEMS];
  const size_t n = from->motion.base.restart_items(&from->motion.base, source);
  ck_assert_int_le((int)n, MOTION_RESTART_ITEMS);
  ck_assert_int_eq((int)to->motion.base.restart_items(&to->motion.base, target), (int)n);
  for (size_t i = 0; i < n; i++) {
    ck_assert_str_eq(source[i].name, target[i].name);
    if (source[i].doubles)
      memcpy(target[i].doubles, source[i].doubles, source[i].count * sizeof(double));
    else
      memcpy(target[i].integers, source[i].integers, source[i].count * sizeof(long long));
  }
  const Membrane *membrane = from->capsule.shell.membrane;
  const size_t bytes = (size_t)membrane_points(membrane) * sizeof(double);
  memcpy(membrane_restored(to->capsule.shell.membrane)->d, membrane_accepted(membrane)->d, bytes);
  memcpy(membrane_restored(to->capsule.shell.membrane)->Ymax, membrane_accepted(membrane)->Ymax, bytes);
}

/* Restarts at t: both go on to the same bits and the same counts. */
static void assert_restart(bool is_coarse, double t) {
  Voyage one, two;
  voyage_open_with(&one, is_coarse, true);
  voyage_open_with(&two, is_coarse, false);
  go_to(&one, t);
  restore(&two, &one);
  go_to(&one, 0.3);
  go_to(&two, 0.3);
  ck_assert_double_gt(largest_damage(&one), 0.01);
  const Motion *first = &one.motion.base, *second = &two.motion.base;
  const size_t bytes = (size_t)one.capsule.shell.n * sizeof(double);
  ck_assert_mem_eq(one.stepper.x, two.stepper.x, bytes);
  ck_assert_mem_eq(one.stepper.v, two.stepper.v, bytes);
  ck_assert_mem_eq(first->q, second->q, bytes);
  ck_assert_mem_eq(membrane_accepted(one.capsule.shell.membrane)->d,
                   membrane_accepted(two.capsule.shell.membrane)->d,
                   (size_t)membrane_points(one.capsule.shell.membrane) * sizeof(double));
  ck_assert_int_eq((int)first->steps(first), (int)second->steps(second));
  ck_assert_int_eq((int)first->evaluations(first), (int)second->evaluations(second));
  ck_assert_int_eq((int)first->stage_evaluations(first), (int)second->stage_evaluations(second));
  ck_assert_int_eq(first->stage_evaluations(first) > 0, is_coarse);
  ck_assert_double_eq(first->last_step, second->last_step);
  voyage_close(&one);
  voyage_close(&two);
}

START_TEST(a_restored_motion_goes_on_bitwise_the_same) {
  assert_restart(false, 0.15);
  assert_restart(true, 0.15);
}
END_TEST

START_TEST(a_motion_restored_at_its_start_goes_on_bitwise_the_same) {
  assert_restart(false, 0);
  assert_restart(true, 0);
}
END_TEST

START_TEST(looking_inside_a_step_does_not_change_what_follows) {
  /* Samples and events ask the membrane at times inside the step, and put it back to the end. */
  Voyage plain, watched;
  voyage_open(&plain, true);
  voyage_open(&watched, true);
  double *x = zeros(plain.capsule.shell.n), *v = zeros(plain.capsule.shell.n),
         *R = zeros(plain.capsule.shell.n);
  Error error;
  while (plain.motion.base.t < 0.2) {
    propose(&plain, 0.2);
    accept(&plain);
    const double t1 = propose(&watched, 0.2), t = watched.motion.base.t;
    for (int k = 1; k <= 3; k++) {
      const double now = k == 3 ? t1 : t + (t1 - t) * k / 3;
      watched.motion.base.at(&watched.motion.base, now, x, v);
      ck_assert_int_eq(membrane_force(watched.capsule.shell.membrane, x, t, now - t, R, &error), STATUS_OK);
    }
    accept(&watched);
  }
  ck_assert_mem_eq(plain.stepper.x, watched.stepper.x, (size_t)plain.capsule.shell.n * sizeof(double));
  ck_assert_mem_eq(plain.stepper.v, watched.stepper.v, (size_t)plain.capsule.shell.n * sizeof(double));
  free(x);
  free(v);
  free(R);
  voyage_close(&plain);
  voyage_close(&watched);
}
END_TEST

START_TEST(a_shortened_step_ends_on_the_dense_output) {
  Voyage v;
  voyage_open(&v, true);
  go_to(&v, 0.05);
  const double t1 = propose(&v, 1), t = 0.5 * (v.motion.base.t + t1), before = v.motion.base.t;
  double *x = zeros(v.capsule.shell.n), *u = zeros(v.capsule.shell.n);
  v.motion.base.at(&v.motion.base, t, x, u);
  v.motion.base.shorten(&v.motion.base, t);
  v.motion.base.accept(&v.motion.base);
  ck_assert_double_eq(v.motion.base.t, t);
  ck_assert_double_eq_tol(v.motion.base.last_step, t - before, 1e-16);
  ck_assert_mem_eq(v.stepper.x, x, (size_t)v.capsule.shell.n * sizeof *x);
  ck_assert_mem_eq(v.stepper.v, u, (size_t)v.capsule.shell.n * sizeof *x);
  free(x);
  free(u);
  voyage_close(&v);
}
END_TEST

int main(void) {
  return suite_run("flow_motion", (SuiteTests){positions_and_velocities_are_those_of_the_stepper_at_both_ends,
                                               the_membrane_of_a_proposal_stands_at_its_end,
                                               a_restored_motion_goes_on_bitwise_the_same,
                                               a_motion_restored_at_its_start_goes_on_bitwise_the_same,
                                               looking_inside_a_step_does_not_change_what_follows,
                                               a_shortened_step_ends_on_the_dense_output, NULL});
}
