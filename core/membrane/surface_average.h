/* Averages over the neighbourhood of each integration point on the surface at rest, for a non-local drive of
 * damage (Pijaudier-Cabot & Bazant, J. Eng. Mech. 113, 1987):
 *
 *     mean(X) = int w(|X - Y|) f(Y) dS0(Y) / int w(|X - Y|) dS0(Y),   w(r) = (1 - r^2/l^2)^2 for r < l
 *
 * with r the straight distance. */
#ifndef CAPSELLA_MEMBRANE_SURFACE_AVERAGE_H
#define CAPSELLA_MEMBRANE_SURFACE_AVERAGE_H

#include "base/status.h"
#include "mesh/symmetry.h"
#include <stddef.h>

/* A sparse matrix by rows. */
typedef struct {
  int n;
  size_t *start;  /* [n + 1] */
  int *point;     /* [start[n]] */
  double *weight; /* [start[n]] the weights of a row sum to 1 */
} SurfaceAverage;

/* Points at X [n][3], one of each orbit of the symmetry, that stand for the areas dS0 [n] of their whole
 * orbits. The images of a point count as it does. */
Status surface_average_new(SurfaceAverage *average, int n, const double *X, const double *dS0,
                           const Symmetry *symmetry, double length, Error *error);
void surface_average_free(SurfaceAverage *average);

/* mean [n] of the values f [n]. */
void surface_average_apply(const SurfaceAverage *average, const double *f, double *mean);

#endif
