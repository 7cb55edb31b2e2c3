/* Gauss points in the angle and the radius of triangles with their apex at a node.
 *
 * In the tangent plane the sides of a triangle are the vectors a and b, at an angle Theta.  The direction at
 * the angle t from a is  u(t) = [sin(Theta - t) a/|a| + sin(t) b/|b|] / sin(Theta)  and meets the opposite
 * edge where the coefficients of a and b sum to 1.  With s(t) = sin(Theta - t)/|a| + sin(t)/|b|, the distance
 * to that edge is sin(Theta)/s, and the point at the fraction rho of it is rho/s [sin(Theta - t)/|a| a +
 * sin(t)/|b| b], which needs only lengths and angles: the map to the tangent plane is never formed. */
#include "mesh/polar.h"

#include "mesh/p2.h"

#include <math.h>

void polar_gauss(int n_radial, int n_angular, PolarGauss *gauss) {
  gauss->n_radial = n_radial;
  gauss->n_angular = n_angular;
  gauss_rule(n_radial, gauss->radius, gauss->radius_weight);
  gauss_rule(n_angular, gauss->angle, gauss->angle_weight);
}

static double metric_product(const double g[3], const double u[2], const double v[2]) {
  return g[0] * u[0] * v[0] + g[1] * (u[0] * v[1] + u[1] * v[0]) + g[2] * u[1] * v[1];
}

/* Points of the triangle with sides a and b (parametric components, a to b counter-clockwise). */
static int triangle_points(const PolarGauss *gauss, const double g[3], const double a[2], const double b[2],
                           PolarPoint *points) {
  double jacobian = sqrt(g[0] * g[2] - g[1] * g[1]); /* tangent-plane area per parametric area */
  double sine_sides = jacobian * (a[0] * b[1] - a[1] * b[0]);
  double Theta = atan2(sine_sides, metric_product(g, a, b));
  double length_a = sqrt(metric_product(g, a, a)), length_b = sqrt(metric_product(g, b, b));
  double sine_Theta = sine_sides / (length_a * length_b);
  double sine[POLAR_MAX_ANGULAR]; /* of t; that of Theta - t is the mirrored one by symmetry of the points */
  for (int i = 0; i < gauss->n_angular; i++) sine[i] = sin(Theta * gauss->angle[i]);
  int n = 0;
  for (int i = 0; i < gauss->n_angular; i++) {
    double share_a = sine[gauss->n_angular - 1 - i] / length_a, share_b = sine[i] / length_b;
    double s = share_a + share_b;
    double distance = sine_Theta / s;
    double ray_weight = gauss->angle_weight[i] * Theta * distance * distance / jacobian;
    double ray[2] = {(share_a * a[0] + share_b * b[0]) / s, (share_a * a[1] + share_b * b[1]) / s};
    for (int j = 0; j < gauss->n_radial; j++) {
      double rho = gauss->radius[j];
      points[n++] = (PolarPoint){rho * ray[0], rho * ray[1], ray_weight * gauss->radius_weight[j] * rho};
    }
  }
  return n;
}

int polar_points(const PolarGauss *gauss, int local_node, const double g[3], PolarPoint *points) {
  /* Corners opposite to the node, counter-clockwise: one edge for a corner, two for a mid-edge node. */
  static const int opposite[6][3] = {{1, 2, -1}, {2, 0, -1}, {0, 1, -1}, {1, 2, 0}, {2, 0, 1}, {0, 1, 2}};
  int n = 0;
  for (int k = 0; k < 2 && opposite[local_node][k + 1] >= 0; k++) {
    const double *apex = p2_node[local_node];
    const double *from = p2_node[opposite[local_node][k]], *to = p2_node[opposite[local_node][k + 1]];
    const double a[2] = {from[0] - apex[0], from[1] - apex[1]};
    const double b[2] = {to[0] - apex[0], to[1] - apex[1]};
    n += triangle_points(gauss, g, a, b, &points[n]);
  }
  return n;
}

int polar_rule(int local_node, const double g[3], int n_radial, int n_angular, PolarPoint *points) {
  PolarGauss gauss;
  polar_gauss(n_radial, n_angular, &gauss);
  return polar_points(&gauss, local_node, g, points);
}
