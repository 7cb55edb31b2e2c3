/* Quadratic (P2) shape functions on the triangle xi, eta >= 0, xi + eta <= 1.
 * Corners 0 (0,0), 1 (1,0), 2 (0,1); mid-edge nodes 3 (1/2,0), 4 (1/2,1/2), 5 (0,1/2). */
#ifndef CAPSELLA_MESH_P2_H
#define CAPSELLA_MESH_P2_H

#include "mesh/quadrature.h"

extern const double p2_node[6][2]; /* (xi, eta) of the six nodes */

void p2_values(double xi, double eta, double N[6]);
void p2_gradients(double xi, double eta, double dN[6][2]); /* d/dxi, d/deta */

/* Weights, shape functions and their gradients at the points of a rule. */
typedef struct {
  int n;
  double weight[TRIANGLE_RULE_MAX];
  double N[TRIANGLE_RULE_MAX][6];
  double dN[TRIANGLE_RULE_MAX][6][2];
} P2Table;
P2Table p2_table(const TriangleRule *rule);

/* Interpolates a nodal vector field x [n_nodes][3] on an element. */
static inline void p2_interpolate(const double *x, const int node[6], const double N[6], double value[3]) {
  for (int i = 0; i < 3; i++) value[i] = 0.0;
  for (int p = 0; p < 6; p++)
    for (int i = 0; i < 3; i++) value[i] += N[p] * x[3 * node[p] + i];
}

/* Tangent vectors a_1 = dx/dxi and a_2 = dx/deta of an element; a_1 x a_2 is the outward normal times dS per
 * dxi deta.  (C17 takes dN from a const object, such as a const P2Table, without a cast.) */
static inline void p2_tangents(const double *x, const int node[6], const double dN[6][2], double a1[3],
                               double a2[3]) {
  for (int i = 0; i < 3; i++) a1[i] = a2[i] = 0.0;
  for (int p = 0; p < 6; p++)
    for (int i = 0; i < 3; i++) {
      a1[i] += dN[p][0] * x[3 * node[p] + i];
      a2[i] += dN[p][1] * x[3 * node[p] + i];
    }
}

#endif
