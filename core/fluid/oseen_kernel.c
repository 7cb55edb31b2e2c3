/* Plain loops: the compiler vectorises them for each instruction set, and the divider of the machine, not
 * the memory, sets their rate (docs/benchmarks.md). */
#include "fluid/oseen_kernel.h"

#include "fluid/clones.h"

#include <math.h>

TARGET_CLONES
void oseen_sum(const OseenSources *sources, int first, int last, const double x[3], double u[3]) {
  const double *restrict y0 = sources->y[0], *restrict y1 = sources->y[1], *restrict y2 = sources->y[2];
  const double *restrict f0 = sources->f[0], *restrict f1 = sources->f[1], *restrict f2 = sources->f[2];
  const double x0 = x[0], x1 = x[1], x2 = x[2];
  double u0 = 0, u1 = 0, u2 = 0;
  for (int i = first; i < last; i++) {
    double r0 = y0[i] - x0, r1 = y1[i] - x1, r2 = y2[i] - x2;
    double inverse = 1 / sqrt(r0 * r0 + r1 * r1 + r2 * r2);
    double s = (r0 * f0[i] + r1 * f1[i] + r2 * f2[i]) * inverse * inverse;
    u0 += inverse * (f0[i] + s * r0);
    u1 += inverse * (f1[i] + s * r1);
    u2 += inverse * (f2[i] + s * r2);
  }
  u[0] += u0;
  u[1] += u1;
  u[2] += u2;
}

/* Sums are kept by lane until the end: each step is then one operation on whole vectors. */
TARGET_CLONES
void oseen_sum_blocks(const OseenBlock *const *blocks, int n, const double x[3], double u[3]) {
  double sum[3][OSEEN_LANES] = {{0}};
  for (int k = 0; k < n; k++) {
    const OseenBlock *block = blocks[k];
#pragma omp simd
    for (int i = 0; i < OSEEN_LANES; i++) {
      double r0 = block->y[0][i] - x[0], r1 = block->y[1][i] - x[1], r2 = block->y[2][i] - x[2];
      double f0 = block->f[0][i], f1 = block->f[1][i], f2 = block->f[2][i];
      double inverse = 1 / sqrt(r0 * r0 + r1 * r1 + r2 * r2);
      double s = (r0 * f0 + r1 * f1 + r2 * f2) * inverse * inverse;
      sum[0][i] += inverse * (f0 + s * r0);
      sum[1][i] += inverse * (f1 + s * r1);
      sum[2][i] += inverse * (f2 + s * r2);
    }
  }
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < OSEEN_LANES; i++) u[c] += sum[c][i];
  }
}
