/* Elements that hold the target: polar quadrature about the node.
 *
 * Along a ray from the node a P2 element is exactly quadratic, y - x = r (t + r c), so the offset is computed
 * without cancellation and the Jacobian r of the polar map removes the singularity. */
#ifndef CAPSELLA_FLUID_SINGULAR_H
#define CAPSELLA_FLUID_SINGULAR_H

#include "base/status.h"
#include "fluid/pack.h"
#include "fluid/points_kernel.h"
#include "mesh/mesh.h"
#include "mesh/polar.h"
#include <stdbool.h>

typedef struct {
  int n_radial, n_angular;
  bool in_tangent_plane; /* angles measured on the surface, and more of them the more it is stretched there;
                            else in the parametric plane */
} PolarScheme;

typedef struct SingularRule SingularRule;

Status singular_new(SingularRule **rule, const PolarScheme *scheme, Error *error);
void singular_free(SingularRule *rule);

/* Packs the point forces of the elements around node p; x, q [n_nodes][3].  Returns the number of points, or
 * -1 when an element has no tangent plane at the node. */
int singular_pack(const SingularRule *rule, const Mesh *mesh, const double *x, const double *q, int p,
                  PointPack *pack);

#endif
