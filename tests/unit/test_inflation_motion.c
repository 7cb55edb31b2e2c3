/* The imposed inflation: where its steps end, where the nodes are, and what a restart keeps. */
#include "run/motion.h"

#include "shell.h"
#include "suite.h"

static const double PATH[][2] = {{0, 0.1}, {1, 0.6}, {1.5, 0.2}, {3, 0.8}};
enum { N_PATH = sizeof PATH / sizeof *PATH };

typedef struct {
  Shell shell;
  InflationMotion motion;
} Balloon;

static void balloon_open(Balloon *b, double longest) {
  Error error;
  shell_open_damaged(&b->shell, 1);
  ck_assert_int_eq(
      inflation_motion(&b->motion, &b->shell.mesh, b->shell.membrane, PATH, N_PATH, longest, &error),
      STATUS_OK);
  ck_assert_int_eq(inflation_start(&b->motion, &error), STATUS_OK);
}

static void balloon_close(Balloon *b) {
  inflation_motion_free(&b->motion);
  shell_close(&b->shell);
}

/* One step; the end of it. */
static double advance(Balloon *b, double t_limit) {
  Motion *motion = &b->motion.base;
  Error error;
  double t1;
  ck_assert_int_eq(motion->propose(motion, t_limit, &t1, NULL, &error), STATUS_OK);
  motion->accept(motion);
  membrane_commit(b->shell.membrane);
  ck_assert_double_eq(motion->t, t1);
  return t1;
}

START_TEST(alpha_follows_the_path_and_stays_at_its_ends) {
  Balloon b;
  balloon_open(&b, INFINITY);
  const double expected[][2] = {{-1, 0.1},  {0, 0.1},    {0.5, 0.35}, {1, 0.6}, {1.25, 0.4},
                                {1.5, 0.2}, {2.25, 0.5}, {3, 0.8},    {7, 0.8}};
  for (size_t i = 0; i < sizeof expected / sizeof *expected; i++)
    ck_assert_double_eq_tol(inflation_alpha(&b.motion, expected[i][0]), expected[i][1], 1e-15);
  balloon_close(&b);
}
END_TEST

START_TEST(steps_end_on_the_corners_of_the_path_and_on_the_limit) {
  const double ends[] = {1, 1.5, 2.2, 3};
  Balloon b;
  balloon_open(&b, INFINITY);
  for (int i = 0; i < 4; i++) ck_assert_double_eq(advance(&b, i < 3 ? 2.2 : 3), ends[i]);
  balloon_close(&b);
}
END_TEST

START_TEST(no_step_is_longer_than_the_longest) {
  Balloon b;
  balloon_open(&b, 0.3);
  double before = 0;
  for (int step = 0; before < 3; step++) {
    const double now = advance(&b, 3);
    ck_assert_double_le(now - before, 0.3 + 1e-15);
    ck_assert_double_eq_tol(b.motion.base.last_step, now - before, 1e-15);
    before = now;
    ck_assert_int_lt(step, 20);
  }
  ck_assert_double_eq(before, 3);
  balloon_close(&b);
}
END_TEST

START_TEST(equal_steps_reach_a_corner_without_a_crumb) {
  Balloon b;
  balloon_open(&b, 0.1); /* ten of which add up to less than one */
  for (int step = 1; step <= 10; step++) ck_assert_double_eq_tol(advance(&b, 3), 0.1 * step, 1e-12);
  ck_assert_double_eq(b.motion.base.t, 1);
  balloon_close(&b);
}
END_TEST

START_TEST(the_nodes_move_along_their_radii) {
  Balloon b;
  balloon_open(&b, 0.25);
  const Motion *motion = &b.motion.base;
  const int n = b.shell.n;
  double *x = zeros(n), *v = zeros(n), t1;
  Error error;
  advance(&b, 3); /* to 0.25, with alpha' = 0.5 */
  ck_assert_int_eq(motion->propose(&b.motion.base, 3, &t1, NULL, &error), STATUS_OK);
  const double times[] = {0.25, 0.4, 0.5};
  for (int k = 0; k < 3; k++) {
    motion->at(motion, times[k], x, v);
    for (int i = 0; i < n; i++) {
      ck_assert_double_eq_tol(x[i], (1.1 + 0.5 * times[k]) * b.shell.mesh.X[i], 1e-15);
      ck_assert_double_eq_tol(v[i], 0.5 * b.shell.mesh.X[i], 1e-15);
    }
  }
  free(x);
  free(v);
  balloon_close(&b);
}
END_TEST

START_TEST(the_velocity_at_a_corner_is_that_of_the_step) {
  Balloon b;
  balloon_open(&b, INFINITY);
  Motion *motion = &b.motion.base;
  const int n = b.shell.n;
  double *x = zeros(n), *v = zeros(n), t1;
  Error error;
  const double slopes[] = {0.5, -0.8, 0.4};
  for (int piece = 0; piece < 3; piece++) {
    ck_assert_int_eq(motion->propose(motion, 3, &t1, NULL, &error), STATUS_OK);
    motion->at(motion, motion->t, x, v);
    ck_assert_double_eq_tol(v[0], slopes[piece] * b.shell.mesh.X[0], 1e-15);
    motion->at(motion, t1, x, v);
    ck_assert_double_eq_tol(v[0], slopes[piece] * b.shell.mesh.X[0], 1e-15);
    motion->accept(motion);
    membrane_commit(b.shell.membrane);
  }
  free(x);
  free(v);
  balloon_close(&b);
}
END_TEST

START_TEST(the_load_at_the_end_of_a_step_is_the_pressure_there) {
  Balloon b;
  balloon_open(&b, INFINITY);
  const Motion *motion = &b.motion.base;
  const int n = b.shell.n;
  double power = 0, area = 0;
  advance(&b, 1); /* to alpha = 0.6 */
  const double l = 1.6, Y = 0.5 * (2 * l * l + pow(l, -4) - 3), d = (Y - Y_D) / Y_C;
  const double p = 2 * (1 - d) * (1 - pow(l, -6)) / l;
  for (int i = 0; i < n; i++) power += motion->R[i] * b.shell.mesh.X[i];
  const MembranePoints points = membrane_points_view(b.shell.membrane);
  for (int k = 0; k < membrane_points(b.shell.membrane); k++) area += points.dS0[k];
  /* R . X = dE/dlambda at frozen damage = p l^2 times the area, exactly so on the discrete sphere */
  ck_assert_double_eq_tol(power / (p * l * l * area), 1, 1e-12);
  double load = 0;
  for (int i = 0; i < n; i++) load += motion->q[i] * b.shell.mesh.X[i] / b.shell.mesh.n_nodes;
  ck_assert_double_eq_tol(load / p, 1, 0.05); /* nodal q at 80 elements */
  balloon_close(&b);
}
END_TEST

START_TEST(a_step_that_the_law_refuses_fails_since_it_cannot_be_cut) {
  SceneParameter G[] = {number("G_s", 1)};
  Shell shell;
  InflationMotion motion;
  Error error;
  shell_open_with(&shell, 0, scene_law("domain", G, 1), no_law(), MASS_PCG);
  ck_assert_int_eq(inflation_motion(&motion, &shell.mesh, shell.membrane, PATH, N_PATH, INFINITY, &error),
                   STATUS_OK);
  ck_assert_int_eq(inflation_start(&motion, &error), STATUS_OK);
  double t1;
  ck_assert_int_eq(motion.base.propose(&motion.base, 3, &t1, NULL, &error), STATUS_FAILED);
  ck_assert_int_eq(error.code, STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "I1 is beyond 1"));
  ck_assert_double_eq(motion.base.t, 0);
  inflation_motion_free(&motion);
  shell_close(&shell);
}
END_TEST

START_TEST(a_shortened_step_ends_there) {
  Balloon b;
  balloon_open(&b, INFINITY);
  Motion *motion = &b.motion.base;
  double t1;
  Error error;
  ck_assert_int_eq(motion->propose(motion, 3, &t1, NULL, &error), STATUS_OK);
  motion->shorten(motion, 0.3);
  motion->accept(motion);
  ck_assert_double_eq(motion->t, 0.3);
  ck_assert_double_eq(motion->last_step, 0.3);
  ck_assert_int_eq((int)motion->steps(motion), 1);
  balloon_close(&b);
}
END_TEST

START_TEST(a_restored_inflation_goes_on_bitwise_the_same) {
  Balloon one, two;
  balloon_open(&one, 0.2);
  balloon_open(&two, 0.2);
  while (one.motion.base.t < 0.7) advance(&one, 3);
  RestartItem from[MOTION_RESTART_ITEMS], to[MOTION_RESTART_ITEMS];
  const size_t n = one.motion.base.restart_items(&one.motion.base, from);
  ck_assert_int_eq((int)two.motion.base.restart_items(&two.motion.base, to), (int)n);
  for (size_t i = 0; i < n; i++) {
    ck_assert_str_eq(from[i].name, to[i].name);
    memcpy(to[i].doubles, from[i].doubles, from[i].count * sizeof(double));
  }
  const size_t bytes = (size_t)membrane_points(one.shell.membrane) * sizeof(double);
  memcpy(membrane_restored(two.shell.membrane)->d, membrane_accepted(one.shell.membrane)->d, bytes);
  memcpy(membrane_restored(two.shell.membrane)->Ymax, membrane_accepted(one.shell.membrane)->Ymax, bytes);
  while (one.motion.base.t < 3) {
    advance(&one, 3);
    advance(&two, 3);
    ck_assert_double_eq(one.motion.base.t, two.motion.base.t);
  }
  ck_assert_mem_eq(one.motion.base.q, two.motion.base.q, (size_t)one.shell.n * sizeof(double));
  ck_assert_mem_eq(one.motion.base.R, two.motion.base.R, (size_t)one.shell.n * sizeof(double));
  ck_assert_int_eq((int)one.motion.base.steps(&one.motion.base),
                   (int)two.motion.base.steps(&two.motion.base));
  balloon_close(&one);
  balloon_close(&two);
}
END_TEST

int main(void) {
  return suite_run(
      "inflation_motion",
      (SuiteTests){alpha_follows_the_path_and_stays_at_its_ends,
                   steps_end_on_the_corners_of_the_path_and_on_the_limit, no_step_is_longer_than_the_longest,
                   equal_steps_reach_a_corner_without_a_crumb, the_nodes_move_along_their_radii,
                   the_velocity_at_a_corner_is_that_of_the_step,
                   the_load_at_the_end_of_a_step_is_the_pressure_there,
                   a_step_that_the_law_refuses_fails_since_it_cannot_be_cut, a_shortened_step_ends_there,
                   a_restored_inflation_goes_on_bitwise_the_same, NULL});
}
