/* Blocks of consecutive elements with bounding spheres: finds the few that may be near a target, so that all
 * others can be summed in long index ranges.  Nothing is kept from one call to the next. */
#ifndef CAPSELLA_FLUID_BLOCKS_H
#define CAPSELLA_FLUID_BLOCKS_H

#include "mesh/mesh.h"
#include <stdbool.h>

/* Siblings of one refinement are numbered in fours. */
enum { BLOCK_ELEMENTS = 4 };

typedef struct {
  int n_blocks, n_elements;
  double factor;          /* of the longest edge, see near.h */
  double *element_center; /* [n_elements][3] centroid of the corners */
  double *element_reach;  /* [n_elements] a target farther from the centre is not near the element */
  double *center[3];      /* [n_blocks] each */
  double *reach2;         /* [n_blocks] squared: a target farther is near no element of the block */
} Blocks;

Status blocks_new(Blocks *blocks, const Mesh *mesh, double factor, Error *error);
void blocks_free(Blocks *blocks);

/* Bounds at positions x [n_nodes][3]. */
void blocks_update(Blocks *blocks, const Mesh *mesh, const double *x);

/* far[i] = 1 when block first + i cannot be near the target, else 0, for i < n. */
void blocks_scan(const Blocks *blocks, const double target[3], int first, int n, int *far);

/* Whether the element may be near the target (a superset of near_is_near). */
bool blocks_may_be_near(const Blocks *blocks, int element, const double target[3]);

#endif
