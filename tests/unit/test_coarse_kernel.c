/* The sum in single precision against the one in double precision. */
#include "fluid/coarse_kernel.h"

#include "random.h"
#include "suite.h"
#include <math.h>

enum { BLOCKS = 40, NUMBERS = 6 * OSEEN_LANES };

/* Points in a cube two wide with forces of size one, and a target at least 0.1 away from all of them. */
typedef struct {
  OseenBlock block[BLOCKS];
  CoarseBlock rounded[BLOCKS];
  double x[3];
} Cloud;

static void cloud_new(Cloud *cloud, uint64_t seed) {
  for (int k = 0; k < BLOCKS; k++) random_fill(&seed, NUMBERS, &cloud->block[k].y[0][0]);
  random_fill(&seed, 3, cloud->x);
  for (int k = 0; k < BLOCKS; k++) {
    for (int i = 0; i < OSEEN_LANES; i++) {
      double r2 = 0;
      for (int c = 0; c < 3; c++) r2 += pow(cloud->block[k].y[c][i] - cloud->x[c], 2);
      if (r2 < 0.01) cloud->block[k].y[0][i] += 0.2;
    }
  }
  coarse_round(cloud->block, BLOCKS, cloud->rounded);
}

/* Sum of |f| / r, of which round-off is a share. */
static double magnitude(const Cloud *cloud) {
  double sum = 0;
  for (int k = 0; k < BLOCKS; k++) {
    for (int i = 0; i < OSEEN_LANES; i++) {
      double f2 = 0, r2 = 0;
      for (int c = 0; c < 3; c++) {
        f2 += pow(cloud->block[k].f[c][i], 2);
        r2 += pow(cloud->block[k].y[c][i] - cloud->x[c], 2);
      }
      sum += sqrt(f2 / r2);
    }
  }
  return sum;
}

START_TEST(rounding_changes_each_number_by_half_a_unit_at_most) {
  Cloud cloud;
  cloud_new(&cloud, 1);
  for (int k = 0; k < BLOCKS; k++) {
    const double *number = &cloud.block[k].y[0][0];
    const float *rounded = &cloud.rounded[k].y[0][0];
    for (int i = 0; i < NUMBERS; i++)
      ck_assert_double_le(fabs((double)rounded[i] - number[i]), 0x1p-24 * fabs(number[i]));
  }
}
END_TEST

START_TEST(single_precision_agrees_with_double_to_1e_6) {
  for (uint64_t seed = 1; seed <= 20; seed++) {
    Cloud cloud;
    cloud_new(&cloud, seed);
    const OseenRun exact_run = {cloud.block, BLOCKS};
    const CoarseRun run = {0, BLOCKS};
    double exact[3] = {0}, u[3] = {0};
    oseen_sum(&exact_run, 1, cloud.x, exact);
    coarse_sum(cloud.rounded, &run, 1, cloud.x, u);
    for (int c = 0; c < 3; c++)
      ck_assert_msg(fabs(u[c] - exact[c]) < 1e-6 * magnitude(&cloud), "seed %llu: %g instead of %g",
                    (unsigned long long)seed, u[c], exact[c]);
  }
}
END_TEST

START_TEST(runs_of_blocks_are_summed_as_they_are_listed_and_added_to_what_is_there) {
  Cloud cloud;
  cloud_new(&cloud, 7);
  const OseenRun exact_runs[] = {{cloud.block + 3, 2}, {cloud.block + 30, 1}, {cloud.block, 3}};
  const CoarseRun runs[] = {{3, 2}, {30, 1}, {0, 3}};
  double exact[3] = {1, 2, 3}, u[3] = {1, 2, 3};
  oseen_sum(exact_runs, 3, cloud.x, exact);
  coarse_sum(cloud.rounded, runs, 3, cloud.x, u);
  for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(u[c], exact[c], 1e-6 * magnitude(&cloud));
  coarse_sum(cloud.rounded, runs, 0, cloud.x, exact); /* no runs, no change */
  for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(u[c], exact[c], 1e-6 * magnitude(&cloud));
}
END_TEST

int main(void) {
  return suite_run("coarse_kernel",
                   (SuiteTests){rounding_changes_each_number_by_half_a_unit_at_most,
                                single_precision_agrees_with_double_to_1e_6,
                                runs_of_blocks_are_summed_as_they_are_listed_and_added_to_what_is_there,
                                NULL});
}
