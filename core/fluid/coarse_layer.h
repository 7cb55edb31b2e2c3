/* The single layer for the inner stages of a step (docs/decisions/stages.md): as single_layer.h, to 1e-3 of
 * the largest velocity (an ellipsoid of axes 3, 1, 1/3: 1e-2) and at a fraction of the cost.  What stands for
 * what is settled where the step starts and held, so that u is a smooth function of x and q during the step;
 * sums are in single precision.
 */
#ifndef CAPSELLA_FLUID_COARSE_LAYER_H
#define CAPSELLA_FLUID_COARSE_LAYER_H

#include "base/status.h"
#include "fluid/single_layer.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

typedef struct CoarseLayer CoarseLayer;

/* The mesh and the symmetry (NULL: none) must outlive the layer. */
Status coarse_layer_new(CoarseLayer **layer, const Mesh *mesh, const Symmetry *symmetry, Error *error);
void coarse_layer_free(CoarseLayer *layer);

/* A step starts: the next evaluation settles what stands for what. */
void coarse_layer_settle(CoarseLayer *layer);

/* x, q, u [n_nodes][3], with x near to that at the start of the step.  STATUS_REJECT when x or q is not
 * finite or an element is degenerate. */
Status coarse_layer_evaluate(CoarseLayer *layer, const double *x, const double *q, double *u, Error *error);

KernelCount coarse_layer_count(const CoarseLayer *layer);

#endif
