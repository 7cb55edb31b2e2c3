/* The sum over point forces against the tensor written out in long double. */
#include "base/array.h"
#include "fluid/oseen_kernel.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>

enum { N = 203 }; /* no multiple of a vector length */

typedef struct {
  double value[6][N];
  OseenSources sources;
} Cloud;

static double uniform(unsigned long long *state) {
  *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
  return (double)(*state >> 11) / 9007199254740992.0 - 0.5;
}

static void cloud_fill(Cloud *cloud) {
  unsigned long long seed = 20240607;
  printf("seed %llu\n", seed);
  for (int c = 0; c < 6; c++) {
    for (int i = 0; i < N; i++) cloud->value[c][i] = uniform(&seed);
  }
  for (int c = 0; c < 3; c++) {
    cloud->sources.y[c] = cloud->value[c];
    cloud->sources.f[c] = cloud->value[c + 3];
  }
}

/* J(x, y_i) f_i by rows of the tensor. */
static void add_pair(const Cloud *cloud, int i, const double x[3], long double u[3]) {
  long double r[3], r2 = 0;
  for (int c = 0; c < 3; c++) {
    r[c] = (long double)x[c] - cloud->value[c][i];
    r2 += r[c] * r[c];
  }
  long double r1 = sqrtl(r2);
  for (int a = 0; a < 3; a++) {
    for (int b = 0; b < 3; b++) {
      u[a] += ((a == b) / r1 + r[a] * r[b] / (r1 * r2)) * cloud->value[b + 3][i];
    }
  }
}

START_TEST(sum_equals_the_tensor_written_out) {
  Cloud cloud;
  cloud_fill(&cloud);
  const double x[3] = {0.1, -0.7, 0.9};
  const int ranges[][2] = {{0, N}, {0, 0}, {5, 6}, {3, 19}, {100, N}};
  for (size_t k = 0; k < sizeof ranges / sizeof ranges[0]; k++) {
    double u[3] = {1, 2, 3};
    long double expected[3] = {1, 2, 3};
    oseen_sum(&cloud.sources, ranges[k][0], ranges[k][1], x, u);
    for (int i = ranges[k][0]; i < ranges[k][1]; i++) add_pair(&cloud, i, x, expected);
    /* 203 terms of order 1, each with a few roundings */
    for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(u[c], (double)expected[c], 1e-13);
  }
}
END_TEST

START_TEST(close_pair_keeps_its_relative_accuracy) {
  double y[3] = {1e-9, 2e-9, -2e-9}, f[3] = {3, 0, 0};
  const OseenSources pair = {{&y[0], &y[1], &y[2]}, {&f[0], &f[1], &f[2]}};
  double u[3] = {0, 0, 0};
  oseen_sum(&pair, 0, 1, (const double[3]){0, 0, 0}, u);
  /* r = 3e-9, direction (1, 2, -2)/3 */
  const double expected[3] = {(1 + 1.0 / 9) * 1e9, 2.0 / 9 * 1e9, -2.0 / 9 * 1e9};
  for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(u[c], expected[c], 1e-14 * 1e9);
}
END_TEST

START_TEST(velocity_field_of_a_point_force_has_no_divergence) {
  double y[3] = {0, 0, 0}, f[3] = {0.3, -0.5, 0.8};
  const OseenSources force = {{&y[0], &y[1], &y[2]}, {&f[0], &f[1], &f[2]}};
  const double x[3] = {0.6, 0.2, -0.9}, h = 1e-4;
  double divergence = 0;
  for (int c = 0; c < 3; c++) {
    double u[2][3] = {{0}};
    for (int side = 0; side < 2; side++) {
      double shifted[3] = {x[0], x[1], x[2]};
      shifted[c] += side ? h : -h;
      oseen_sum(&force, 0, 1, shifted, u[side]);
    }
    divergence += (u[1][c] - u[0][c]) / (2 * h);
  }
  ck_assert_double_eq_tol(divergence, 0, 1e-7); /* h^2 times a third derivative of order 1 */
}
END_TEST

START_TEST(not_a_number_is_passed_on) {
  double y[3] = {1, 0, 0}, f[3] = {NAN, 0, 0};
  const OseenSources bad = {{&y[0], &y[1], &y[2]}, {&f[0], &f[1], &f[2]}};
  double u[3] = {0, 0, 0};
  oseen_sum(&bad, 0, 1, (const double[3]){0, 0, 0}, u);
  ck_assert(isnan(u[0]));
}
END_TEST

int main(void) {
  return suite_run("oseen_kernel",
                   (SuiteTests){sum_equals_the_tensor_written_out, close_pair_keeps_its_relative_accuracy,
                                velocity_field_of_a_point_force_has_no_divergence, not_a_number_is_passed_on,
                                NULL});
}
