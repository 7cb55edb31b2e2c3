/* Shape of a closed P2 surface: volume, area, ellipsoid of inertia (paper section 5.1, figure 9). */
#ifndef CAPSELLA_OBSERVE_SHAPE_H
#define CAPSELLA_OBSERVE_SHAPE_H

#include "base/status.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

/* All dimensionless by a.  The ellipsoid has the mass and the inertia tensor of the enclosed volume: its
 * squared semi-axes are 5/V times the principal second moments.  L3 belongs to the axis nearest to the
 * vorticity axis, L1 >= L2 to the other two; L are full axis lengths (2 for the unit sphere).  Angles in the
 * plane normal to the vorticity axis count from e_x (from e_y where the vorticity axis is e_x), positive
 * towards e_x x vorticity axis: towards e_z in the simple shear v = (z, 0, 0). */
typedef struct {
  double volume, area;
  double center[3];
  double L1, L2, L3;
  double e1[3], e2[3], e3[3]; /* unit axes, right-handed; e1 at the angle beta, e3 along the vorticity axis */
  double D12;                 /* (L1 - L2)/(L1 + L2) */
  double beta;                /* angle of e1, radians, in (-pi/2, pi/2]; NAN while D12 < 1e-10 */
} Shape;

/* Volume, area and ellipsoid of positions x [n_nodes][3], which have the symmetry (NULL: none).  Volume and
 * second moments are integrated exactly (polynomial integrands of degree 4 and 8).  STATUS_REJECT when x is
 * not finite or encloses no volume. */
Status shape_measure(const Mesh *mesh, const Symmetry *symmetry, const double *x,
                     const double vorticity_axis[3], Shape *shape, Error *error);

#endif
