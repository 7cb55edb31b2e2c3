/* Shapes that come near to themselves, for tests: the unit sphere moved by maps whose gap is known. */
#ifndef CAPSELLA_TESTS_NEAR_SHAPES_H
#define CAPSELLA_TESTS_NEAR_SHAPES_H

#include "mesh/mesh.h"
#include <math.h>

typedef void NearShape(double gap, const double X[3], double x[3]);

/* A disc of radius 1, 0.8 thick at a radius of 0.7 and `gap` thick in the middle, on the z axis; negative:
 * its faces have passed through each other there.  The film is of what is inside. */
static inline void biconcave_disc(double gap, const double X[3], double x[3]) {
  const double r2 = X[0] * X[0] + X[1] * X[1];
  x[0] = X[0];
  x[1] = X[1];
  x[2] = X[2] * (0.5 * gap + r2 - 0.6 * r2 * r2);
}

/* A rod 0.7 thick bent along a circle of radius 0.8 until its tips, at (0, 0, 1.6), are `gap` apart;
 * negative: they have passed through each other.  The film is of what is outside. */
static inline void bent_rod(double gap, const double X[3], double x[3]) {
  const double R = 0.8, angle = (3.14159265358979323846 - asin(0.5 * gap / R)) * X[0];
  x[0] = (R - 0.35 * X[2]) * sin(angle);
  x[1] = 0.35 * X[1];
  x[2] = R - (R - 0.35 * X[2]) * cos(angle);
}

/* x [n_nodes][3] */
static inline void near_shape(NearShape *shape, double gap, const Mesh *mesh, double *x) {
  for (int p = 0; p < mesh->n_nodes; p++) shape(gap, mesh->X + 3 * p, x + 3 * p);
}

#endif
