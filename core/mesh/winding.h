/* How often a closed P2 surface winds around a point. */
#ifndef CAPSELLA_MESH_WINDING_H
#define CAPSELLA_MESH_WINDING_H

#include "mesh/mesh.h"

/* The solid angle of the surface, nodes at x [n_nodes][3], as seen from the point, over 4 pi: 1 inside, 0
 * outside, and other whole numbers where the surface crosses itself; 1/2 more or less on it.  Within 0.1 for
 * points farther from the surface than 1/1000 of an element. */
double winding_number(const Mesh *mesh, const double *x, const double point[3]);

#endif
