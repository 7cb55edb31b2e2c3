/* Points held around nodes against those found anew. */
#include "fluid/singular.h"

#include "base/array.h"
#include "mesh/mesh.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static const PolarScheme SCHEME = {POLAR_TANGENT, 2, 4, 8};

typedef struct {
  Mesh mesh;
  SingularRule *rule;
  int *node;
  double *x, *q; /* [n_nodes][3] */
  HeldPolar held;
} Around;

/* All nodes of an ellipsoid with long triangles, whose points are settled. */
static void around_open(Around *around) {
  static const double axes[3] = {3, 1, 0.3};
  Error error;
  Mesh *mesh = &around->mesh;
  ck_assert_int_eq(mesh_sphere(mesh, 1, NULL, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&around->node, mesh->n_nodes, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&around->x, 3 * mesh->n_nodes, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&around->q, 3 * mesh->n_nodes, &error), STATUS_OK);
  for (int p = 0; p < mesh->n_nodes; p++) around->node[p] = p;
  for (int i = 0; i < 3 * mesh->n_nodes; i++) {
    around->x[i] = axes[i % 3] * mesh->X[i];
    around->q[i] = sin(i + 1.0);
  }
  ck_assert_int_eq(singular_new(&around->rule, &SCHEME, &error), STATUS_OK);
  ck_assert_int_eq(held_polar_new(&around->held, around->rule, mesh, around->node, mesh->n_nodes, &error),
                   STATUS_OK);
  for (int p = 0; p < mesh->n_nodes; p++) held_polar_settle(&around->held, around->x, p);
}

static void around_close(Around *around) {
  held_polar_free(&around->held);
  singular_free(around->rule);
  mesh_free(&around->mesh);
  array_free(around->node);
  array_free(around->x);
  array_free(around->q);
}

static int sum_held(const Around *around, const double *x, int p, double u[3]) {
  Gather gather;
  gather_start(&gather, x + 3 * p);
  const int n = held_polar_gather(&around->held, x, around->q, p, &gather);
  gather_flush(&gather);
  memcpy(u, gather.u, sizeof gather.u);
  return n;
}

static int sum_anew(const Around *around, const double *x, int p, double u[3]) {
  Gather gather;
  gather_start(&gather, x + 3 * p);
  const int n = singular_gather(around->rule, &around->mesh, x, around->q, p, &gather);
  gather_flush(&gather);
  memcpy(u, gather.u, sizeof gather.u);
  return n;
}

START_TEST(held_points_are_those_found_where_they_were_settled) {
  Around around;
  around_open(&around);
  for (int p = 0; p < around.mesh.n_nodes; p++) {
    double held[3], anew[3];
    ck_assert_int_eq(sum_held(&around, around.x, p, held), sum_anew(&around, around.x, p, anew));
    for (int c = 0; c < 3; c++) ck_assert_double_eq(held[c], anew[c]);
  }
  around_close(&around);
}
END_TEST

START_TEST(held_points_serve_positions_near_by) {
  Around around;
  around_open(&around);
  double largest = 0, worst = 0;
  for (int i = 0; i < 3 * around.mesh.n_nodes; i++) around.x[i] *= i % 3 == 0 ? 1.02 : 0.99;
  for (int p = 0; p < around.mesh.n_nodes; p++) {
    double held[3], anew[3];
    ck_assert_int_gt(sum_held(&around, around.x, p, held), 0);
    sum_anew(&around, around.x, p, anew);
    for (int c = 0; c < 3; c++) {
      largest = fmax(largest, fabs(anew[c]));
      worst = fmax(worst, fabs(held[c] - anew[c]));
    }
  }
  /* Both are quadratures of the same integral, whose error is 1e-2 on triangles as long (coarse_layer.h). */
  ck_assert_double_lt(worst, 1e-2 * largest);
  ck_assert_double_gt(worst, 0);
  around_close(&around);
}
END_TEST

START_TEST(an_element_squashed_to_a_line_is_told) {
  Around around;
  double u[3];
  around_open(&around);
  for (int p = 0; p < around.mesh.n_nodes; p++) around.x[3 * p + 1] = around.x[3 * p + 2] = 0;
  ck_assert_int_eq(sum_held(&around, around.x, 0, u), -1);
  held_polar_settle(&around.held, around.x, 0);
  ck_assert_int_eq(sum_held(&around, around.x, 0, u), -1);
  around_close(&around);
}
END_TEST

int main(void) {
  return suite_run("singular", (SuiteTests){held_points_are_those_found_where_they_were_settled,
                                            held_points_serve_positions_near_by,
                                            an_element_squashed_to_a_line_is_told, NULL});
}
