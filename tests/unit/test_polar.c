/* Polar quadrature about a node against the closed form of int dS / r over flat triangles. */
#include "mesh/p2.h"
#include "mesh/polar.h"
#include "suite.h"
#include <math.h>
#include <stdbool.h>

static const double parametric[3] = {1.0, 0.0, 1.0};

/* int dS / r over the triangle (apex, a, b) with r from its apex: h [asinh(tan)] between the sides, where h
 * is the distance of the apex from the opposite edge. */
static double apex_integral(const double a[2], const double b[2]) {
  double edge[2] = {b[0] - a[0], b[1] - a[1]};
  double length = hypot(edge[0], edge[1]);
  double h = (a[0] * b[1] - a[1] * b[0]) / length;
  double from = (a[0] * edge[0] + a[1] * edge[1]) / length, to = (b[0] * edge[0] + b[1] * edge[1]) / length;
  return h * (asinh(to / h) - asinh(from / h));
}

/* A flat triangle: corners 0, a1 and a2 in the plane, mid-edge nodes halfway. */
typedef struct {
  double a1[2], a2[2];
} Flat;

static void flat_metric(const Flat *flat, double g[3]) {
  g[0] = flat->a1[0] * flat->a1[0] + flat->a1[1] * flat->a1[1];
  g[1] = flat->a1[0] * flat->a2[0] + flat->a1[1] * flat->a2[1];
  g[2] = flat->a2[0] * flat->a2[0] + flat->a2[1] * flat->a2[1];
}

static void flat_offset(const Flat *flat, double dxi, double deta, double offset[2]) {
  for (int i = 0; i < 2; i++) offset[i] = flat->a1[i] * dxi + flat->a2[i] * deta;
}

static double exact_integral(const Flat *flat, int node) {
  double sum = 0.0;
  for (int k = 0; k < 3; k++) { /* over the edges; those through the node subtend no angle */
    double side[2][2];
    for (int end = 0; end < 2; end++) {
      const double *corner = p2_node[(k + end) % 3];
      flat_offset(flat, corner[0] - p2_node[node][0], corner[1] - p2_node[node][1], side[end]);
    }
    if (fabs(side[0][0] * side[1][1] - side[0][1] * side[1][0]) > 1e-12)
      sum += apex_integral(side[0], side[1]);
  }
  return sum;
}

static double polar_integral(const Flat *flat, int node, const double g[3], int n_radial, int n_angular) {
  PolarPoint points[POLAR_MAX_POINTS];
  int n = polar_rule(node, g, n_radial, n_angular, points);
  double sum = 0.0, jacobian = flat->a1[0] * flat->a2[1] - flat->a1[1] * flat->a2[0];
  for (int k = 0; k < n; k++) {
    double offset[2];
    flat_offset(flat, points[k].dxi, points[k].deta, offset);
    sum += points[k].weight * jacobian / hypot(offset[0], offset[1]);
  }
  return sum;
}

/* Largest relative error over the six nodes, with angles in the tangent plane or in the parametric one. */
static double polar_error(const Flat *flat, bool tangent_plane, int n_radial, int n_angular) {
  double worst = 0.0, g[3];
  flat_metric(flat, g);
  for (int node = 0; node < 6; node++) {
    double exact = exact_integral(flat, node);
    double found = polar_integral(flat, node, tangent_plane ? g : parametric, n_radial, n_angular);
    worst = fmax(worst, fabs(found / exact - 1.0));
  }
  return worst;
}

/* The equilateral triangle, turned by an angle and stretched: its metric has this aspect ratio. */
static Flat stretched(double aspect, double turn) {
  static const double side[2][2] = {{1.0, 0.0}, {0.5, 0.86602540378443865}};
  double turned[2][2];
  for (int k = 0; k < 2; k++) {
    turned[k][0] = aspect * (cos(turn) * side[k][0] - sin(turn) * side[k][1]);
    turned[k][1] = sin(turn) * side[k][0] + cos(turn) * side[k][1];
  }
  return (Flat){{turned[0][0], turned[0][1]}, {turned[1][0], turned[1][1]}};
}

/* Largest error over all directions of the stretch. */
static double worst_error(double aspect, bool tangent_plane, int n_radial, int n_angular) {
  double worst = 0.0;
  for (int k = 0; k < 32; k++) {
    Flat flat = stretched(aspect, k * 3.14159265358979323846 / 32);
    worst = fmax(worst, polar_error(&flat, tangent_plane, n_radial, n_angular));
  }
  return worst;
}

START_TEST(eight_angles_reach_the_design_accuracy_below_aspect_two) {
  /* Measured: 2.5e-8 at aspect 1, 7e-6 at aspect 2; the single layer is meant to reach 6e-6 of its own
   * largest value, of which a singular element is a part. */
  ck_assert_double_lt(worst_error(1.0, true, 2, 8), 1e-7);
  ck_assert_double_lt(worst_error(1.5, true, 2, 8), 2e-6);
  ck_assert_double_lt(worst_error(2.0, true, 2, 8), 1e-5);
}
END_TEST

START_TEST(twelve_angles_reach_it_below_aspect_four_and_sixteen_beyond) {
  ck_assert_double_lt(worst_error(4.0, true, 2, 12), 1e-5);
  ck_assert_double_lt(worst_error(6.0, true, 2, 16), 1e-5);
}
END_TEST

START_TEST(tangent_plane_angle_beats_the_parametric_one_on_a_stretched_element) {
  /* Measured at aspect 4: 3.6e-4 against 3.5e-3. */
  ck_assert_double_lt(worst_error(4.0, true, 2, 8), 0.2 * worst_error(4.0, false, 2, 8));
}
END_TEST

START_TEST(error_falls_exponentially_with_the_angles) {
  double previous = 1.0;
  for (int n = 4; n <= 32; n += 4) {
    double error = worst_error(2.0, true, 1, n);
    ck_assert(error < 0.1 * previous || error < 1e-14);
    previous = error;
  }
}
END_TEST

START_TEST(one_radial_point_is_enough_for_one_over_r_on_a_flat_element) {
  ck_assert_double_eq_tol(worst_error(2.0, true, 1, 8), worst_error(2.0, true, 8, 8), 1e-14);
}
END_TEST

START_TEST(smooth_polynomials_are_integrated_too) {
  /* xi^i eta^j: the radius is a polynomial of degree i + j + 1, the angle converges exponentially. */
  static const double metric[3] = {1.3, 0.4, 0.8};
  static const double factorial[] = {1.0, 1.0, 2.0, 6.0, 24.0, 120.0, 720.0};
  for (int node = 0; node < 6; node++) {
    PolarPoint points[POLAR_MAX_POINTS];
    int n = polar_rule(node, metric, 4, 32, points);
    ck_assert_int_eq(n, (node < 3 ? 1 : 2) * 4 * 32);
    for (int i = 0; i <= 4; i++)
      for (int j = 0; i + j <= 4; j++) {
        double sum = 0.0;
        for (int k = 0; k < n; k++)
          sum += points[k].weight * pow(p2_node[node][0] + points[k].dxi, i) *
                 pow(p2_node[node][1] + points[k].deta, j);
        ck_assert_double_eq_tol(sum, factorial[i] * factorial[j] / factorial[i + j + 2], 1e-14);
      }
  }
}
END_TEST

START_TEST(points_lie_inside_the_element_with_positive_weights) {
  static const double metrics[3][3] = {{1.0, 0.0, 1.0}, {1.0, 0.5, 1.0}, {9.0, -2.0, 0.6}};
  for (int m = 0; m < 3; m++)
    for (int node = 0; node < 6; node++) {
      PolarPoint points[POLAR_MAX_POINTS];
      int n = polar_rule(node, metrics[m], 3, 10, points);
      for (int k = 0; k < n; k++) {
        double xi = p2_node[node][0] + points[k].dxi, eta = p2_node[node][1] + points[k].deta;
        ck_assert(points[k].weight > 0.0 && xi > 0.0 && eta > 0.0 && xi + eta < 1.0);
      }
    }
}
END_TEST

START_TEST(rule_does_not_depend_on_the_scale_of_the_metric) {
  PolarPoint small[POLAR_MAX_POINTS], large[POLAR_MAX_POINTS];
  int n = polar_rule(4, (const double[3]){2e-3, 5e-4, 1e-3}, 2, 8, small);
  ck_assert_int_eq(polar_rule(4, (const double[3]){2e3, 5e2, 1e3}, 2, 8, large), n);
  for (int k = 0; k < n; k++) { /* round-off */
    ck_assert_double_eq_tol(small[k].dxi, large[k].dxi, 1e-15);
    ck_assert_double_eq_tol(small[k].deta, large[k].deta, 1e-15);
    ck_assert_double_eq_tol(small[k].weight, large[k].weight, 1e-15);
  }
}
END_TEST

START_TEST(gauss_points_made_once_give_the_same_points) {
  static const double metric[3] = {1.3, 0.4, 0.8};
  PolarGauss gauss;
  polar_gauss(2, 8, &gauss);
  for (int node = 0; node < 6; node++) {
    PolarPoint once[POLAR_MAX_POINTS], each[POLAR_MAX_POINTS];
    int n = polar_points(&gauss, node, metric, once);
    ck_assert_int_eq(polar_rule(node, metric, 2, 8, each), n);
    ck_assert_mem_eq(once, each, (size_t)n * sizeof *once);
  }
}
END_TEST

int main(void) {
  return suite_run("polar", (SuiteTests){eight_angles_reach_the_design_accuracy_below_aspect_two,
                                         twelve_angles_reach_it_below_aspect_four_and_sixteen_beyond,
                                         tangent_plane_angle_beats_the_parametric_one_on_a_stretched_element,
                                         error_falls_exponentially_with_the_angles,
                                         one_radial_point_is_enough_for_one_over_r_on_a_flat_element,
                                         smooth_polynomials_are_integrated_too,
                                         points_lie_inside_the_element_with_positive_weights,
                                         rule_does_not_depend_on_the_scale_of_the_metric,
                                         gauss_points_made_once_give_the_same_points, NULL});
}
