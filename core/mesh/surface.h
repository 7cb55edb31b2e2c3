/* Geometry of a closed P2 surface at given node positions. */
#ifndef CAPSELLA_MESH_SURFACE_H
#define CAPSELLA_MESH_SURFACE_H

#include "mesh/mesh.h"
#include "mesh/symmetry.h"

/* Where a symmetry is given, which positions and fields then have, one element of each orbit is visited;
 * NULL: all are. */

/* Enclosed volume (exact: the integrand x . (a1 x a2) is a polynomial of degree 4) and area, x [n_nodes][3].
 */
double surface_volume(const Mesh *mesh, const double *x);
double surface_area(const Mesh *mesh, const Symmetry *symmetry, const double *x);

/* Moments of the enclosed volume about a point, exact, by the divergence theorem: with y = x - origin,
 * div y = 3, div (y y_i) = 4 y_i, div (y y_i y_j) = 5 y_i y_j.  The symmetry leaves the origin where it is.
 */
typedef struct {
  double volume;
  double first[3];
  double second[6]; /* xx, xy, xz, yy, yz, zz */
} SurfaceMoments;
SurfaceMoments surface_moments(const Mesh *mesh, const Symmetry *symmetry, const double *x,
                               const double origin[3]);

/* Area vectors A_p = int N_p n dS, [n_nodes][3]: the exact gradient of the volume, so that the flux of a
 * nodal field is sum_p v_p . A_p.  With a symmetry the sum holds for fields that have it, and A is not zero
 * at the nodes of one element of each orbit only. */
void surface_area_vectors(const Mesh *mesh, const Symmetry *symmetry, const double *x, double *A);

/* Outward unit normals at the nodes, averaged over the elements around each, [n_nodes][3]. */
void surface_normals(const Mesh *mesh, const double *x, double *n);

/* Flux int v . n dS of a nodal field v [n_nodes][3] through the surface, exact for any P2 field; the flux of
 * x itself is three times the volume. */
double surface_flux(const Mesh *mesh, const Symmetry *symmetry, const double *x, const double *v);

#endif
