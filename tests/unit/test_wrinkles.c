/* Amplitudes of waves of known height on spheres and ellipsoids, and of smooth shapes, which have none. */
#include "observe/wrinkles.h"

#include "base/array.h"
#include "base/vec3.h"
#include "suite.h"
#include <stdio.h>

static const double PI = 3.14159265358979323846;

typedef struct {
  Mesh mesh;
  Symmetry symmetry;
  double *x, edge;
  Wrinkles *wrinkles;
} Surface;

static void surface_new(Surface *made, int subdivisions, double jitter, const double gradient[3][3]) {
  Error error;
  ck_assert_int_eq(mesh_sphere(&made->mesh, subdivisions, NULL, &error), STATUS_OK);
  if (jitter > 0) mesh_jitter(&made->mesh, jitter, 3);
  made->edge = mesh_edge_length(&made->mesh, made->mesh.X);
  ck_assert_int_eq(ARRAY_NEW(&made->x, 3 * (size_t)made->mesh.n_nodes, &error), STATUS_OK);
  if (gradient)
    ck_assert_int_eq(symmetry_find(&made->symmetry, &made->mesh, made->mesh.X, gradient, &error), STATUS_OK);
  else
    ck_assert_int_eq(symmetry_none(&made->symmetry, &made->mesh, &error), STATUS_OK);
  ck_assert_int_eq(wrinkles_new(&made->wrinkles, &made->mesh, &made->symmetry, &error), STATUS_OK);
}

static void surface_free(Surface *made) {
  wrinkles_free(made->wrinkles);
  array_free(made->x);
  symmetry_free(&made->symmetry);
  mesh_free(&made->mesh);
}

/* The sphere with an affine motion. */
static void move(Surface *made, const double F[3][3]) {
  for (int p = 0; p < made->mesh.n_nodes; p++)
    for (int i = 0; i < 3; i++) made->x[3 * p + i] = vec3_dot(F[i], made->mesh.X + 3 * p);
}

/* Legendre polynomial: waves around an axis, of the length 2 pi / (l + 1/2). */
static double legendre(int l, double z) {
  double before = 1, now = z;
  for (int k = 1; k < l; k++) {
    const double next = ((2 * k + 1) * z * now - k * before) / (k + 1);
    before = now;
    now = next;
  }
  return now;
}

/* Isotropic waves with `length` mean edges to a wave, of root mean square `height` over the corners. */
static double wave(const Surface *made, double length, double height, double *waves) {
  enum { AXES = 24 };
  const int l = (int)lround(2 * PI / (length * made->edge) - 0.5);
  double sum = 0;
  for (int p = 0; p < made->mesh.n_nodes; p++) {
    waves[p] = 0;
    for (int k = 0; k < AXES; k++) { /* spread over the sphere by the golden angle, with signs by turns */
      const double z = (2 * k + 1.0) / AXES - 1, r = sqrt(1 - z * z), turn = 2.399963229728653 * k;
      const double axis[3] = {r * cos(turn), r * sin(turn), z};
      waves[p] += (k % 3 == 0 ? -1 : 1) * legendre(l, vec3_dot(axis, made->mesh.X + 3 * p));
    }
    if (p < made->mesh.n_vertices) sum += waves[p] * waves[p];
  }
  const double scale = height / sqrt(sum / made->mesh.n_vertices);
  for (int p = 0; p < made->mesh.n_nodes; p++) waves[p] *= scale;
  return 2 * PI / ((l + 0.5) * made->edge);
}

/* The share of waves on the sphere that is seen. */
static double seen(Surface *made, double length) {
  const double height = 2e-3;
  double *waves;
  Error error;
  ck_assert_int_eq(ARRAY_NEW(&waves, made->mesh.n_nodes, &error), STATUS_OK);
  const double actual = wave(made, length, height, waves);
  for (int i = 0; i < 3 * made->mesh.n_nodes; i++) made->x[i] = (1 + waves[i / 3]) * made->mesh.X[i];
  const double share = wrinkles_amplitude(made->wrinkles, made->x) / height;
  printf("%d elements, waves of %.2f edges: %.3f\n", made->mesh.n_elements, actual, share);
  array_free(waves);
  return share;
}

/* Round-off of positions of order one. */
START_TEST(affine_motions_have_no_wrinkles) {
  static const double motions[][3][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                         {{2, 0, 0}, {0, 1, 0}, {0, 0, 0.5}},
                                         {{1.2, 0.3, -0.7}, {0.1, 0.9, 0.2}, {0.4, -0.5, 1.4}}};
  for (int subdivisions = 0; subdivisions <= 4; subdivisions++)
    for (int irregular = 0; irregular < 2; irregular++) {
      Surface made;
      surface_new(&made, subdivisions, 0.3 * irregular, NULL);
      for (int k = 0; k < 3; k++) {
        move(&made, motions[k]);
        ck_assert_double_lt(wrinkles_amplitude(made.wrinkles, made.x), 1e-12);
      }
      surface_free(&made);
    }
}
END_TEST

/* What the mesh does not resolve is what is meant: waves up to two elements long. */
START_TEST(waves_are_seen_as_far_as_the_mesh_made_them) {
  for (int subdivisions = 2; subdivisions <= 3; subdivisions++) {
    Surface made;
    surface_new(&made, subdivisions, 0, NULL);
    ck_assert_double_eq_tol(seen(&made, 1), 1, 0.1);
    ck_assert_double_eq_tol(seen(&made, 1.5), 1, 0.1);
    ck_assert_double_eq_tol(seen(&made, 2), 0.4, 0.1);
    ck_assert_double_le(seen(&made, 3), 0.15);
    ck_assert_double_le(seen(&made, 6), 0.02);
    surface_free(&made);
  }
}
END_TEST

START_TEST(waves_on_an_ellipsoid_are_measured_along_its_normal) {
  Surface made;
  double *waves;
  Error error;
  const double height = 1e-3, axes[3] = {1.5, 1, 0.7};
  surface_new(&made, 3, 0, NULL);
  ck_assert_int_eq(ARRAY_NEW(&waves, made.mesh.n_nodes, &error), STATUS_OK);
  wave(&made, 1.5, height, waves);
  for (int p = 0; p < made.mesh.n_nodes; p++) {
    double normal[3];
    for (int i = 0; i < 3; i++) normal[i] = made.mesh.X[3 * p + i] / axes[i];
    vec3_normalize(normal);
    for (int i = 0; i < 3; i++) made.x[3 * p + i] = axes[i] * made.mesh.X[3 * p + i] + waves[p] * normal[i];
  }
  ck_assert_double_eq_tol(wrinkles_amplitude(made.wrinkles, made.x), height, 0.1 * height);
  for (int p = 0; p < made.mesh.n_nodes; p++) { /* the same waves along the surface: a tenth */
    double normal[3], along[3];
    for (int i = 0; i < 3; i++) normal[i] = made.mesh.X[3 * p + i] / axes[i];
    vec3_normalize(normal);
    vec3_cross(normal, axes, along);
    for (int i = 0; i < 3; i++) made.x[3 * p + i] = axes[i] * made.mesh.X[3 * p + i] + waves[p] * along[i];
  }
  ck_assert_double_lt(wrinkles_amplitude(made.wrinkles, made.x), 0.12 * height);
  array_free(waves);
  surface_free(&made);
}
END_TEST

/* A pear with tips of different sharpness.  What is left falls with the third power of the elements, more or
 * less: which nodes are within reach is not the same on all meshes. */
START_TEST(smooth_shapes_leave_less_on_finer_meshes) {
  double before = INFINITY;
  for (int subdivisions = 2; subdivisions <= 4; subdivisions++) {
    Surface made;
    surface_new(&made, subdivisions, 0, NULL);
    for (int p = 0; p < made.mesh.n_nodes; p++) {
      const double *X = made.mesh.X + 3 * p, swell = exp(0.6 * X[0]);
      const double x[3] = {1.5 * X[0] + 0.2 * sin(2 * X[2]), swell * X[1], 0.8 * swell * X[2]};
      for (int i = 0; i < 3; i++) made.x[3 * p + i] = x[i];
    }
    const double left = wrinkles_amplitude(made.wrinkles, made.x);
    printf("%d elements: %.2e\n", made.mesh.n_elements, left);
    if (subdivisions > 2) ck_assert_double_gt(before / left, 5); /* 9.0 and 6.6 */
    before = left;
    surface_free(&made);
  }
  ck_assert_double_lt(before, 2e-5);
}
END_TEST

START_TEST(one_corner_of_each_orbit_is_enough) {
  static const double shear[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  Surface whole, part;
  surface_new(&whole, 2, 0, NULL);
  surface_new(&part, 2, 0, shear);
  ck_assert_int_eq(part.symmetry.n_operations, 4);
  for (int i = 0; i < 3 * whole.mesh.n_nodes;
       i++) { /* even in each coordinate, so that it has the symmetry */
    const double *X = whole.mesh.X + 3 * (i / 3);
    whole.x[i] = (1 + 0.01 * cos(9 * X[0]) * cos(8 * X[1]) * cos(7 * X[2])) * X[i % 3];
  }
  const double all = wrinkles_amplitude(whole.wrinkles, whole.x);
  ck_assert_double_gt(all, 1e-4);
  ck_assert_double_eq_tol(wrinkles_amplitude(part.wrinkles, whole.x), all, 1e-12);
  surface_free(&whole);
  surface_free(&part);
}
END_TEST

START_TEST(running_out_of_memory_is_reported) {
  Mesh mesh;
  Symmetry symmetry;
  Error error;
  Wrinkles *wrinkles;
  ck_assert_int_eq(mesh_sphere(&mesh, 1, NULL, &error), STATUS_OK);
  ck_assert_int_eq(symmetry_none(&symmetry, &mesh, &error), STATUS_OK);
  Status status = STATUS_MEMORY;
  int n = 1;
  for (; status == STATUS_MEMORY && n < 100; n++) {
    array_fail_nth(n);
    status = wrinkles_new(&wrinkles, &mesh, &symmetry, &error);
  }
  array_fail_nth(0);
  ck_assert_int_eq(status, STATUS_OK);
  ck_assert_int_eq(n, 5); /* three arrays */
  wrinkles_free(wrinkles);
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

int main(void) {
  return suite_run("wrinkles",
                   (SuiteTests){affine_motions_have_no_wrinkles, waves_are_seen_as_far_as_the_mesh_made_them,
                                waves_on_an_ellipsoid_are_measured_along_its_normal,
                                smooth_shapes_leave_less_on_finer_meshes, one_corner_of_each_orbit_is_enough,
                                running_out_of_memory_is_reported, NULL});
}
