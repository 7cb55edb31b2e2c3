/* The ellipsoid of inertia against exact ellipsoids, turned, moved and scaled, and against another way of
 * integrating. */
#include "base/vec3.h"
#include "mesh/p2.h"
#include "observe/shape.h"
#include "random.h"
#include "suite.h"
#include <string.h>

static const double pi = 3.14159265358979323846;
static const double e_x[3] = {1.0, 0.0, 0.0}, e_y[3] = {0.0, 1.0, 0.0};

static Mesh sphere(int subdivisions) {
  Mesh mesh;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  return mesh;
}

static Shape measure(const Mesh *mesh, const double *x, const double vorticity_axis[3]) {
  Shape shape;
  Error error;
  ck_assert_int_eq(shape_measure(mesh, NULL, x, vorticity_axis, &shape, &error), STATUS_OK);
  return shape;
}

/* The sphere stretched to semi-axes a along x, y, z, and then turned by `angle` from x towards z. */
static double *turned_ellipsoid(const Mesh *mesh, const double a[3], double angle) {
  double *x = malloc(3 * (size_t)mesh->n_nodes * sizeof *x);
  ck_assert_ptr_nonnull(x);
  for (int p = 0; p < mesh->n_nodes; p++) {
    const double *X = &mesh->X[3 * p];
    x[3 * p] = cos(angle) * a[0] * X[0] - sin(angle) * a[2] * X[2];
    x[3 * p + 1] = a[1] * X[1];
    x[3 * p + 2] = sin(angle) * a[0] * X[0] + cos(angle) * a[2] * X[2];
  }
  return x;
}

/* Full axis length that stands for a sphere of this mesh: 2, but for its P2 geometry. */
static double sphere_length(const Mesh *mesh) {
  return measure(mesh, mesh->X, e_y).L1;
}

START_TEST(sphere_has_three_axes_of_two_and_no_direction) {
  double error[4];
  for (int level = 0; level < 4; level++) {
    Mesh mesh = sphere(level);
    Shape shape = measure(&mesh, mesh.X, e_y);
    ck_assert_double_eq_tol(shape.L2, shape.L1, 1e-14); /* the icosahedral group leaves one moment */
    ck_assert_double_eq_tol(shape.L3, shape.L1, 1e-14);
    ck_assert(isnan(shape.beta));
    error[level] = fabs(shape.L1 - 2.0);
    mesh_free(&mesh);
  }
  ck_assert_double_lt(error[3], 1e-5);
  ck_assert_double_ge(error[2] / error[3], 14.0); /* fourth order, as the volume */
}
END_TEST

/* An ellipsoid is a linear map of the sphere, and the discrete surface follows it: everything is exact but
 * for the length that stands for the sphere. */
START_TEST(turned_ellipsoids_have_their_axes_and_angles) {
  Mesh mesh = sphere(1);
  double length = sphere_length(&mesh);
  static const double axes[3][3] = {{2.0, 1.0, 0.5}, {1.1, 3.0, 1.0}, {1.01, 0.2, 0.99}};
  for (int k = 0; k < 3; k++)
    for (int degrees = -85; degrees <= 90; degrees += 25) {
      const double *a = axes[k], angle = degrees * pi / 180.0;
      double *x = turned_ellipsoid(&mesh, a, angle);
      Shape shape = measure(&mesh, x, e_y);
      ck_assert_double_eq_tol(shape.L1, a[0] * length, 1e-13); /* round-off of sums of 1300 terms */
      ck_assert_double_eq_tol(shape.L2, a[2] * length, 1e-13);
      ck_assert_double_eq_tol(shape.L3, a[1] * length, 1e-13);
      ck_assert_double_eq_tol(shape.D12, (a[0] - a[2]) / (a[0] + a[2]), 1e-13);
      if (degrees < 90) /* round-off over the gap between the moments: 1e-15/0.02 for the third shape */
        ck_assert_double_eq_tol(shape.beta, angle, 1e-12);
      const double major[3] = {cos(angle), 0.0, sin(angle)};
      ck_assert_double_eq_tol(fabs(vec3_dot(shape.e1, major)), 1.0, 1e-13);
      ck_assert_double_eq_tol(shape.e3[1], 1.0, 1e-13);
      free(x);
    }
  mesh_free(&mesh);
}
END_TEST

START_TEST(axes_are_a_right_handed_frame_with_e1_forward) {
  Mesh mesh = sphere(1);
  for (int degrees = 0; degrees < 360; degrees += 7) {
    double *x = turned_ellipsoid(&mesh, (const double[3]){1.5, 1.2, 0.6}, degrees * pi / 180.0);
    Shape shape = measure(&mesh, x, e_y);
    double cross[3];
    vec3_cross(shape.e1, shape.e2, cross);
    ck_assert_double_eq_tol(vec3_dot(cross, shape.e3), 1.0, 1e-14);
    ck_assert_double_ge(shape.e1[0], 0.0);
    ck_assert_double_gt(shape.beta, -0.5 * pi);
    ck_assert_double_le(shape.beta, 0.5 * pi);
    free(x);
  }
  mesh_free(&mesh);
}
END_TEST

START_TEST(angle_counts_towards_the_shear_direction_for_either_sense_of_vorticity) {
  Mesh mesh = sphere(1);
  double *x = turned_ellipsoid(&mesh, (const double[3]){1.5, 1.2, 0.6}, 0.3);
  ck_assert_double_eq_tol(measure(&mesh, x, (const double[3]){0.0, 1.0, 0.0}).beta, 0.3, 1e-13);
  ck_assert_double_eq_tol(measure(&mesh, x, (const double[3]){0.0, -1.0, 0.0}).beta, -0.3, 1e-13);
  /* the same shape seen in the plane of y and z, where angles count from e_y towards e_y x e_x = -e_z */
  Shape shape = measure(&mesh, x, e_x);
  ck_assert_double_eq_tol(shape.beta, 0.0, 1e-13);
  ck_assert_double_gt(shape.L3, shape.L1);
  free(x);
  mesh_free(&mesh);
}
END_TEST

START_TEST(position_and_scale_are_taken_out) {
  Mesh mesh = sphere(2);
  double *x = turned_ellipsoid(&mesh, (const double[3]){2.0, 1.0, 0.5}, 0.4);
  Shape here = measure(&mesh, x, e_y);
  for (int k = 0; k < 3 * mesh.n_nodes; k++) x[k] = 0.01 * x[k] + 10.0 * (k % 3 + 1);
  Shape there = measure(&mesh, x, e_y);
  /* 1000 lengths away: 1e-16 * 1000 in a coordinate, and some more in the angle */
  ck_assert_double_eq_tol(there.L1 / 0.01, here.L1, 1e-11);
  ck_assert_double_eq_tol(there.L2 / 0.01, here.L2, 1e-11);
  ck_assert_double_eq_tol(there.L3 / 0.01, here.L3, 1e-11);
  ck_assert_double_eq_tol(there.beta, here.beta, 1e-11);
  for (int i = 0; i < 3; i++) {
    ck_assert_double_eq_tol(here.center[i], 0.0, 1e-14);
    ck_assert_double_eq_tol(there.center[i], 10.0 * (i + 1), 1e-12);
  }
  free(x);
  mesh_free(&mesh);
}
END_TEST

/* Second moments about the origin by Gauss points on the square, collapsed to the triangle: exact for degree
 * 8 with 6 x 6 points, and no rule in common with the code under test. */
static void collapsed_moments(const Mesh *mesh, const double *x, double *volume, double first[3],
                              double second[3][3]) {
  enum { N = 6 };
  double point[N], weight[N];
  gauss_rule(N, point, weight);
  *volume = 0.0;
  memset(first, 0, 3 * sizeof *first);
  memset(second, 0, 9 * sizeof second[0][0]);
  for (int e = 0; e < mesh->n_elements; e++)
    for (int k = 0; k < N * N; k++) {
      double xi = point[k / N], eta = (1.0 - xi) * point[k % N];
      P2Table table = {.n = 1};
      double y[3], a1[3], a2[3], normal[3];
      p2_values(xi, eta, table.N[0]);
      p2_gradients(xi, eta, table.dN[0]);
      const P2Table constant = table;
      p2_interpolate(x, mesh->element[e], table.N[0], y);
      p2_tangents(x, mesh->element[e], constant.dN[0], a1, a2);
      vec3_cross(a1, a2, normal);
      double w = weight[k / N] * weight[k % N] * (1.0 - xi);
      /* Fluxes of fields along one axis: div (y_i^2/2 e_i) = y_i, div (y_i^2 y_j/2 e_i) = y_i y_j. */
      for (int i = 0; i < 3; i++) {
        *volume += w * y[i] * normal[i] / 3.0;
        first[i] += w * 0.5 * y[i] * y[i] * normal[i];
        for (int j = 0; j < 3; j++)
          second[i][j] += w * (i == j ? y[i] * y[i] * y[i] / 3.0 : 0.5 * y[i] * y[i] * y[j]) * normal[i];
      }
    }
}

START_TEST(moments_of_an_irregular_surface_are_integrated_exactly) {
  const uint64_t seed = 99;
  uint64_t state = seed;
  Mesh mesh = sphere(1);
  for (int k = 0; k < 3 * mesh.n_nodes; k++) mesh.X[k] *= 1.0 + 0.1 * random_uniform(&state);
  for (int p = 0; p < mesh.n_nodes; p++) mesh.X[3 * p] *= 1.5;
  Shape shape = measure(&mesh, mesh.X, e_y);
  double volume, first[3], second[3][3];
  collapsed_moments(&mesh, mesh.X, &volume, first, second);
  ck_assert_double_eq_tol(shape.volume, volume, 1e-13);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(shape.center[i], first[i] / volume, 1e-14);

  /* The ellipsoid's own moments, V a_k^2/5 along e_k, are those of the surface. */
  const double *axis[3] = {shape.e1, shape.e2, shape.e3};
  const double a[3] = {0.5 * shape.L1, 0.5 * shape.L2, 0.5 * shape.L3};
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      double expected = second[i][j] - first[i] * first[j] / volume, found = 0.0;
      for (int k = 0; k < 3; k++) found += volume * a[k] * a[k] / 5.0 * axis[k][i] * axis[k][j];
      ck_assert_msg(fabs(found - expected) < 1e-13, "seed %llu, entry %d %d: %.17g, expected %.17g",
                    (unsigned long long)seed, i, j, found, expected);
    }
  mesh_free(&mesh);
}
END_TEST

START_TEST(what_has_no_shape_is_rejected) {
  Mesh mesh = sphere(0);
  Shape shape;
  Error error;
  double *x = turned_ellipsoid(&mesh, (const double[3]){1.0, 1.0, -1.0}, 0.0); /* inside out */
  ck_assert_int_eq(shape_measure(&mesh, NULL, x, e_y, &shape, &error), STATUS_REJECT);
  x[7] = NAN;
  ck_assert_int_eq(shape_measure(&mesh, NULL, x, e_y, &shape, &error), STATUS_REJECT);
  ck_assert_ptr_nonnull(strstr(error.text, "shape"));
  free(x);
  mesh_free(&mesh);
}
END_TEST

/* Both ways to measure; `operations`: how many the shape has. */
static void check_symmetric(const Mesh *mesh, const double *x, int operations) {
  Symmetry symmetry;
  Shape whole = measure(mesh, x, e_y), part;
  Error error;
  ck_assert_int_eq(symmetry_find(&symmetry, mesh, x, NULL, &error), STATUS_OK);
  ck_assert_int_eq(symmetry.n_operations, operations);
  ck_assert_int_eq(shape_measure(mesh, &symmetry, x, e_y, &part, &error), STATUS_OK);
  /* round-off of sums over the elements in another order */
  ck_assert_double_eq_tol(part.volume, whole.volume, 1e-13);
  ck_assert_double_eq_tol(part.area, whole.area, 1e-13);
  ck_assert_double_eq_tol(part.L1, whole.L1, 1e-13);
  ck_assert_double_eq_tol(part.L2, whole.L2, 1e-13);
  ck_assert_double_eq_tol(part.L3, whole.L3, 1e-13);
  ck_assert_double_eq_tol(part.beta, whole.beta, 1e-12);
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(part.center[i], whole.center[i], 1e-13);
  symmetry_free(&symmetry);
}

START_TEST(one_element_of_each_orbit_is_enough) {
  Mesh mesh = sphere(2);
  double *x = malloc(3 * (size_t)mesh.n_nodes * sizeof *x);
  ck_assert_ptr_nonnull(x);
  const double axes[3] = {2.0, 1.0, 0.5}, shear = 0.4;
  for (int p = 0; p < mesh.n_nodes; p++)
    for (int i = 0; i < 3; i++) x[3 * p + i] = axes[i] * mesh.X[3 * p + i];
  check_symmetric(&mesh, x, 8);
  for (int p = 0; p < mesh.n_nodes; p++) x[3 * p] += shear * x[3 * p + 2]; /* as in a simple shear */
  check_symmetric(&mesh, x, 4);
  for (int p = 0; p < mesh.n_nodes; p++) x[3 * p] += 0.25; /* only the mirror along y is left */
  check_symmetric(&mesh, x, 2);
  free(x);
  mesh_free(&mesh);
}
END_TEST

int main(void) {
  return suite_run("shape",
                   (SuiteTests){sphere_has_three_axes_of_two_and_no_direction,
                                turned_ellipsoids_have_their_axes_and_angles,
                                axes_are_a_right_handed_frame_with_e1_forward,
                                angle_counts_towards_the_shear_direction_for_either_sense_of_vorticity,
                                position_and_scale_are_taken_out,
                                moments_of_an_irregular_surface_are_integrated_exactly,
                                what_has_no_shape_is_rejected, one_element_of_each_orbit_is_enough, NULL});
}
