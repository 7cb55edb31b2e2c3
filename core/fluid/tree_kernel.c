/* Lanes are the children of one parent, which stand together. */
#include "fluid/tree_kernel.h"

#include "base/vector_clones.h"

static inline void distances(double *const center[3], const int fan, const int *restrict parent, int n,
                             const double target[3], double *restrict distance2) {
  const double *restrict c0 = center[0], *restrict c1 = center[1], *restrict c2 = center[2];
  const double x0 = target[0], x1 = target[1], x2 = target[2];
  for (int i = 0; i < n; i++) {
    const int first = fan * parent[i];
#pragma omp simd
    for (int c = 0; c < fan; c++) {
      double r0 = c0[first + c] - x0, r1 = c1[first + c] - x1, r2 = c2[first + c] - x2;
      distance2[fan * i + c] = r0 * r0 + r1 * r1 + r2 * r2;
    }
  }
}

VECTOR_CLONES
void tree_distances(double *const center[3], int fan, const int *parent, int n, const double target[3],
                    double *distance2) {
  if (fan == 4) {
    distances(center, 4, parent, n, target, distance2);
  } else {
    distances(center, 2, parent, n, target, distance2);
  }
}
