/* A plain loop that the compiler vectorises, as in oseen_kernel.c. */
#include "fluid/coarse_kernel.h"

#include "base/vector_clones.h"

#include <math.h>

VECTOR_CLONES
void coarse_round(const OseenBlock *restrict from, int n, CoarseBlock *restrict to) {
  enum { NUMBERS = 6 * OSEEN_LANES };
  for (int k = 0; k < n; k++) {
    const double *number = &from[k].y[0][0];
    float *rounded = &to[k].y[0][0];
#pragma omp simd
    for (int i = 0; i < NUMBERS; i++) rounded[i] = (float)number[i];
  }
}

VECTOR_CLONES
void coarse_sum(const CoarseBlock *blocks, const CoarseRun *runs, int n, const double x[3], double u[3]) {
  const float x0 = (float)x[0], x1 = (float)x[1], x2 = (float)x[2];
  float sum[3][OSEEN_LANES] = {{0}};
  for (int k = 0; k < n; k++) {
    const CoarseBlock *first = &blocks[runs[k].first], *end = first + runs[k].n;
    for (const CoarseBlock *block = first; block < end; block++) {
#pragma omp simd
      for (int i = 0; i < OSEEN_LANES; i++) {
        float r0 = block->y[0][i] - x0, r1 = block->y[1][i] - x1, r2 = block->y[2][i] - x2;
        float f0 = block->f[0][i], f1 = block->f[1][i], f2 = block->f[2][i];
        float inverse = 1 / sqrtf(r0 * r0 + r1 * r1 + r2 * r2);
        float s = (r0 * f0 + r1 * f1 + r2 * f2) * inverse * inverse;
        sum[0][i] += inverse * (f0 + s * r0);
        sum[1][i] += inverse * (f1 + s * r1);
        sum[2][i] += inverse * (f2 + s * r2);
      }
    }
  }
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < OSEEN_LANES; i++) u[c] += (double)sum[c][i];
  }
}
