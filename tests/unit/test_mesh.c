/* The icosphere: counts, topology, nesting, tables, symmetry and rotation. */
#include "base/array.h"
#include "base/vec3.h"
#include "mesh/mesh.h"

#include "suite.h"
#include <stdlib.h>
#include <string.h>

enum { MAX_LEVEL = 4 };

static Mesh sphere(int subdivisions, const MeshRotation *rotation) {
  Mesh mesh;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, rotation, &error), STATUS_OK);
  return mesh;
}

START_TEST(counts_follow_the_subdivisions) {
  for (int level = 0; level < MAX_LEVEL; level++) {
    Mesh mesh = sphere(level, NULL);
    int quarter = 1 << (2 * level);
    ck_assert_int_eq(mesh.subdivisions, level);
    ck_assert_int_eq(mesh.n_elements, 20 * quarter);
    ck_assert_int_eq(mesh.n_vertices, 10 * quarter + 2);
    ck_assert_int_eq(mesh.n_nodes, 40 * quarter + 2);
    mesh_free(&mesh);
  }
}
END_TEST

START_TEST(surface_is_closed_outward_and_of_euler_number_two) {
  for (int level = 0; level < MAX_LEVEL; level++) {
    Mesh mesh = sphere(level, NULL);
    Error error;
    ck_assert_int_eq(mesh_check(&mesh, &error), STATUS_OK);
    mesh_free(&mesh);
  }
}
END_TEST

START_TEST(check_names_what_is_wrong) {
  Error error;
  Mesh mesh = sphere(1, NULL);
  for (int e = 0; e < mesh.n_elements; e++) { /* inside out: swap corners 1 and 2 and the edges with them */
    int *node = mesh.element[e], n[6];
    memcpy(n, node, sizeof n);
    const int turned[6] = {n[0], n[2], n[1], n[5], n[4], n[3]};
    memcpy(node, turned, sizeof turned);
  }
  for (int k = 0; k < 6 * mesh.n_elements; k++) {
    static const int turned_local[6] = {0, 2, 1, 5, 4, 3};
    mesh.node_local[k] = turned_local[mesh.node_local[k]];
  }
  ck_assert_int_eq(mesh_check(&mesh, &error), STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "outward"));
  mesh_free(&mesh);

  mesh = sphere(1, NULL); /* one element turned round: its edges run the wrong way */
  int n[6];
  memcpy(n, mesh.element[7], sizeof n);
  const int turned[6] = {n[1], n[0], n[2], n[3], n[5], n[4]};
  memcpy(mesh.element[7], turned, sizeof turned);
  ck_assert_int_eq(mesh_check(&mesh, &error), STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "sense"));
  mesh_free(&mesh);

  mesh = sphere(1, NULL); /* an unused vertex */
  mesh.n_vertices--;
  ck_assert_int_eq(mesh_check(&mesh, &error), STATUS_FAILED);
  mesh_free(&mesh);
}
END_TEST

START_TEST(nodes_lie_on_the_unit_sphere_and_mid_nodes_between_their_corners) {
  for (int level = 0; level < MAX_LEVEL; level++) {
    Mesh mesh = sphere(level, NULL);
    for (int p = 0; p < mesh.n_nodes; p++)
      ck_assert_double_eq_tol(vec3_norm(&mesh.X[3 * p]), 1.0, 4e-16); /* two roundings of a component */
    for (int e = 0; e < mesh.n_elements; e++)
      for (int k = 0; k < 3; k++) {
        const double *a = &mesh.X[3 * mesh.element[e][k]], *b = &mesh.X[3 * mesh.element[e][(k + 1) % 3]];
        const double *middle = &mesh.X[3 * mesh.element[e][3 + k]];
        ck_assert_int_ge(mesh.element[e][3 + k], mesh.n_vertices);
        ck_assert_int_lt(mesh.element[e][k], mesh.n_vertices);
        double sum[3] = {a[0] + b[0], a[1] + b[1], a[2] + b[2]}, cross[3];
        vec3_cross(sum, middle, cross);
        ck_assert_double_eq_tol(vec3_norm(cross), 0.0, 1e-15); /* parallel to a + b, to round-off */
        ck_assert_double_gt(vec3_dot(sum, middle), 0.0);
      }
    mesh_free(&mesh);
  }
}
END_TEST

START_TEST(two_fold_axes_lie_on_the_coordinate_axes) {
  /* An edge of the icosahedron crosses each half axis: its mid-edge nodes are the six unit vectors. */
  Mesh mesh = sphere(0, NULL);
  int found = 0;
  for (int p = mesh.n_vertices; p < mesh.n_nodes; p++)
    for (int i = 0; i < 3; i++) found += fabs(mesh.X[3 * p + i]) == 1.0;
  ck_assert_int_eq(found, 6);
  mesh_free(&mesh);
}
END_TEST

START_TEST(meshes_are_nested_node_by_node) {
  for (int level = 0; level < MAX_LEVEL; level++) {
    Mesh coarse = sphere(level, NULL), fine = sphere(level + 1, NULL);
    ck_assert_int_eq(coarse.n_nodes, fine.n_vertices);
    ck_assert_mem_eq(coarse.X, fine.X, 3 * (size_t)coarse.n_nodes * sizeof *coarse.X);
    for (int e = 0; e < coarse.n_elements; e++) { /* element e is covered by elements 4 e .. 4 e + 3 */
      const int *n = coarse.element[e];
      const int child[4][3] = {
          {n[0], n[3], n[5]}, {n[3], n[1], n[4]}, {n[5], n[4], n[2]}, {n[3], n[4], n[5]}};
      for (int k = 0; k < 4; k++) ck_assert_mem_eq(fine.element[4 * e + k], child[k], sizeof child[k]);
    }
    mesh_free(&coarse);
    mesh_free(&fine);
  }
}
END_TEST

START_TEST(node_tables_are_the_inverse_of_the_elements) {
  for (int level = 0; level < MAX_LEVEL; level++) {
    Mesh mesh = sphere(level, NULL);
    ck_assert_int_eq(mesh.node_start[0], 0);
    ck_assert_int_eq(mesh.node_start[mesh.n_nodes], 6 * mesh.n_elements);
    int five = 0;
    for (int p = 0; p < mesh.n_nodes; p++) {
      int valence = mesh.node_start[p + 1] - mesh.node_start[p];
      if (p < mesh.n_vertices) {
        ck_assert(valence == 5 || valence == 6);
        five += valence == 5;
      } else {
        ck_assert_int_eq(valence, 2);
      }
      for (int k = mesh.node_start[p]; k < mesh.node_start[p + 1]; k++) {
        ck_assert_int_eq(mesh.element[mesh.node_element[k]][mesh.node_local[k]], p);
        if (k > mesh.node_start[p]) ck_assert_int_gt(mesh.node_element[k], mesh.node_element[k - 1]);
      }
    }
    ck_assert_int_eq(five, 12);
    mesh_free(&mesh);
  }
}
END_TEST

static int compare_points(const void *a, const void *b) {
  const double *p = a, *q = b;
  for (int i = 0; i < 3; i++)
    if (p[i] != q[i]) return p[i] < q[i] ? -1 : 1;
  return 0;
}

/* The nodes with the components turned by `sign`, sorted; 0.0 stands for both zeros. */
static double *sorted_nodes(const Mesh *mesh, const double sign[3]) {
  double *X = malloc(3 * (size_t)mesh->n_nodes * sizeof *X);
  ck_assert_ptr_nonnull(X);
  for (int p = 0; p < mesh->n_nodes; p++)
    for (int i = 0; i < 3; i++) X[3 * p + i] = sign[i] * mesh->X[3 * p + i] + 0.0;
  qsort(X, (size_t)mesh->n_nodes, 3 * sizeof *X, compare_points);
  return X;
}

START_TEST(mirrors_in_the_coordinate_planes_map_nodes_on_nodes_bit_for_bit) {
  for (int level = 0; level < MAX_LEVEL; level++) {
    Mesh mesh = sphere(level, NULL);
    double *original = sorted_nodes(&mesh, (const double[3]){1.0, 1.0, 1.0});
    for (int axis = 0; axis < 3; axis++) {
      double sign[3] = {1.0, 1.0, 1.0};
      sign[axis] = -1.0;
      double *mirrored = sorted_nodes(&mesh, sign);
      for (int k = 0; k < 3 * mesh.n_nodes; k++) ck_assert_double_eq(mirrored[k], original[k]);
      free(mirrored);
    }
    free(original);
    mesh_free(&mesh);
  }
}
END_TEST

START_TEST(rotation_turns_every_node_about_the_axis) {
  /* A third of a turn about (1,1,1) sends x to y to z to x; a quarter about z sends x to y. */
  Mesh mesh = sphere(2, NULL);
  Mesh third = sphere(2, &(MeshRotation){{5.0, 5.0, 5.0}, 2.0 * acos(-1.0) / 3.0});
  Mesh quarter = sphere(2, &(MeshRotation){{0.0, 0.0, 0.1}, 0.5 * acos(-1.0)});
  for (int p = 0; p < mesh.n_nodes; p++) {
    const double *X = &mesh.X[3 * p];
    const double cycled[3] = {X[2], X[0], X[1]}, turned[3] = {-X[1], X[0], X[2]};
    for (int i = 0; i < 3; i++) { /* round-off of Rodrigues' formula */
      ck_assert_double_eq_tol(third.X[3 * p + i], cycled[i], 1e-15);
      ck_assert_double_eq_tol(quarter.X[3 * p + i], turned[i], 1e-15);
    }
  }
  mesh_free(&mesh);
  mesh_free(&third);
  mesh_free(&quarter);
}
END_TEST

START_TEST(no_rotation_changes_no_bit) {
  Mesh mesh = sphere(2, NULL), turned = sphere(2, &(MeshRotation){{0.0, 1.0, 0.0}, 0.0});
  ck_assert_mem_eq(mesh.X, turned.X, 3 * (size_t)mesh.n_nodes * sizeof *mesh.X);
  mesh_free(&mesh);
  mesh_free(&turned);
}
END_TEST

START_TEST(edge_length_of_the_icosahedron_is_known) {
  Mesh mesh = sphere(0, NULL); /* circumradius 1: edge 1/sin(2 pi/5); a sum of 60 terms */
  ck_assert_double_eq_tol(mesh_edge_length(&mesh, mesh.X), 1.0 / sin(0.4 * acos(-1.0)), 1e-14);
  mesh_free(&mesh);
}
END_TEST

START_TEST(bad_input_is_refused_with_what_was_expected) {
  Mesh mesh;
  Error error;
  static const int levels[] = {-1, 8};
  for (int k = 0; k < 2; k++) {
    ck_assert_int_eq(mesh_sphere(&mesh, levels[k], NULL, &error), STATUS_INPUT);
    ck_assert_ptr_nonnull(strstr(error.text, "0 to 7"));
  }
  const MeshRotation bad[] = {{{0.0, 0.0, 0.0}, 1.0}, {{0.0, NAN, 0.0}, 1.0}, {{1.0, 0.0, 0.0}, INFINITY}};
  for (int k = 0; k < 3; k++) {
    ck_assert_int_eq(mesh_sphere(&mesh, 0, &bad[k], &error), STATUS_INPUT);
    ck_assert_ptr_nonnull(strstr(error.text, "rotation"));
    ck_assert_ptr_null(mesh.X);
  }
}
END_TEST

START_TEST(a_jittered_mesh_is_whole_irregular_and_the_same_for_the_same_seed) {
  for (int seed = 1; seed <= 20; seed++) {
    Mesh regular = sphere(2, NULL), mesh = sphere(2, NULL), again = sphere(2, NULL);
    Error error;
    mesh_jitter(&mesh, 0.3, seed);
    mesh_jitter(&again, 0.3, seed);
    ck_assert_int_eq(mesh_check(&mesh, &error), STATUS_OK);
    ck_assert_mem_eq(mesh.X, again.X, 3 * (size_t)mesh.n_nodes * sizeof *mesh.X);
    const double reach = 0.3 * mesh_edge_length(&regular, regular.X);
    double farthest = 0;
    for (int p = 0; p < mesh.n_nodes; p++) {
      double shift[3];
      for (int i = 0; i < 3; i++) shift[i] = mesh.X[3 * p + i] - regular.X[3 * p + i];
      farthest = fmax(farthest, vec3_norm(shift));
      ck_assert_double_eq_tol(vec3_norm(&mesh.X[3 * p]), 1, 1e-15);
    }
    ck_assert_double_gt(farthest, reach); /* one of 162 corners goes far in two directions at once */
    ck_assert_double_lt(farthest, 1.1 * sqrt(3) * reach); /* all three; and back onto the sphere */
    mesh_jitter(&again, 0.3, seed + 1);
    ck_assert_mem_ne(mesh.X, again.X, 3 * (size_t)mesh.n_nodes * sizeof *mesh.X);
    mesh_free(&regular);
    mesh_free(&mesh);
    mesh_free(&again);
  }
}
END_TEST

START_TEST(any_failing_allocation_is_reported_and_leaves_nothing) {
  Mesh mesh;
  Error error;
  int failures = 0;
  for (long n = 1; n < 100; n++) {
    array_fail_nth(n);
    Status status = mesh_sphere(&mesh, 1, NULL, &error);
    array_fail_nth(0);
    if (status == STATUS_OK) {
      mesh_free(&mesh);
      break;
    }
    failures++;
    ck_assert_int_eq(status, STATUS_MEMORY);
    ck_assert_ptr_null(mesh.X);
  }
  ck_assert_int_eq(failures, 10); /* five arrays of the mesh, two for each halving, one for the tables */
}
END_TEST

int main(void) {
  return suite_run(
      "mesh", (SuiteTests){
                  counts_follow_the_subdivisions, surface_is_closed_outward_and_of_euler_number_two,
                  check_names_what_is_wrong, nodes_lie_on_the_unit_sphere_and_mid_nodes_between_their_corners,
                  two_fold_axes_lie_on_the_coordinate_axes, meshes_are_nested_node_by_node,
                  node_tables_are_the_inverse_of_the_elements,
                  mirrors_in_the_coordinate_planes_map_nodes_on_nodes_bit_for_bit,
                  rotation_turns_every_node_about_the_axis, no_rotation_changes_no_bit,
                  a_jittered_mesh_is_whole_irregular_and_the_same_for_the_same_seed,
                  edge_length_of_the_icosahedron_is_known, bad_input_is_refused_with_what_was_expected,
                  any_failing_allocation_is_reported_and_leaves_nothing, NULL});
}
