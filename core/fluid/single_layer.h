/* The single-layer potential of Stokes flow on a closed P2 surface (paper eq. 2.2, 2.3), at its own nodes:
 *
 *   u(x_p) = 1/(8 pi) int_S J(x_p, y) q(y) dS_y,   J = 1/r + r r / r^3
 *
 * Methods (design figures in docs/benchmarks.md):
 *   direct     12 points on regular elements, polar (parametric angle, 6 x 6) on the elements that hold the
 * node fast       6 points, bisection of near elements, polar in the tangent plane reference  12 points,
 * bisection, polar in the tangent plane with more points The result does not depend on the number of threads,
 * bit for bit, and only on the arguments of this call: lists kept between calls change its cost, never its
 * value. */
#ifndef CAPSELLA_FLUID_SINGLE_LAYER_H
#define CAPSELLA_FLUID_SINGLE_LAYER_H

#include "base/status.h"
#include "config/scene.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

typedef struct SingleLayer SingleLayer;

/* Kernel pairs evaluated so far, by kind; machine-free cost. */
typedef struct {
  long long far, near, singular;
} KernelCount;

/* The mesh must outlive the layer. */
Status single_layer_new(SingleLayer **layer, const Mesh *mesh, FluidMethod method, Error *error);
/* From now on x and q have this symmetry, and u is summed at one node of each orbit only.  The symmetry must
 * outlive the layer. */
void single_layer_use_symmetry(SingleLayer *layer, const Symmetry *symmetry);
void single_layer_free(SingleLayer *layer);

/* x, q, u [n_nodes][3].  STATUS_REJECT when x or q is not finite or an element is degenerate. */
Status single_layer_evaluate(SingleLayer *layer, const double *x, const double *q, double *u, Error *error);

KernelCount single_layer_count(const SingleLayer *layer);

#endif
