/* Polar quadrature about a node of a P2 element: the Jacobian r cancels the 1/r of a kernel singular there.
 */
#ifndef CAPSELLA_MESH_POLAR_H
#define CAPSELLA_MESH_POLAR_H

/* One point: (xi, eta) = node + (dxi, deta), and a weight that holds the whole Jacobian of the polar map, so
 * that int f dxi deta ~= sum weight * f(xi, eta). */
typedef struct {
  double dxi, deta; /* offset from the node */
  double weight;
} PolarPoint;

enum {
  POLAR_MAX_ANGULAR = 32,
  POLAR_MAX_RADIAL = 8,
  POLAR_MAX_POINTS = 2 * POLAR_MAX_ANGULAR * POLAR_MAX_RADIAL
};

/* The Gauss points on [0, 1] of a polar rule, made once and used for many nodes. */
typedef struct {
  int n_radial, n_angular;
  double radius[POLAR_MAX_RADIAL], radius_weight[POLAR_MAX_RADIAL];
  double angle[POLAR_MAX_ANGULAR], angle_weight[POLAR_MAX_ANGULAR];
} PolarGauss;
void polar_gauss(int n_radial, int n_angular, PolarGauss *gauss);

/* Polar rule about local node 0..5: the element is cut into one triangle (corner) or two (mid-edge node) with
 * the apex at the node, and each gets n_radial x n_angular Gauss points.  Angles are measured with the metric
 * g = [a1.a1, a1.a2, a2.a2] of the tangent plane at the node; {1, 0, 1} gives the parametric angle, {1, 1/2,
 * 1} that of an equilateral triangle.  Returns the number of points written (at most POLAR_MAX_POINTS).  The
 * points of one ray stand together, from the node outward. */
int polar_points(const PolarGauss *gauss, int local_node, const double g[3], PolarPoint *points);

/* The same in one call, for one node. */
int polar_rule(int local_node, const double g[3], int n_radial, int n_angular, PolarPoint *points);

#endif
