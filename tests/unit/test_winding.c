/* Winding numbers of spheres and of surfaces that cross themselves, where they are known.
 *
 * A whole number is meant within 0.1: near pieces are flat, and cuts of neighbouring elements do not match.
 */
#include "mesh/winding.h"

#include "near_shapes.h"
#include "suite.h"
#include <stdlib.h>

typedef struct {
  Mesh mesh;
  double *x;
} Surface;

static Surface surface(int subdivisions, NearShape *shape, double gap) {
  Surface made;
  Error error;
  ck_assert_int_eq(mesh_sphere(&made.mesh, subdivisions, NULL, &error), STATUS_OK);
  made.x = malloc(3 * (size_t)made.mesh.n_nodes * sizeof *made.x);
  ck_assert_ptr_nonnull(made.x);
  near_shape(shape, gap, &made.mesh, made.x);
  return made;
}

static void release(Surface *made) {
  free(made->x);
  mesh_free(&made->mesh);
}

static void expect(const Surface *made, double x, double y, double z, double winding) {
  const double point[3] = {x, y, z};
  ck_assert_double_eq_tol(winding_number(&made->mesh, made->x, point), winding, 0.1);
}

static void sphere(double gap, const double X[3], double x[3]) {
  (void)gap;
  for (int i = 0; i < 3; i++) x[i] = X[i];
}

START_TEST(a_sphere_winds_once_around_what_is_inside) {
  for (int subdivisions = 1; subdivisions <= 3; subdivisions++) {
    Surface made = surface(subdivisions, sphere, 0);
    const double *X = made.mesh.X;
    const double edge = mesh_edge_length(&made.mesh, X);
    expect(&made, 0, 0, 0, 1);
    expect(&made, 3, 1, 0, 0);
    for (int p = 0; p < made.mesh.n_nodes;
         p += 17) { /* next to nodes, 1/1000 of an element above and below */
      const double in = 1 - 1e-3 * edge, out = 1 + 1e-3 * edge;
      expect(&made, in * X[3 * p], in * X[3 * p + 1], in * X[3 * p + 2], 1);
      expect(&made, out * X[3 * p], out * X[3 * p + 1], out * X[3 * p + 2], 0);
    }
    release(&made);
  }
}
END_TEST

START_TEST(faces_that_have_passed_through_each_other_wind_the_other_way) {
  Surface disc = surface(3, biconcave_disc, -0.1); /* they meet at a radius of 0.227 */
  expect(&disc, 0, 0, 0, -1);
  expect(&disc, 0.1, -0.1, 0, -1);
  expect(&disc, 0.5, 0.3, 0, 1);
  expect(&disc, 0, 0, 0.3, 0);
  release(&disc);
}
END_TEST

START_TEST(overlapping_tips_are_wound_around_twice) {
  Surface rod = surface(3, bent_rod, -0.2);
  expect(&rod, 0, 0, 1.6, 2);
  expect(&rod, 0, 0, 0, 1);
  expect(&rod, 0, 0, 0.8, 0);
  release(&rod);
}
END_TEST

int main(void) {
  return suite_run("winding", (SuiteTests){a_sphere_winds_once_around_what_is_inside,
                                           faces_that_have_passed_through_each_other_wind_the_other_way,
                                           overlapping_tips_are_wound_around_twice, NULL});
}
