/* Quadrature on the triangle and on the unit interval. */
#ifndef CAPSELLA_MESH_QUADRATURE_H
#define CAPSELLA_MESH_QUADRATURE_H

/* Fully symmetric rule with positive weights and interior points; weights sum to 1/2, the triangle's area. */
typedef struct {
  int n, degree;
  const double (*point)[2]; /* [n] (xi, eta) */
  const double *weight;     /* [n] */
} TriangleRule;

enum { TRIANGLE_RULE_MAX = 16, GAUSS_MAX = 64 };

/* The rule with n = 1, 3, 6, 7, 12 or 16 points (degree 1, 2, 4, 5, 6, 8; Dunavant 1985); NULL for any other
 * n. */
const TriangleRule *triangle_rule(int n);

/* Gauss-Legendre on [0, 1]: x[n], w[n], 1 <= n <= GAUSS_MAX; exact to degree 2n - 1. */
void gauss_rule(int n, double *x, double *w);

#endif
