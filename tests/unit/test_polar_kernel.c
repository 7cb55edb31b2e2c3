/* Polar points of the tangent plane: the integrals of 1/r over flat triangles, exactly, and of smooth
 * functions beside it. */
#include "fluid/polar_kernel.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

/* The triangle with its apex at the origin of a plane with unit metric. */
static ApexTriangle flat_triangle(const double a[2], const double b[2]) {
  double edge[2] = {b[0] - a[0], b[1] - a[1]};
  double length = hypot(edge[0], edge[1]), area = a[0] * b[1] - a[1] * b[0], height = area / length;
  double from = (a[0] * edge[0] + a[1] * edge[1]) / length;
  ApexTriangle triangle = {
      .area = area, .height_over_edge = height / length, .foot_over_edge = from / length};
  memcpy(triangle.a, a, sizeof triangle.a);
  memcpy(triangle.b, b, sizeof triangle.b);
  triangle.start = exp(asinh(from / height));
  triangle.range = asinh((from + length) / height) - asinh(from / height);
  return triangle;
}

static const double SHAPES[][4] = {
    {1, 0, 0.5, 0.8660254037844386}, /* equilateral */
    {1, 0, 0, 1},
    {3, -1, 0.2, 0.1},  /* the foot beyond the edge */
    {20, -1, -30, 2},   /* fifty times longer than high */
    {1, 1e-3, -1, 1e-3} /* the apex almost on the edge */
};
enum { N_SHAPES = sizeof SHAPES / sizeof SHAPES[0] };

START_TEST(one_over_r_is_integrated_exactly_over_any_flat_triangle) {
  PolarGauss gauss;
  polar_gauss(1, 8, &gauss);
  for (int k = 0; k < N_SHAPES; k++) {
    ApexTriangle triangle = flat_triangle(SHAPES[k], SHAPES[k] + 2);
    OffsetPoints points = {.n = 0};
    double sum = 0, height = triangle.area / hypot(SHAPES[k][2] - SHAPES[k][0], SHAPES[k][3] - SHAPES[k][1]);
    apex_points(&triangle, &gauss, &points);
    ck_assert_int_eq(points.n, 8);
    for (int i = 0; i < points.n; i++) sum += points.weight[i] / hypot(points.s[i], points.t[i]);
    /* height * range: Gauss points are used on a constant */
    ck_assert_double_eq_tol(sum / (height * triangle.range), 1, 1e-12);
  }
}
END_TEST

START_TEST(points_lie_on_rays_inside_of_the_triangle) {
  PolarGauss gauss;
  polar_gauss(3, 16, &gauss);
  for (int k = 0; k < N_SHAPES; k++) {
    const double *a = SHAPES[k], *b = SHAPES[k] + 2;
    ApexTriangle triangle = flat_triangle(a, b);
    OffsetPoints points = {.n = 0};
    apex_points(&triangle, &gauss, &points);
    ck_assert_int_eq(points.n, 48);
    for (int i = 0; i < points.n; i++) { /* shares of a and b, positive, with a sum below 1 */
      double share_a = (points.s[i] * b[1] - points.t[i] * b[0]) / triangle.area;
      double share_b = (a[0] * points.t[i] - a[1] * points.s[i]) / triangle.area;
      ck_assert(share_a > 0 && share_b > 0 && share_a + share_b < 1);
      ck_assert(points.weight[i] > 0);
    }
  }
}
END_TEST

START_TEST(smooth_functions_over_r_converge_on_long_triangles_too) {
  /* int (1 + x^2 / r^2) / r: the kind of integrand that is left of the Oseen tensor */
  for (int k = 0; k < N_SHAPES; k++) {
    ApexTriangle triangle = flat_triangle(SHAPES[k], SHAPES[k] + 2);
    double sum[3] = {0};
    const int n_angular[3] = {8, 16, 32};
    for (int m = 0; m < 3; m++) {
      PolarGauss gauss;
      OffsetPoints points = {.n = 0};
      polar_gauss(2, n_angular[m], &gauss);
      apex_points(&triangle, &gauss, &points);
      for (int i = 0; i < points.n; i++) {
        double s = points.s[i], t = points.t[i], r2 = s * s + t * t;
        sum[m] += points.weight[i] * (1 + s * s / r2) / sqrt(r2);
      }
    }
    /* In w the integrand has poles at +-i pi/2: Gauss points on an interval of length `range` converge as the
     * powers of the ellipse through them, times their number since the poles are double. */
    double z = PI / triangle.range, ellipse = z + sqrt(1 + z * z);
    for (int m = 0; m < 2; m++) {
      ck_assert_double_eq_tol(sum[m] / sum[2], 1, 1e-13 + 4 * n_angular[m] * pow(ellipse, -2 * n_angular[m]));
    }
  }
}
END_TEST

START_TEST(expansion_reproduces_a_quadratic_surface_and_its_area) {
  /* Nodes of y = (s, t, s^2 - 2 s t), load (1, s, t^2), about the origin: rows of the matrix are the
   * coefficients themselves when the element's "nodes" are those. */
  const double matrix[6][6] = {{1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0},
                               {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}};
  Piece element = {{{0, 0, 0, 1}, {1, 0, 0, 0, 1}, {0, 1}, {0, 0, 1}, {0, 0, -2}, {0, 0, 0, 0, 0, 1}}};
  Expansion expansion;
  expansion_set(matrix, &element, &expansion);
  OffsetPoints points = {.n = OSEEN_LANES};
  OseenBlock block;
  for (int i = 0; i < OSEEN_LANES; i++) {
    points.s[i] = 0.1 * i;
    points.t[i] = 0.3 - 0.05 * i;
    points.weight[i] = 2;
  }
  expansion_points(&expansion, offset_view(&points), &block);
  for (int i = 0; i < OSEEN_LANES; i++) {
    double s = points.s[i], t = points.t[i], ds = 2 * s - 2 * t, dt = -2 * s;
    double area = 2 * sqrt(1 + ds * ds + dt * dt);
    ck_assert_double_eq_tol(block.y[2][i], s * s - 2 * s * t, 1e-15);
    ck_assert_double_eq_tol(block.f[0][i], area, 1e-14);
    ck_assert_double_eq_tol(block.f[1][i], area * s, 1e-14);
    ck_assert_double_eq_tol(block.f[2][i], area * t * t, 1e-14);
  }
}
END_TEST

int main(void) {
  return suite_run("polar_kernel", (SuiteTests){one_over_r_is_integrated_exactly_over_any_flat_triangle,
                                                points_lie_on_rays_inside_of_the_triangle,
                                                smooth_functions_over_r_converge_on_long_triangles_too,
                                                expansion_reproduces_a_quadratic_surface_and_its_area, NULL});
}
