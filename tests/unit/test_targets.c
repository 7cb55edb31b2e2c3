/* The nodes at which velocities are summed: all of them or one of each orbit, and the way back to all. */
#include "fluid/targets.h"

#include "base/array.h"
#include "suite.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

static const double SHEAR[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}};

typedef struct {
  Mesh mesh;
  Symmetry symmetry;
  Targets targets;
} Place;

static void place_open(Place *place, int subdivisions, bool is_symmetric) {
  Error error;
  ck_assert_int_eq(mesh_sphere(&place->mesh, subdivisions, NULL, &error), STATUS_OK);
  ck_assert_int_eq(symmetry_find(&place->symmetry, &place->mesh, place->mesh.X, SHEAR, &error), STATUS_OK);
  ck_assert_int_eq(targets_new(&place->targets, &place->mesh, &error), STATUS_OK);
  if (is_symmetric) targets_use_symmetry(&place->targets, &place->symmetry);
}

static void place_close(Place *place) {
  targets_free(&place->targets);
  symmetry_free(&place->symmetry);
  mesh_free(&place->mesh);
}

START_TEST(without_symmetry_every_node_is_a_target_once) {
  Place place;
  place_open(&place, 2, false);
  int n = place.mesh.n_nodes;
  ck_assert_int_eq(place.targets.n, n);
  int *met = calloc((size_t)n, sizeof *met);
  for (int i = 0; i < n; i++) met[place.targets.node[i]]++;
  for (int p = 0; p < n; p++) ck_assert_int_eq(met[p], 1);
  free(met);
  place_close(&place);
}
END_TEST

START_TEST(with_symmetry_every_orbit_has_one_target) {
  Place place;
  place_open(&place, 2, true);
  const Orbits *nodes = &place.symmetry.nodes;
  ck_assert_int_eq(place.targets.n, nodes->n);
  ck_assert_int_lt(3 * nodes->n, place.mesh.n_nodes); /* four operations, and nodes on the mirror */
  int *met = calloc((size_t)nodes->n, sizeof *met);
  for (int i = 0; i < nodes->n; i++) met[nodes->orbit[place.targets.node[i]]]++;
  for (int o = 0; o < nodes->n; o++) ck_assert_int_eq(met[o], 1);
  free(met);
  place_close(&place);
}
END_TEST

START_TEST(targets_next_to_each_other_in_the_order_are_next_to_each_other_on_the_surface) {
  Place place;
  place_open(&place, 2, true);
  double sum = 0, edge = mesh_edge_length(&place.mesh, place.mesh.X);
  for (int i = 1; i < place.targets.n; i++) {
    const double *a = place.mesh.X + 3 * place.targets.node[i - 1],
                 *b = place.mesh.X + 3 * place.targets.node[i];
    sum += sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
  }
  /* in the order of their numbers the mean is 3.6 edges; at random on a sphere it would be 4/3 radii, 4.4 */
  ck_assert_double_lt(sum / (place.targets.n - 1), 2 * edge);
  place_close(&place);
}
END_TEST

/* w(x) = (z + x^2 z, y^3, x - y^2 z), which has the four symmetries of the shear: w(S x) = S w(x). */
static void symmetric_field(int n, const double *x, double *w) {
  for (int p = 0; p < n; p++, x += 3, w += 3) {
    w[0] = x[2] + x[0] * x[0] * x[2];
    w[1] = x[1] * x[1] * x[1];
    w[2] = x[0] - x[1] * x[1] * x[2];
  }
}

START_TEST(a_symmetric_field_is_had_back_from_its_values_at_the_targets) {
  for (int is_symmetric = 0; is_symmetric < 2; is_symmetric++) {
    Place place;
    Error error;
    double *whole, *u;
    place_open(&place, 2, is_symmetric);
    int n = place.mesh.n_nodes;
    ck_assert_int_eq(ARRAY_NEW(&whole, 3 * n, &error), STATUS_OK);
    ck_assert_int_eq(ARRAY_NEW(&u, 3 * n, &error), STATUS_OK);
    symmetric_field(n, place.mesh.X, whole);
    for (int i = 0; i < 3 * n; i++) u[i] = NAN;
    for (int i = 0; i < place.targets.n; i++) {
      int p = place.targets.node[i];
      memcpy(u + 3 * p, whole + 3 * p, 3 * sizeof *u);
    }
    targets_spread(&place.targets, u);
    for (int i = 0; i < 3 * n; i++) ck_assert_double_eq(u[i], whole[i]);
    array_free(whole);
    array_free(u);
    place_close(&place);
  }
}
END_TEST

START_TEST(the_first_value_that_is_not_finite_is_named_with_its_node) {
  double values[] = {0, 1, 2, 3, NAN, 5, INFINITY, 0, 0};
  Error error;
  ck_assert_int_eq(targets_check_finite("load", 1, values, &error), STATUS_OK);
  ck_assert_int_eq(targets_check_finite("load", 3, values, &error), STATUS_REJECT);
  ck_assert_ptr_nonnull(strstr(error.text, "load of node 1 is"));
  values[4] = 0;
  ck_assert_int_eq(targets_check_finite("position", 3, values, &error), STATUS_REJECT);
  ck_assert_ptr_nonnull(strstr(error.text, "position of node 2 is inf"));
}
END_TEST

START_TEST(running_out_of_memory_leaves_targets_that_can_be_freed) {
  Mesh mesh;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, 0, NULL, &error), STATUS_OK);
  Status status = STATUS_MEMORY;
  int nth = 1;
  for (; status == STATUS_MEMORY && nth < 10; nth++) {
    Targets targets;
    array_fail_nth(nth);
    status = targets_new(&targets, &mesh, &error);
    targets_free(&targets);
  }
  array_fail_nth(0);
  ck_assert_int_eq(status, STATUS_OK);
  ck_assert_int_eq(nth, 5); /* three arrays, then success */
  mesh_free(&mesh);
}
END_TEST

int main(void) {
  return suite_run("targets",
                   (SuiteTests){without_symmetry_every_node_is_a_target_once,
                                with_symmetry_every_orbit_has_one_target,
                                targets_next_to_each_other_in_the_order_are_next_to_each_other_on_the_surface,
                                a_symmetric_field_is_had_back_from_its_values_at_the_targets,
                                the_first_value_that_is_not_finite_is_named_with_its_node,
                                running_out_of_memory_leaves_targets_that_can_be_freed, NULL});
}
