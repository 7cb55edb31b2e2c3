/* Shape of a closed P2 surface: volume, area, ellipsoid of inertia (paper section 5.1, figure 9). */
#ifndef CAPSELLA_OBSERVE_SHAPE_H
#define CAPSELLA_OBSERVE_SHAPE_H

#include "base/status.h"
#include "mesh/mesh.h"

/* All dimensionless by a.  The ellipsoid has the inertia tensor of the enclosed volume; L3 belongs to the
 * axis nearest to the vorticity axis, L1 >= L2 to the other two; L are full axis lengths (2 for the unit
 * sphere). */
typedef struct {
  double volume, area;
  double center[3];
  double L1, L2, L3;
  double e1[3], e2[3], e3[3]; /* unit axes; e1 has e1[0] >= 0 */
  double D12;                 /* (L1 - L2)/(L1 + L2) */
  double beta;                /* angle of e1 from e_x, radians, in (-pi/2, pi/2]; NAN while D12 < 1e-10 */
} Shape;

/* Volume, area and ellipsoid of positions x [n_nodes][3].  Volume and second moments are integrated exactly
 * (polynomial integrands of degree 4 and 8). */
Status shape_measure(const Mesh *mesh, const double *x, const double vorticity_axis[3], Shape *shape,
                     Error *error);

#endif
