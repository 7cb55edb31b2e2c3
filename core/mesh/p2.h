/* Quadratic (P2) shape functions on the triangle xi, eta >= 0, xi + eta <= 1.
 * Corners 0 (0,0), 1 (1,0), 2 (0,1); mid-edge nodes 3 (1/2,0), 4 (1/2,1/2), 5 (0,1/2). */
#ifndef CAPSELLA_MESH_P2_H
#define CAPSELLA_MESH_P2_H

extern const double p2_node[6][2]; /* (xi, eta) of the six nodes */

void p2_values(double xi, double eta, double N[6]);
void p2_gradients(double xi, double eta, double dN[6][2]); /* d/dxi, d/deta */

#endif
