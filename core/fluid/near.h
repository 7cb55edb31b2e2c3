/* Elements near a target that does not lie on them: bisected until each piece is far enough for its size.
 *
 * A piece is near when the target is closer to the centroid of its corners than a given number of its radii
 * of gyration.  The distance is physical, so that folds and self-approach are served by the same test. */
#ifndef CAPSELLA_FLUID_NEAR_H
#define CAPSELLA_FLUID_NEAR_H

#include "fluid/gather.h"
#include "fluid/piece_tree.h"
#include <stdbool.h>

/* Gathers the point forces of element e.  Returns the number of points, and in *is_near whether the element
 * was cut. */
int near_gather(const PieceTree *tree, int e, const double *x, const double *q, Gather *gather,
                bool *is_near);

#endif
