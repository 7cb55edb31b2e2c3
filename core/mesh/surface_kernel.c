#include "mesh/surface_kernel.h"

#include "base/vector_clones.h"

#include <math.h>
#include <string.h>

static inline double slope(const double dN[6][2], int a, SurfaceBlock x, int i, int lane) {
  return dN[0][a] * x[0][i][lane] + dN[1][a] * x[1][i][lane] + dN[2][a] * x[2][i][lane] +
         dN[3][a] * x[3][i][lane] + dN[4][a] * x[4][i][lane] + dN[5][a] * x[5][i][lane];
}

static inline void normals(const double dN[6][2], SurfaceBlock x, double normal[3][SURFACE_LANES]) {
#pragma omp simd
  for (int lane = 0; lane < SURFACE_LANES; lane++) {
    double a0 = slope(dN, 0, x, 0, lane), a1 = slope(dN, 0, x, 1, lane), a2 = slope(dN, 0, x, 2, lane);
    double b0 = slope(dN, 1, x, 0, lane), b1 = slope(dN, 1, x, 1, lane), b2 = slope(dN, 1, x, 2, lane);
    normal[0][lane] = a1 * b2 - a2 * b1;
    normal[1][lane] = a2 * b0 - a0 * b2;
    normal[2][lane] = a0 * b1 - a1 * b0;
  }
}

VECTOR_CLONES
void surface_block_area_vectors(const P2Table *table, SurfaceBlock x, SurfaceBlock A) {
  double normal[3][SURFACE_LANES];
  memset(A, 0, sizeof(SurfaceBlock));
  for (int g = 0; g < table->n; g++) {
    normals(table->dN[g], x, normal);
    for (int k = 0; k < 6; k++) {
      const double share = table->weight[g] * table->N[g][k];
      for (int i = 0; i < 3; i++) {
        for (int lane = 0; lane < SURFACE_LANES; lane++) A[k][i][lane] += share * normal[i][lane];
      }
    }
  }
}

VECTOR_CLONES
void surface_block_normals(const P2Table *table, SurfaceBlock x, SurfaceBlock normal) {
  for (int k = 0; k < 6; k++) normals(table->dN[k], x, normal[k]);
}

VECTOR_CLONES
void surface_block_areas(const P2Table *table, SurfaceBlock x, double area[SURFACE_LANES]) {
  double normal[3][SURFACE_LANES];
  memset(area, 0, SURFACE_LANES * sizeof *area);
  for (int g = 0; g < table->n; g++) {
    normals(table->dN[g], x, normal);
    for (int lane = 0; lane < SURFACE_LANES; lane++) {
      double n0 = normal[0][lane], n1 = normal[1][lane], n2 = normal[2][lane];
      area[lane] += table->weight[g] * sqrt(n0 * n0 + n1 * n1 + n2 * n2);
    }
  }
}

VECTOR_CLONES
void surface_block_moments(const P2Table *table, SurfaceBlock x, const double origin[3],
                           double moment[SURFACE_MOMENTS][SURFACE_LANES]) {
  double normal[3][SURFACE_LANES];
  memset(moment, 0, SURFACE_MOMENTS * sizeof *moment);
  for (int g = 0; g < table->n; g++) {
    const double *N = table->N[g];
    normals(table->dN[g], x, normal);
    for (int lane = 0; lane < SURFACE_LANES; lane++) {
      double y[3];
      for (int i = 0; i < 3; i++) {
        y[i] = N[0] * x[0][i][lane] + N[1] * x[1][i][lane] + N[2] * x[2][i][lane] + N[3] * x[3][i][lane] +
               N[4] * x[4][i][lane] + N[5] * x[5][i][lane] - origin[i];
      }
      double flux =
          table->weight[g] * (y[0] * normal[0][lane] + y[1] * normal[1][lane] + y[2] * normal[2][lane]);
      moment[0][lane] += flux / 3;
      for (int i = 0; i < 3; i++) moment[1 + i][lane] += flux * y[i] / 4;
      moment[4][lane] += flux * y[0] * y[0] / 5;
      moment[5][lane] += flux * y[0] * y[1] / 5;
      moment[6][lane] += flux * y[0] * y[2] / 5;
      moment[7][lane] += flux * y[1] * y[1] / 5;
      moment[8][lane] += flux * y[1] * y[2] / 5;
      moment[9][lane] += flux * y[2] * y[2] / 5;
    }
  }
}
