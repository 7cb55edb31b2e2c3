/* The single-layer potential of Stokes flow on a closed P2 surface (paper eq. 2.2, 2.3), at its own nodes:
 *
 *   u(x_p) = 1/(8 pi) int_S J(x_p, y) q(y) dS_y,   J = 1/r + r r / r^3
 *
 * Methods (figures in docs/benchmarks.md):
 *
 *   direct     the paper's: 12 points on the elements, 6 x 6 points in polar coordinates (angle in the
 *              parametric plane) on those that hold the node
 *   fast       6 points on the elements, bisection of near ones, moments of distant groups of elements, and
 *              around the node polar coordinates in the tangent plane that integrate 1/r exactly: 1e-5 of the
 *              largest velocity
 *   reference  12 points, bisection, more points around the node, no moments: 1e-6
 *
 * The result does not depend on the number of threads, bit for bit, and only on the arguments of this call.
 */
#ifndef CAPSELLA_FLUID_SINGLE_LAYER_H
#define CAPSELLA_FLUID_SINGLE_LAYER_H

#include "base/status.h"
#include "config/scene.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

typedef struct SingleLayer SingleLayer;

/* Kernel pairs evaluated so far, by kind; machine-free cost.  far: points of whole elements and nodes that
 * carry moments; near: points of bisected elements; singular: points of elements that hold the target. */
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
