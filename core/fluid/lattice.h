/* The lattice of 15 nodes on a nested triangle of the mesh, and interpolation from it.
 *
 * A nested triangle is made of four elements, or of four nested triangles; its lattice cuts its sides in
 * four. Interpolation is quartic in coordinates of the plane of its corners.  These are smooth on the
 * reference surface, as the deformation is; the parameters of the elements are not, across the edges between
 * them. */
#ifndef CAPSELLA_FLUID_LATTICE_H
#define CAPSELLA_FLUID_LATTICE_H

#include "base/status.h"
#include "fluid/moment_kernel.h"

enum { CHILDREN = 4 };

/* Numbers of the mesh nodes on the lattice of a triangle whose children are elements, or have lattices.
 * STATUS_FAILED when the children do not fit together as those of a nested mesh do. */
Status lattice_of_elements(const int element[CHILDREN][6], int node[LATTICE_NODES], Error *error);
Status lattice_of_lattices(const int child[CHILDREN][LATTICE_NODES], int node[LATTICE_NODES], Error *error);

typedef struct {
  double origin[3], axis[2][3];                 /* place on the lattice of X: axis . (X - origin) */
  double inverse[LATTICE_NODES][LATTICE_NODES]; /* of the values of the quartics at the nodes */
} LatticeFit;

/* Interpolation from the nodes at the reference positions X [n_nodes][3].  STATUS_FAILED when they do not
 * determine a quartic. */
Status lattice_fit(LatticeFit *fit, const double *X, const int node[LATTICE_NODES], Error *error);

/* Weights of the nodes at the reference position `point`, 0 in the lanes beyond the 15th. */
void lattice_weights(const LatticeFit *fit, const double point[3], double weight[LATTICE_LANES]);

#endif
