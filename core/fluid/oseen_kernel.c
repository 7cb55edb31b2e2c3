/* A plain loop: the compiler vectorises it for each instruction set, and the divider of the machine, not the
 * memory, sets its rate (docs/benchmarks.md).  Sums are kept by lane until the end, so that short runs cost
 * no more than long ones. */
#include "fluid/oseen_kernel.h"

#include "base/vector_clones.h"

#include <math.h>

VECTOR_CLONES
void oseen_reflect(const double sign[3], const OseenBlock *restrict from, int n, OseenBlock *restrict to) {
  for (int k = 0; k < n; k++) {
    for (int c = 0; c < 3; c++) {
#pragma omp simd
      for (int i = 0; i < OSEEN_LANES; i++) {
        to[k].y[c][i] = sign[c] * from[k].y[c][i];
        to[k].f[c][i] = sign[c] * from[k].f[c][i];
      }
    }
  }
}

VECTOR_CLONES
void oseen_sum(const OseenRun *runs, int n, const double x[3], double u[3]) {
  const double x0 = x[0], x1 = x[1], x2 = x[2];
  double sum[3][OSEEN_LANES] = {{0}};
  for (int k = 0; k < n; k++) {
    const OseenBlock *end = runs[k].first + runs[k].n;
    for (const OseenBlock *block = runs[k].first; block < end; block++) {
#pragma omp simd
      for (int i = 0; i < OSEEN_LANES; i++) {
        double r0 = block->y[0][i] - x0, r1 = block->y[1][i] - x1, r2 = block->y[2][i] - x2;
        double f0 = block->f[0][i], f1 = block->f[1][i], f2 = block->f[2][i];
        double inverse = 1 / sqrt(r0 * r0 + r1 * r1 + r2 * r2);
        double s = (r0 * f0 + r1 * f1 + r2 * f2) * inverse * inverse;
        sum[0][i] += inverse * (f0 + s * r0);
        sum[1][i] += inverse * (f1 + s * r1);
        sum[2][i] += inverse * (f2 + s * r2);
      }
    }
  }
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < OSEEN_LANES; i++) u[c] += sum[c][i];
  }
}
