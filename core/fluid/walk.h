/* The way of one target down the tree: what will do as it is, and what must be cut further. */
#ifndef CAPSELLA_FLUID_WALK_H
#define CAPSELLA_FLUID_WALK_H

#include "fluid/gather.h"
#include "fluid/surface_tree.h"

/* Point forces gathered: on elements, nested triangles and their lattices; on pieces of elements. */
typedef struct {
  long long far, near;
} WalkCount;

/* Gathers all elements but those that hold node p, for the target x_p.  x, q as in the last tree_update. */
void walk_gather(const SurfaceTree *tree, const double *x, const double *q, int p, Gather *gather,
                 WalkCount *count);

#endif
