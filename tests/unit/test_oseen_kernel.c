/* The sum over point forces against the tensor written out in long double. */
#include "fluid/oseen_kernel.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>

enum { N_BLOCKS = 23 };

static double uniform(unsigned long long *state) {
  *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*state >> 11) / 9007199254740992.0 - 0.5;
}

static void fill(OseenBlock blocks[N_BLOCKS]) {
  unsigned long long seed = 20240607;
  printf("seed %llu\n", seed);
  for (int b = 0; b < N_BLOCKS; b++) {
    for (int i = 0; i < OSEEN_LANES; i++) {
      for (int c = 0; c < 3; c++) {
        blocks[b].y[c][i] = uniform(&seed);
        blocks[b].f[c][i] = uniform(&seed);
      }
    }
  }
}

/* A block that holds one point and its force, and repeats the point without. */
static OseenBlock single(const double y[3], const double f[3]) {
  OseenBlock block;
  for (int i = 0; i < OSEEN_LANES; i++) {
    for (int c = 0; c < 3; c++) {
      block.y[c][i] = y[c];
      block.f[c][i] = i == 0 ? f[c] : 0;
    }
  }
  return block;
}

/* J(x, y_i) f_i by rows of the tensor. */
static void add_pair(const OseenBlock *block, int i, const double x[3], long double u[3]) {
  long double r[3], r2 = 0;
  for (int c = 0; c < 3; c++) {
    r[c] = (long double)x[c] - block->y[c][i];
    r2 += r[c] * r[c];
  }
  long double r1 = sqrtl(r2);
  for (int a = 0; a < 3; a++) {
    for (int b = 0; b < 3; b++) u[a] += ((a == b) / r1 + r[a] * r[b] / (r1 * r2)) * block->f[b][i];
  }
}

START_TEST(sum_over_runs_equals_the_tensor_written_out) {
  OseenBlock blocks[N_BLOCKS];
  fill(blocks);
  const double x[3] = {0.1, -0.7, 0.9};
  const OseenRun runs[] = {{blocks, 5}, {blocks + 7, 1}, {blocks + 9, 0}, {blocks + 10, N_BLOCKS - 10}};
  for (int n = 0; n <= 4; n++) {
    double u[3] = {1, 2, 3};
    long double expected[3] = {1, 2, 3};
    oseen_sum(runs, n, x, u);
    for (int k = 0; k < n; k++) {
      for (int i = 0; i < runs[k].n * OSEEN_LANES; i++) {
        add_pair(&runs[k].first[i / OSEEN_LANES], i % OSEEN_LANES, x, expected);
      }
    }
    /* 152 terms of order 1, each with a few roundings */
    for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(u[c], (double)expected[c], 1e-13);
  }
}
END_TEST

START_TEST(sum_does_not_depend_on_where_runs_are_cut) {
  OseenBlock blocks[N_BLOCKS];
  fill(blocks);
  const double x[3] = {2, 0.3, 0};
  double whole[3] = {0, 0, 0}, cut[3] = {0, 0, 0};
  const OseenRun one = {blocks, N_BLOCKS}, two[] = {{blocks, 4}, {blocks + 4, N_BLOCKS - 4}};
  oseen_sum(&one, 1, x, whole);
  oseen_sum(two, 2, x, cut);
  ck_assert_mem_eq(whole, cut, sizeof whole);
}
END_TEST

START_TEST(close_pair_keeps_its_relative_accuracy) {
  const OseenBlock pair = single((const double[3]){1e-9, 2e-9, -2e-9}, (const double[3]){3, 0, 0});
  const OseenRun run = {&pair, 1};
  double u[3] = {0, 0, 0};
  oseen_sum(&run, 1, (const double[3]){0, 0, 0}, u);
  /* r = 3e-9, direction (1, 2, -2)/3 */
  const double expected[3] = {(1 + 1.0 / 9) * 1e9, 2.0 / 9 * 1e9, -2.0 / 9 * 1e9};
  for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(u[c], expected[c], 1e-14 * 1e9);
}
END_TEST

START_TEST(velocity_field_of_a_point_force_has_no_divergence) {
  const OseenBlock force = single((const double[3]){0, 0, 0}, (const double[3]){0.3, -0.5, 0.8});
  const OseenRun run = {&force, 1};
  const double x[3] = {0.6, 0.2, -0.9}, h = 1e-4;
  double divergence = 0;
  for (int c = 0; c < 3; c++) {
    double u[2][3] = {{0}};
    for (int side = 0; side < 2; side++) {
      double shifted[3] = {x[0], x[1], x[2]};
      shifted[c] += side ? h : -h;
      oseen_sum(&run, 1, shifted, u[side]);
    }
    divergence += (u[1][c] - u[0][c]) / (2 * h);
  }
  ck_assert_double_eq_tol(divergence, 0, 1e-7); /* h^2 times a third derivative of order 1 */
}
END_TEST

START_TEST(not_a_number_is_passed_on) {
  const OseenBlock bad = single((const double[3]){1, 0, 0}, (const double[3]){NAN, 0, 0});
  const OseenRun run = {&bad, 1};
  double u[3] = {0, 0, 0};
  oseen_sum(&run, 1, (const double[3]){0, 0, 0}, u);
  ck_assert(isnan(u[0]));
}
END_TEST

int main(void) {
  return suite_run("oseen_kernel", (SuiteTests){sum_over_runs_equals_the_tensor_written_out,
                                                sum_does_not_depend_on_where_runs_are_cut,
                                                close_pair_keeps_its_relative_accuracy,
                                                velocity_field_of_a_point_force_has_no_divergence,
                                                not_a_number_is_passed_on, NULL});
}
