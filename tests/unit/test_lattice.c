/* The lattice of 15 nodes on four elements or triangles of a nested mesh, and interpolation from it. */
#include "base/array.h"
#include "base/vec3.h"
#include "fluid/lattice.h"
#include "fluid/moment_kernel.h"
#include "mesh/mesh.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static void new_sphere(Mesh *mesh, int subdivisions) {
  Error error;
  ck_assert_int_eq(mesh_sphere(mesh, subdivisions, NULL, &error), STATUS_OK);
}

static void element_lattice(const Mesh *mesh, int triangle, int node[LATTICE_NODES]) {
  Error error;
  const int(*children)[6] = (const int(*)[6])(mesh->element + CHILDREN * triangle);
  ck_assert_int_eq(lattice_of_elements(children, node, &error), STATUS_OK);
}

/* A quartic in the coordinates of the plane of three corners. */
static double quartic(const double origin[3], const double a[3], const double b[3], const double X[3]) {
  double offset[3];
  vec3_subtract(X, origin, offset);
  double s = vec3_dot(a, offset), t = vec3_dot(b, offset);
  return 1 + s - 2 * t + s * t + 3 * s * s * t - t * t * t + s * s * s * s - 0.5 * s * s * t * t;
}

START_TEST(lattice_is_made_of_nodes_of_the_coarser_mesh_and_the_two_between) {
  Mesh mesh, coarse;
  int node[LATTICE_NODES];
  new_sphere(&mesh, 2);
  new_sphere(&coarse, 1);
  for (int triangle = 0; triangle < coarse.n_elements; triangle++) {
    element_lattice(&mesh, triangle, node);
    /* Nodes keep their numbers in finer meshes; corners and middles of the sides stand at even places. */
    const int corner[3] = {0, 4, 14}, middle[3] = {2, 11, 9};
    for (int k = 0; k < 3; k++) {
      ck_assert_int_eq(node[corner[k]], coarse.element[triangle][k]);
      ck_assert_int_eq(node[middle[k]], coarse.element[triangle][3 + k]);
    }
    for (int k = 0; k < LATTICE_NODES; k++) {
      for (int m = 0; m < k; m++) ck_assert_int_ne(node[k], node[m]);
    }
  }
  mesh_free(&mesh);
  mesh_free(&coarse);
}
END_TEST

START_TEST(lattice_of_four_lattices_is_that_of_the_coarser_mesh) {
  Mesh mesh, coarse;
  Error error;
  new_sphere(&mesh, 2);
  new_sphere(&coarse, 1);
  for (int triangle = 0; triangle < 20; triangle++) {
    int child[CHILDREN][LATTICE_NODES], node[LATTICE_NODES], expected[LATTICE_NODES];
    for (int c = 0; c < CHILDREN; c++) element_lattice(&mesh, CHILDREN * triangle + c, child[c]);
    ck_assert_int_eq(lattice_of_lattices((const int(*)[LATTICE_NODES])child, node, &error), STATUS_OK);
    element_lattice(&coarse, triangle, expected);
    ck_assert_mem_eq(node, expected, sizeof node);
  }
  mesh_free(&mesh);
  mesh_free(&coarse);
}
END_TEST

START_TEST(children_that_do_not_fit_are_refused) {
  Mesh mesh;
  Error error;
  int node[LATTICE_NODES], mixed[CHILDREN][6];
  new_sphere(&mesh, 1);
  memcpy(mixed, mesh.element, sizeof mixed);
  memcpy(mixed[3], mesh.element[17], sizeof mixed[3]);
  ck_assert_int_eq(lattice_of_elements((const int(*)[6])mixed, node, &error), STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "coarser mesh"));
  mesh_free(&mesh);
}
END_TEST

START_TEST(interpolation_is_exact_for_quartics_of_the_plane) {
  Mesh mesh;
  Error error;
  int node[LATTICE_NODES];
  LatticeFit fit;
  new_sphere(&mesh, 2);
  element_lattice(&mesh, 33, node);
  ck_assert_int_eq(lattice_fit(&fit, mesh.X, node, &error), STATUS_OK);
  const double *origin = mesh.X + 3 * node[0];
  double a[3], b[3];
  vec3_subtract(mesh.X + 3 * node[4], origin, a);
  vec3_subtract(mesh.X + 3 * node[14], origin, b);
  const double points[][2] = {{0.3, 0.2}, {0, 0}, {0.5, 0.5}, {0.1, 0.8}};
  for (int i = 0; i < 4; i++) {
    double X[3], weight[LATTICE_LANES], sum = 0;
    for (int c = 0; c < 3; c++) X[c] = origin[c] + points[i][0] * a[c] + points[i][1] * b[c];
    lattice_weights(&fit, X, weight);
    for (int k = 0; k < LATTICE_NODES; k++) {
      sum += weight[k] * quartic(origin, a, b, mesh.X + 3 * node[k]);
    }
    /* 15 weights of order 1 from a matrix with a condition of some 10 */
    ck_assert_double_eq_tol(sum, quartic(origin, a, b, X), 1e-12);
    ck_assert(weight[LATTICE_NODES] == 0);
  }
  mesh_free(&mesh);
}
END_TEST

START_TEST(nodes_in_a_line_are_refused) {
  double X[3 * LATTICE_NODES];
  int node[LATTICE_NODES];
  Error error;
  LatticeFit fit;
  for (int k = 0; k < LATTICE_NODES; k++) {
    node[k] = k;
    for (int c = 0; c < 3; c++) X[3 * k + c] = k * (c + 1);
  }
  ck_assert_int_eq(lattice_fit(&fit, X, node, &error), STATUS_FAILED);
}
END_TEST

/* Places on the sphere between the nodes of a lattice: the same shares of a smooth function's values give
 * that function there, and the deviation falls with the fifth power of the size. */
static double deviation(int subdivisions) {
  Mesh mesh, fine;
  Error error;
  double largest = 0;
  new_sphere(&mesh, subdivisions);
  new_sphere(&fine, subdivisions + 1);
  for (int triangle = 0; triangle < mesh.n_elements / CHILDREN; triangle++) {
    int node[LATTICE_NODES];
    LatticeFit fit;
    element_lattice(&mesh, triangle, node);
    ck_assert_int_eq(lattice_fit(&fit, mesh.X, node, &error), STATUS_OK);
    for (int i = 0; i < 16 * 6; i++) { /* nodes of the sixteen elements of the finer mesh */
      const double *X = fine.X + 3 * fine.element[16 * triangle + i / 6][i % 6];
      double weight[LATTICE_LANES], difference[3] = {-X[0], -X[1], -X[2]};
      lattice_weights(&fit, X, weight);
      for (int k = 0; k < LATTICE_NODES; k++) {
        for (int c = 0; c < 3; c++) difference[c] += weight[k] * mesh.X[3 * node[k] + c];
      }
      largest = fmax(largest, vec3_norm(difference));
    }
  }
  mesh_free(&mesh);
  mesh_free(&fine);
  return largest;
}

START_TEST(interpolated_places_fall_on_the_sphere_with_the_fifth_power) {
  double coarse = deviation(2), fine = deviation(3);
  ck_assert_double_lt(fine, 1e-5);
  ck_assert_double_gt(coarse / fine, 28); /* 2^5, not yet quite in the limit */
}
END_TEST

START_TEST(moments_keep_force_and_report_the_roughness) {
  enum { N = 11 };
  double weight[N][LATTICE_LANES] = {{0}};
  OseenBlock from[2] = {0}, moments[LATTICE_BLOCKS] = {0};
  double force[3] = {0, 0, 0};
  for (int k = 0; k < LATTICE_NODES; k++) moments[k / OSEEN_LANES].y[0][k % OSEEN_LANES] = k;
  for (int i = 0; i < N; i++) { /* halfway between lattice nodes i and i + 1, the 7th out of place by 0.25 */
    weight[i][i] = weight[i][i + 1] = 0.5;
    from[i / OSEEN_LANES].y[0][i % OSEEN_LANES] = i + 0.5;
    for (int c = 0; c < 3; c++) from[i / OSEEN_LANES].f[c][i % OSEEN_LANES] = i * (c + 1) + 1;
    for (int c = 0; c < 3; c++) force[c] += i * (c + 1) + 1;
  }
  from[0].y[2][7] = 0.25;
  double rough2 = moment_add((const double(*)[LATTICE_LANES])weight, N, from, moments);
  ck_assert_double_eq_tol(rough2, 0.0625, 1e-15);
  for (int c = 0; c < 3; c++) {
    double sum = 0;
    for (int k = 0; k < LATTICE_LANES; k++) sum += moments[k / OSEEN_LANES].f[c][k % OSEEN_LANES];
    ck_assert_double_eq_tol(sum, force[c], 1e-13);
  }
  ck_assert_double_eq_tol(moments[0].f[0][3], 0.5 * 3 + 0.5 * 4, 1e-15); /* halves of forces 2 and 3 */
}
END_TEST

int main(void) {
  return suite_run("lattice",
                   (SuiteTests){lattice_is_made_of_nodes_of_the_coarser_mesh_and_the_two_between,
                                lattice_of_four_lattices_is_that_of_the_coarser_mesh,
                                children_that_do_not_fit_are_refused,
                                interpolation_is_exact_for_quartics_of_the_plane, nodes_in_a_line_are_refused,
                                interpolated_places_fall_on_the_sphere_with_the_fifth_power,
                                moments_keep_force_and_report_the_roughness, NULL});
}
