/* Elements that hold the target: polar quadrature about the node.
 *
 * Along a ray from the node a P2 element is exactly quadratic, y - x = r (t + r c), and the Jacobian r of the
 * polar map removes the singularity. */
#ifndef CAPSELLA_FLUID_SINGULAR_H
#define CAPSELLA_FLUID_SINGULAR_H

#include "base/status.h"
#include "fluid/gather.h"
#include "mesh/mesh.h"

typedef enum {
  POLAR_PARAMETRIC, /* Gauss points in the angle of the (xi, eta) plane */
  POLAR_TANGENT     /* Gauss points in the tangent plane, where 1/r is integrated exactly */
} PolarPlane;

typedef struct {
  PolarPlane plane;
  int n_radial, n_angular;
  int n_angular_long; /* POLAR_TANGENT: for triangles much longer than high as seen from the node */
} PolarScheme;

typedef struct SingularRule SingularRule;

Status singular_new(SingularRule **rule, const PolarScheme *scheme, Error *error);
void singular_free(SingularRule *rule);

/* Gathers the point forces of the elements around node p; x, q [n_nodes][3].  Returns the number of points,
 * or -1 when an element has no tangent plane at the node. */
int singular_gather(const SingularRule *rule, const Mesh *mesh, const double *x, const double *q, int p,
                    Gather *gather);

#endif
