/* The way of one target down the tree: what will do as it is, and what must be cut further. */
#ifndef CAPSELLA_FLUID_WALK_H
#define CAPSELLA_FLUID_WALK_H

#include "fluid/gather.h"
#include "fluid/surface_tree.h"

/* Points gathered: of elements and nested triangles, or nodes of their lattices; of pieces of elements. */
typedef struct {
  long long far, near;
} WalkCount;

/* Elements near a target, for the second part of its way. */
enum { NEAR_LISTED = 63 };
typedef struct {
  int n, element[NEAR_LISTED];
} NearElements;

/* Gathers all that is not near the target x_p, and lists the near elements; those that hold the node are left
 * out.  What does not fit on the list is cut into pieces on the spot.  x, q as in the last tree_update. */
void walk_far(const SurfaceTree *tree, const double *x, const double *q, int p, Gather *gather,
              NearElements *near, WalkCount *count);

/* Gathers the pieces of the near elements, which tree_cut has put in the tree. */
void walk_near(const SurfaceTree *tree, const double *x, const double *q, const NearElements *near,
               Gather *gather, WalkCount *count);

#endif
