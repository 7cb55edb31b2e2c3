/* Elements near a target that does not lie on them: bisected until each piece is far enough for its size.
 *
 * A piece is near when dist(x, flat triangle of its corners) < factor * its longest edge.  The distance is
 * physical, so that folds and self-approach are served by the same test. */
#ifndef CAPSELLA_FLUID_NEAR_H
#define CAPSELLA_FLUID_NEAR_H

#include "fluid/pack.h"
#include "fluid/points_kernel.h"
#include <stdbool.h>

typedef struct {
  double factor;  /* 0: nothing is near */
  PieceRule rule; /* for the pieces */
} NearRule;

/* Whether the target at the origin is near the triangle with these corners. */
bool near_is_near(const double a[3], const double b[3], const double c[3], double factor);

/* Packs the point forces of a near element.  node[k] holds position minus target (0..2) and load (3..5).
 * Returns the number of points. */
int near_pack(const NearRule *near, const double node[6][6], PointPack *pack);

#endif
