/* Lanes are nodes of the lattice. */
#include "fluid/moment_kernel.h"

#include "base/vector_clones.h"

VECTOR_CLONES
double moment_add(const double weight[][LATTICE_LANES], int n, const OseenBlock *restrict from,
                  OseenBlock *restrict moments) {
  double largest = 0;
  for (int i = 0; i < n; i++) {
    const OseenBlock *source = &from[i / OSEEN_LANES];
    const int at = i % OSEEN_LANES;
    const double f0 = source->f[0][at], f1 = source->f[1][at], f2 = source->f[2][at];
    double y0 = -source->y[0][at], y1 = -source->y[1][at], y2 = -source->y[2][at];
    for (int block = 0; block < LATTICE_BLOCKS; block++) {
      OseenBlock *lattice = &moments[block];
      const double *w = &weight[i][block * OSEEN_LANES];
#pragma omp simd reduction(+ : y0, y1, y2)
      for (int k = 0; k < OSEEN_LANES; k++) {
        y0 += w[k] * lattice->y[0][k];
        y1 += w[k] * lattice->y[1][k];
        y2 += w[k] * lattice->y[2][k];
        lattice->f[0][k] += w[k] * f0;
        lattice->f[1][k] += w[k] * f1;
        lattice->f[2][k] += w[k] * f2;
      }
    }
    double distance2 = y0 * y0 + y1 * y1 + y2 * y2;
    largest = distance2 > largest ? distance2 : largest;
  }
  return largest;
}
