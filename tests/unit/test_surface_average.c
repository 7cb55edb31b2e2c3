/* Averages on the sphere, where symmetry gives them in closed form. */
#include "membrane/surface_average.h"

#include "membrane/membrane.h"
#include "mesh/quadrature.h"
#include "shell.h"
#include "suite.h"

/* The points of a membrane and their areas. */
typedef struct {
  Shell shell;
  SurfaceAverage average;
  double *X, *f, *mean;
  int n;
} Ball;

static void ball_open(Ball *b, int subdivisions, bool symmetric, double length) {
  static const double shear[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  Error error;
  b->shell.symmetry = (Symmetry){0};
  ck_assert_int_eq(mesh_sphere(&b->shell.mesh, subdivisions, NULL, &error), STATUS_OK);
  const Mesh *mesh = &b->shell.mesh;
  if (symmetric)
    ck_assert_int_eq(symmetry_find(&b->shell.symmetry, mesh, mesh->X, shear, &error), STATUS_OK);
  else
    ck_assert_int_eq(symmetry_none(&b->shell.symmetry, mesh, &error), STATUS_OK);
  shell_add_membrane(&b->shell, scene_law("neo_hookean", NULL, 0), no_law(), MASS_PCG);
  b->n = membrane_points(b->shell.membrane);
  b->X = zeros(3 * b->n);
  b->f = zeros(b->n);
  b->mean = zeros(b->n);
  for (int k = 0; k < b->n; k++) membrane_point_position(b->shell.membrane, k, mesh->X, b->X + 3 * k);
  ck_assert_int_eq(surface_average_new(&b->average, b->n, b->X, membrane_points_view(b->shell.membrane).dS0,
                                       &b->shell.symmetry, length, &error),
                   STATUS_OK);
}

static void ball_close(Ball *b) {
  surface_average_free(&b->average);
  free(b->X);
  free(b->f);
  free(b->mean);
  shell_close(&b->shell);
}

START_TEST(a_constant_is_its_own_mean) {
  Ball b;
  ball_open(&b, 2, true, 0.5);
  for (int k = 0; k < b.n; k++) b.f[k] = 0.7;
  surface_average_apply(&b.average, b.f, b.mean);
  for (int k = 0; k < b.n; k++) ck_assert_double_eq_tol(b.mean[k], 0.7, 1e-14);
  ball_close(&b);
}
END_TEST

/* A coordinate is a harmonic of degree 1: its mean is itself times 1 - <1 - cos theta>.  With
 * r^2 = 2 (1 - cos theta) the weight makes <r^2> = l^2/4, and the factor 1 - l^2/8. */
START_TEST(a_coordinate_shrinks_by_the_factor_of_the_sphere) {
  const double lengths[] = {0.5, 1};
  for (int i = 0; i < 2; i++) {
    Ball b;
    const double l = lengths[i];
    ball_open(&b, 3, false, l);
    for (int k = 0; k < b.n; k++) b.f[k] = b.X[3 * k + 1];
    surface_average_apply(&b.average, b.f, b.mean);
    /* 7680 points, 120 and more in a neighbourhood */
    for (int k = 0; k < b.n; k++) ck_assert_double_eq_tol(b.mean[k], (1 - l * l / 8) * b.f[k], 5e-4);
    ball_close(&b);
  }
}
END_TEST

START_TEST(one_point_of_each_orbit_gives_the_means_of_the_whole) {
  Ball part, whole;
  ball_open(&part, 2, true, 0.4);
  ball_open(&whole, 2, false, 0.4);
  ck_assert_int_lt(part.n, whole.n);
  for (int k = 0; k < part.n; k++)
    part.f[k] = part.X[3 * k] * part.X[3 * k + 2]; /* even under all signs kept */
  for (int k = 0; k < whole.n; k++) whole.f[k] = whole.X[3 * k] * whole.X[3 * k + 2];
  surface_average_apply(&part.average, part.f, part.mean);
  surface_average_apply(&whole.average, whole.f, whole.mean);
  int found = 0;
  for (int k = 0; k < part.n; k++)
    for (int j = 0; j < whole.n; j++)
      if (memcmp(part.X + 3 * k, whole.X + 3 * j, 3 * sizeof(double)) == 0) {
        ck_assert_double_eq_tol(part.mean[k], whole.mean[j], 1e-14);
        found++;
      }
  ck_assert_int_eq(found, part.n);
  ball_close(&part);
  ball_close(&whole);
}
END_TEST

START_TEST(below_the_distance_of_points_nothing_is_averaged) {
  Ball b;
  ball_open(&b, 1, false, 1e-6);
  for (int k = 0; k < b.n; k++) b.f[k] = k;
  surface_average_apply(&b.average, b.f, b.mean);
  for (int k = 0; k < b.n; k++) ck_assert_double_eq_tol(b.mean[k], k, 1e-12 * b.n);
  ball_close(&b);
}
END_TEST

int main(void) {
  return suite_run("surface_average",
                   (SuiteTests){a_constant_is_its_own_mean, a_coordinate_shrinks_by_the_factor_of_the_sphere,
                                one_point_of_each_orbit_gives_the_means_of_the_whole,
                                below_the_distance_of_points_nothing_is_averaged, NULL});
}
