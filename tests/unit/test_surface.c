/* Volume, area and normals of P2 surfaces against spheres and ellipsoids. */
#include "base/vec3.h"
#include "mesh/surface.h"

#include "suite.h"
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

static Mesh sphere(int subdivisions) {
  Mesh mesh;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  return mesh;
}

/* Nodes of the mesh stretched by the factors a, moved by `shift`; freed by the caller. */
static double *stretched(const Mesh *mesh, const double a[3], const double shift[3]) {
  double *x = malloc(3 * (size_t)mesh->n_nodes * sizeof *x);
  ck_assert_ptr_nonnull(x);
  for (int p = 0; p < mesh->n_nodes; p++)
    for (int i = 0; i < 3; i++) x[3 * p + i] = a[i] * mesh->X[3 * p + i] + shift[i];
  return x;
}

START_TEST(volume_and_area_of_the_sphere_converge_at_the_fourth_order) {
  /* The P2 surface through points of the sphere is off by O(h^3), by odd terms that cancel within and between
   * elements: both integrals gain a factor near 16 with each halving. */
  double volume_error[5], area_error[5];
  for (int level = 0; level < 5; level++) {
    Mesh mesh = sphere(level);
    volume_error[level] = fabs(surface_volume(&mesh, mesh.X) - 4.0 / 3.0 * pi);
    area_error[level] = fabs(surface_area(&mesh, NULL, mesh.X) - 4.0 * pi);
    mesh_free(&mesh);
  }
  for (int level = 2; level < 5; level++) {
    ck_assert_double_ge(volume_error[level - 1] / volume_error[level], 14.0);
    ck_assert_double_ge(area_error[level - 1] / area_error[level], 14.0);
  }
}
END_TEST

START_TEST(volume_scales_exactly_under_a_linear_map) {
  /* A linear map of the nodes maps the P2 surface, and its volume takes the determinant; a shift changes
   * nothing because the surface is closed. */
  Mesh mesh = sphere(2);
  double volume = surface_volume(&mesh, mesh.X);
  double *x = stretched(&mesh, (const double[3]){2.0, 1.0, 0.5}, (const double[3]){0.3, -0.2, 0.7});
  ck_assert_double_eq_tol(surface_volume(&mesh, x), volume, 1e-13); /* sums of 2000 terms */
  free(x);
  x = stretched(&mesh, (const double[3]){3.0, 1.5, 0.4}, (const double[3]){0.0, 0.0, 0.0});
  ck_assert_double_eq_tol(surface_volume(&mesh, x), 1.8 * volume, 1e-13);
  free(x);
  mesh_free(&mesh);
}
END_TEST

START_TEST(volume_of_an_ellipsoid_is_four_thirds_pi_abc) {
  Mesh mesh = sphere(3);
  double *x = stretched(&mesh, (const double[3]){2.0, 1.0, 0.5}, (const double[3]){0.0, 0.0, 0.0});
  /* the sphere's own P2 error at 1280 elements, 9.1e-6 relative, which a linear map keeps */
  ck_assert_double_eq_tol(surface_volume(&mesh, x) / (4.0 / 3.0 * pi), 1.0, 1e-5);
  free(x);
  mesh_free(&mesh);
}
END_TEST

START_TEST(area_of_a_spheroid_matches_its_closed_form) {
  Mesh mesh = sphere(4);
  double *x = stretched(&mesh, (const double[3]){1.0, 1.0, 2.0}, (const double[3]){0.0, 0.0, 0.0});
  double eccentricity = sqrt(0.75);
  double exact = 2.0 * pi * (1.0 + 2.0 / eccentricity * asin(eccentricity));
  ck_assert_double_eq_tol(surface_area(&mesh, NULL, x) / exact, 1.0, 2e-6); /* P2 geometry at 5120 elements */
  free(x);
  mesh_free(&mesh);
}
END_TEST

START_TEST(area_vectors_are_the_gradient_of_the_volume) {
  Mesh mesh = sphere(1);
  double *x = stretched(&mesh, (const double[3]){1.7, 1.1, 0.6}, (const double[3]){0.1, 0.2, -0.3});
  double *A = malloc(3 * (size_t)mesh.n_nodes * sizeof *A);
  surface_area_vectors(&mesh, NULL, x, A);
  const double h = 1e-2; /* the volume is cubic: central differences err by h^2 V'''/6, and V''' = 0 in one
                            coordinate of one node; what remains is round-off, 1e-15/h */
  for (int k = 0; k < 3 * mesh.n_nodes; k++) {
    double kept = x[k];
    x[k] = kept + h;
    double above = surface_volume(&mesh, x);
    x[k] = kept - h;
    double below = surface_volume(&mesh, x);
    x[k] = kept;
    ck_assert_double_eq_tol((above - below) / (2.0 * h), A[k], 1e-12);
  }
  free(A);
  free(x);
  mesh_free(&mesh);
}
END_TEST

START_TEST(area_vectors_sum_to_zero_and_give_three_times_the_volume) {
  Mesh mesh = sphere(3);
  double *x = stretched(&mesh, (const double[3]){2.0, 1.0, 0.5}, (const double[3]){0.5, 0.0, 0.0});
  double *A = malloc(3 * (size_t)mesh.n_nodes * sizeof *A);
  surface_area_vectors(&mesh, NULL, x, A);
  double sum[3] = {0.0, 0.0, 0.0}, moment = 0.0;
  for (int p = 0; p < mesh.n_nodes; p++) {
    for (int i = 0; i < 3; i++) sum[i] += A[3 * p + i];
    moment += vec3_dot(&x[3 * p], &A[3 * p]);
  }
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(sum[i], 0.0, 1e-13); /* closed surface, round-off */
  ck_assert_double_eq_tol(moment, 3.0 * surface_volume(&mesh, x), 1e-12);  /* Euler: V is cubic in x */
  free(A);
  free(x);
  mesh_free(&mesh);
}
END_TEST

/* Largest distance of the nodal normals from those of the ellipsoid. */
static double normal_error(int level, const double a[3]) {
  Mesh mesh = sphere(level);
  double *x = stretched(&mesh, a, (const double[3]){0.0, 0.0, 0.0});
  double *n = malloc(3 * (size_t)mesh.n_nodes * sizeof *n);
  surface_normals(&mesh, x, n);
  double worst = 0.0;
  for (int p = 0; p < mesh.n_nodes; p++) {
    double exact[3];
    for (int i = 0; i < 3; i++) exact[i] = x[3 * p + i] / (a[i] * a[i]);
    vec3_normalize(exact);
    worst = fmax(worst, vec3_distance(exact, &n[3 * p]));
  }
  free(n);
  free(x);
  mesh_free(&mesh);
  return worst;
}

START_TEST(normals_point_outward_and_converge) {
  static const double axes[2][3] = {{1.0, 1.0, 1.0}, {2.0, 1.0, 0.5}};
  for (int k = 0; k < 2; k++) { /* tangents of P2 elements err by O(h^2): a factor of 4, and better */
    double coarse = normal_error(2, axes[k]), fine = normal_error(3, axes[k]);
    ck_assert_double_lt(fine, 0.02);
    ck_assert_double_gt(coarse / fine, 3.5);
  }
}
END_TEST

int main(void) {
  return suite_run("surface", (SuiteTests){volume_and_area_of_the_sphere_converge_at_the_fourth_order,
                                           volume_scales_exactly_under_a_linear_map,
                                           volume_of_an_ellipsoid_is_four_thirds_pi_abc,
                                           area_of_a_spheroid_matches_its_closed_form,
                                           area_vectors_are_the_gradient_of_the_volume,
                                           area_vectors_sum_to_zero_and_give_three_times_the_volume,
                                           normals_point_outward_and_converge, NULL});
}
