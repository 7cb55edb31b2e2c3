/* The symmetry group of icospheres and linear flows: its operations, what they do to nodes and elements, and
 * the orbits. */
#include "base/array.h"
#include "mesh/symmetry.h"
#include "random.h"
#include "suite.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

static const double simple_shear[3][3] = {{0.0, 0.0, 1.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
static const double planar_hyperbolic[3][3] = {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}};
static const double general_flow[3][3] = {{0.1, 0.2, 1.0}, {0.3, 0.2, 0.0}, {0.0, 0.4, -0.3}};

static Mesh sphere(int subdivisions, const MeshRotation *rotation) {
  Mesh mesh;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, rotation, &error), STATUS_OK);
  return mesh;
}

static Symmetry group(const Mesh *mesh, const double gradient[3][3]) {
  Symmetry symmetry;
  Error error;
  ck_assert_int_eq(symmetry_find(&symmetry, mesh, mesh->X, gradient, &error), STATUS_OK);
  return symmetry;
}

static int group_size(const Mesh *mesh, const double gradient[3][3]) {
  Symmetry symmetry = group(mesh, gradient);
  int size = symmetry.n_operations;
  symmetry_free(&symmetry);
  return size;
}

static int find_sign(const Symmetry *symmetry, double x, double y, double z) {
  for (int k = 0; k < symmetry->n_operations; k++) {
    const double *sign = symmetry->operation[k].sign;
    if (sign[0] == x && sign[1] == y && sign[2] == z) return k;
  }
  return -1;
}

START_TEST(simple_shear_keeps_identity_inversion_mirror_and_half_turn_about_the_vorticity_axis) {
  Mesh mesh = sphere(2, NULL);
  Symmetry symmetry = group(&mesh, simple_shear);
  ck_assert_int_eq(symmetry.n_operations, 4);
  ck_assert_int_eq(find_sign(&symmetry, 1.0, 1.0, 1.0), 0);
  ck_assert_int_gt(find_sign(&symmetry, -1.0, -1.0, -1.0), 0);
  ck_assert_int_gt(find_sign(&symmetry, 1.0, -1.0, 1.0), 0);
  ck_assert_int_gt(find_sign(&symmetry, -1.0, 1.0, -1.0), 0);
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

START_TEST(planar_hyperbolic_flow_and_no_flow_keep_all_eight_and_any_linear_flow_the_inversion) {
  Mesh mesh = sphere(2, NULL);
  ck_assert_int_eq(group_size(&mesh, planar_hyperbolic), 8);
  ck_assert_int_eq(group_size(&mesh, NULL), 8);
  ck_assert_int_eq(group_size(&mesh, general_flow), 2);
  mesh_free(&mesh);
}
END_TEST

START_TEST(a_turned_mesh_keeps_only_what_the_turn_leaves) {
  Mesh mesh = sphere(2, &(MeshRotation){{0.0, 1.0, 0.0}, 0.3}); /* about the vorticity axis: all four stay */
  ck_assert_int_eq(group_size(&mesh, NULL), 4);
  ck_assert_int_eq(group_size(&mesh, simple_shear), 4);
  mesh_free(&mesh);
  mesh = sphere(2, &(MeshRotation){{1.0, 2.0, 3.0}, 0.3}); /* the inversion stays in any case */
  ck_assert_int_eq(group_size(&mesh, NULL), 2);
  mesh_free(&mesh);
}
END_TEST

START_TEST(one_node_out_of_place_leaves_the_identity) {
  Mesh mesh = sphere(2, NULL);
  mesh.X[3 * 100 + 1] = nextafter(mesh.X[3 * 100 + 1], 2.0);
  ck_assert_int_eq(group_size(&mesh, NULL), 1);
  mesh_free(&mesh);
}
END_TEST

START_TEST(nodes_in_place_are_not_enough_when_an_element_is_not) {
  Mesh mesh = sphere(1, NULL);
  mesh.element[0][3] = mesh.n_nodes - 1; /* a foreign node in one element: its images miss it */
  ck_assert_int_eq(group_size(&mesh, NULL), 1);
  mesh_free(&mesh);
}
END_TEST

START_TEST(values_at_the_elements_leave_only_the_operations_that_keep_them) {
  Error error;
  Mesh mesh = sphere(1, NULL);
  double *above = malloc((size_t)mesh.n_elements * sizeof *above);
  for (int e = 0; e < mesh.n_elements; e++) {
    double z = 0;
    for (int k = 0; k < 3; k++) z += mesh.X[3 * mesh.element[e][k] + 2];
    above[e] = fabs(z) < 1e-12 ? 0.5 : z > 0;
  }
  Symmetry symmetry = group(&mesh, NULL);
  ck_assert_int_eq(symmetry_keep_field(&symmetry, &mesh, above, &error), STATUS_OK);
  ck_assert_int_eq(symmetry.n_operations, 4);
  for (int k = 0; k < symmetry.n_operations; k++) ck_assert_double_eq(symmetry.operation[k].sign[2], 1);
  for (int e = 0; e < mesh.n_elements; e++) /* an orbit has one value */
    ck_assert_double_eq(above[symmetry.elements.representative[symmetry.elements.orbit[e]]], above[e]);
  int lonely = 0; /* no operation but the identity leaves it in place */
  while (symmetry.elements.size[symmetry.elements.orbit[lonely]] < 4)
    ck_assert_int_lt(++lonely, mesh.n_elements);
  above[lonely] = 2;
  ck_assert_int_eq(symmetry_keep_field(&symmetry, &mesh, above, &error), STATUS_OK);
  ck_assert_int_eq(symmetry.n_operations, 1);
  ck_assert_int_eq(symmetry.elements.n, mesh.n_elements);
  symmetry_free(&symmetry);
  free(above);
  mesh_free(&mesh);
}
END_TEST

START_TEST(operations_take_nodes_onto_their_mirrored_places_and_are_their_own_inverse) {
  Mesh mesh = sphere(3, NULL);
  Symmetry symmetry = group(&mesh, NULL);
  for (int k = 0; k < symmetry.n_operations; k++) {
    const SymmetryOperation *operation = &symmetry.operation[k];
    for (int p = 0; p < mesh.n_nodes; p++) {
      int image = operation->node[p];
      for (int i = 0; i < 3; i++)
        ck_assert_double_eq(mesh.X[3 * image + i], operation->sign[i] * mesh.X[3 * p + i]);
      ck_assert_int_eq(operation->node[image], p);
    }
    for (int e = 0; e < mesh.n_elements; e++) ck_assert_int_eq(operation->element[operation->element[e]], e);
  }
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

START_TEST(elements_follow_their_nodes_and_turn_their_sense_under_reflections) {
  Mesh mesh = sphere(2, NULL);
  Symmetry symmetry = group(&mesh, NULL);
  for (int k = 0; k < symmetry.n_operations; k++) {
    const SymmetryOperation *operation = &symmetry.operation[k];
    bool reflection = operation->sign[0] * operation->sign[1] * operation->sign[2] < 0.0;
    for (int e = 0; e < mesh.n_elements; e++) {
      const int *image = mesh.element[operation->element[e]];
      const unsigned char *local = operation->local[e];
      for (int l = 0; l < 6; l++) ck_assert_int_eq(image[local[l]], operation->node[mesh.element[e][l]]);
      bool cyclic = (local[0] + 1) % 3 == local[1] && (local[1] + 1) % 3 == local[2];
      ck_assert(cyclic != reflection);
    }
  }
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

START_TEST(operations_form_a_group) {
  Mesh mesh = sphere(1, NULL);
  Symmetry symmetry = group(&mesh, simple_shear);
  for (int a = 0; a < symmetry.n_operations; a++)
    for (int b = 0; b < symmetry.n_operations; b++) {
      const SymmetryOperation *first = &symmetry.operation[a], *second = &symmetry.operation[b];
      int c = find_sign(&symmetry, first->sign[0] * second->sign[0], first->sign[1] * second->sign[1],
                        first->sign[2] * second->sign[2]);
      ck_assert_int_ge(c, 0);
      for (int p = 0; p < mesh.n_nodes; p++)
        ck_assert_int_eq(second->node[first->node[p]], symmetry.operation[c].node[p]);
      for (int e = 0; e < mesh.n_elements; e++)
        ck_assert_int_eq(second->element[first->element[e]], symmetry.operation[c].element[e]);
    }
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

/* Orbits must be a partition, each made of the images of its representative. */
static void assert_orbits(const Orbits *orbits, int count, int n_operations, const int *const image[]) {
  int members = 0;
  for (int orbit = 0; orbit < orbits->n; orbit++) {
    int representative = orbits->representative[orbit];
    members += orbits->size[orbit];
    ck_assert_int_eq(n_operations % orbits->size[orbit], 0); /* Lagrange */
    ck_assert_int_eq(orbits->orbit[representative], orbit);
    ck_assert_int_eq(orbits->operation[representative], 0);
    if (orbit > 0) ck_assert_int_gt(representative, orbits->representative[orbit - 1]);
    for (int k = 0; k < n_operations; k++) ck_assert_int_eq(orbits->orbit[image[k][representative]], orbit);
  }
  ck_assert_int_eq(members, count);
  for (int i = 0; i < count; i++)
    ck_assert_int_eq(image[orbits->operation[i]][orbits->representative[orbits->orbit[i]]], i);
}

/* Burnside: the number of orbits is the mean number of fixed points. */
static int burnside(int count, int n_operations, const int *const image[]) {
  int fixed = 0;
  for (int k = 0; k < n_operations; k++)
    for (int i = 0; i < count; i++) fixed += image[k][i] == i;
  ck_assert_int_eq(fixed % n_operations, 0);
  return fixed / n_operations;
}

START_TEST(orbits_partition_nodes_and_elements) {
  Mesh mesh = sphere(3, NULL);
  const double(*flows[3])[3] = {simple_shear, planar_hyperbolic, general_flow};
  for (int f = 0; f < 3; f++) {
    Symmetry symmetry = group(&mesh, flows[f]);
    const int *node_image[SYMMETRY_MAX], *element_image[SYMMETRY_MAX];
    for (int k = 0; k < symmetry.n_operations; k++) {
      node_image[k] = symmetry.operation[k].node;
      element_image[k] = symmetry.operation[k].element;
    }
    assert_orbits(&symmetry.nodes, mesh.n_nodes, symmetry.n_operations, node_image);
    assert_orbits(&symmetry.elements, mesh.n_elements, symmetry.n_operations, element_image);
    ck_assert_int_eq(symmetry.nodes.n, burnside(mesh.n_nodes, symmetry.n_operations, node_image));
    ck_assert_int_eq(symmetry.elements.n, burnside(mesh.n_elements, symmetry.n_operations, element_image));
    symmetry_free(&symmetry);
  }
  mesh_free(&mesh);
}
END_TEST

START_TEST(a_quarter_of_the_targets_is_left_in_shear_and_an_eighth_in_hyperbolic_flow) {
  /* Besides the free orbits: nodes in the mirror planes, counted here by their coordinates. */
  Mesh mesh = sphere(3, NULL);
  int in_plane = 0;
  for (int p = 0; p < mesh.n_nodes; p++) in_plane += mesh.X[3 * p + 1] == 0.0;
  Symmetry symmetry = group(&mesh, simple_shear);
  ck_assert_int_eq(symmetry.nodes.n, (mesh.n_nodes + in_plane + 2) / 4); /* 2: the poles of the half turn */
  ck_assert_double_lt(symmetry.nodes.n, 0.265 * mesh.n_nodes);
  ck_assert_double_lt(symmetry.elements.n, 0.265 * mesh.n_elements);
  symmetry_free(&symmetry);
  symmetry = group(&mesh, planar_hyperbolic); /* three planes, three axes */
  ck_assert_int_eq(symmetry.nodes.n, (mesh.n_nodes + 3 * in_plane + 3 * 2) / 8);
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

START_TEST(a_symmetric_field_is_restored_from_its_representatives) {
  Mesh mesh = sphere(2, NULL);
  Symmetry symmetry = group(&mesh, simple_shear);
  size_t size = 3 * (size_t)mesh.n_nodes;
  double *field = calloc(size, sizeof *field), *spread = malloc(size * sizeof *spread);
  ck_assert(field && spread);
  for (int p = 0; p < mesh.n_nodes; p++) { /* v = G x and something even less linear that commutes with S */
    const double *X = &mesh.X[3 * p];
    field[3 * p] = X[2] * (1.0 + X[1] * X[1]);
    field[3 * p + 1] = X[1] * X[0] * X[2];
    field[3 * p + 2] = X[0] * X[0] * X[2];
  }
  for (size_t k = 0; k < size; k++) spread[k] = NAN;
  for (int orbit = 0; orbit < symmetry.nodes.n; orbit++) {
    int p = symmetry.nodes.representative[orbit];
    memcpy(&spread[3 * p], &field[3 * p], 3 * sizeof *field);
  }
  symmetry_spread(&symmetry, spread);
  for (size_t k = 0; k < size; k++) ck_assert_double_eq(spread[k], field[k]);
  free(field);
  free(spread);
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

START_TEST(any_field_becomes_symmetric) {
  uint64_t state = 5;
  Mesh mesh = sphere(2, NULL);
  Symmetry symmetry = group(&mesh, planar_hyperbolic);
  double *field = malloc(3 * (size_t)mesh.n_nodes * sizeof *field);
  ck_assert_ptr_nonnull(field);
  random_fill(&state, 3 * mesh.n_nodes, field);
  symmetry_spread(&symmetry, field);
  for (int k = 0; k < symmetry.n_operations; k++)
    for (int p = 0; p < mesh.n_nodes; p++)
      for (int i = 0; i < 3; i++)
        ck_assert_double_eq(field[3 * symmetry.operation[k].node[p] + i],
                            symmetry.operation[k].sign[i] * field[3 * p + i]);
  free(field);
  symmetry_free(&symmetry);
  mesh_free(&mesh);
}
END_TEST

START_TEST(any_failing_allocation_is_reported_and_leaves_nothing) {
  Mesh mesh = sphere(0, NULL);
  int failures = 0;
  for (long n = 1; n < 100; n++) {
    Symmetry symmetry;
    Error error;
    array_fail_nth(n);
    Status status = symmetry_find(&symmetry, &mesh, mesh.X, simple_shear, &error);
    array_fail_nth(0);
    if (status == STATUS_OK) {
      symmetry_free(&symmetry);
      break;
    }
    failures++;
    ck_assert_int_eq(status, STATUS_MEMORY);
    ck_assert_int_eq(symmetry.n_operations, 0);
  }
  ck_assert_int_eq(failures,
                   1 + 3 * 4 + 2 * 4); /* places; three for each operation; four for each set of orbits */
  mesh_free(&mesh);
}
END_TEST

int main(void) {
  return suite_run(
      "symmetry",
      (SuiteTests){simple_shear_keeps_identity_inversion_mirror_and_half_turn_about_the_vorticity_axis,
                   planar_hyperbolic_flow_and_no_flow_keep_all_eight_and_any_linear_flow_the_inversion,
                   a_turned_mesh_keeps_only_what_the_turn_leaves, one_node_out_of_place_leaves_the_identity,
                   nodes_in_place_are_not_enough_when_an_element_is_not,
                   values_at_the_elements_leave_only_the_operations_that_keep_them,
                   operations_take_nodes_onto_their_mirrored_places_and_are_their_own_inverse,
                   elements_follow_their_nodes_and_turn_their_sense_under_reflections,
                   operations_form_a_group, orbits_partition_nodes_and_elements,
                   a_quarter_of_the_targets_is_left_in_shear_and_an_eighth_in_hyperbolic_flow,
                   a_symmetric_field_is_restored_from_its_representatives, any_field_becomes_symmetric,
                   any_failing_allocation_is_reported_and_leaves_nothing, NULL});
}
