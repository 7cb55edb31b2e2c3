/* Quartic interpolation on four elements against what defines it. */
#include "mesh/p4.h"

#include "mesh/mesh.h"
#include "mesh/p2.h"
#include "suite.h"
#include <math.h>
#include <stdbool.h>

/* Corners of the children in the parent's (xi, eta): the halves of a triangle, the last one upside down. */
static const double CORNER[P4_CHILDREN][3][2] = {{{0, 0}, {0.5, 0}, {0, 0.5}},
                                                 {{0.5, 0}, {1, 0}, {0.5, 0.5}},
                                                 {{0, 0.5}, {0.5, 0.5}, {0, 1}},
                                                 {{0.5, 0}, {0.5, 0.5}, {0, 0.5}}};

static void in_parent(int child, double xi, double eta, double point[2]) {
  for (int c = 0; c < 2; c++)
    point[c] = (1 - xi - eta) * CORNER[child][0][c] + xi * CORNER[child][1][c] + eta * CORNER[child][2][c];
}

START_TEST(gradients_of_polynomials_of_degree_four_are_exact) {
  P4Place place[P4_NODES];
  p4_places(place);
  for (int i = 0; i <= 4; i++)
    for (int j = 0; i + j <= 4; j++) {
      double at_node[P4_NODES];
      for (int m = 0; m < P4_NODES; m++) {
        const double *local = p2_node[place[m].local];
        double point[2];
        in_parent(place[m].child, local[0], local[1], point);
        at_node[m] = pow(point[0], i) * pow(point[1], j);
      }
      for (int child = 0; child < P4_CHILDREN; child++) {
        const double xi = 0.37, eta = 0.21;
        double dN[P4_NODES][2], point[2], slope[2] = {0, 0};
        p4_gradients(child, xi, eta, dN);
        for (int m = 0; m < P4_NODES; m++)
          for (int alpha = 0; alpha < 2; alpha++) slope[alpha] += dN[m][alpha] * at_node[m];
        in_parent(child, xi, eta, point);
        const double along[2] = {i ? i * pow(point[0], i - 1) * pow(point[1], j) : 0,
                                 j ? j * pow(point[0], i) * pow(point[1], j - 1) : 0};
        for (int alpha = 0; alpha < 2; alpha++) {
          double exact = 0;
          for (int c = 0; c < 2; c++) exact += along[c] * (CORNER[child][1 + alpha][c] - CORNER[child][0][c]);
          ck_assert_double_eq_tol(slope[alpha], exact, 1e-13); /* round-off of 15 terms up to 16 */
        }
      }
    }
}
END_TEST

START_TEST(nodes_of_a_group_of_a_mesh_are_all_different_and_those_of_its_elements) {
  Mesh mesh;
  Error error;
  P4Place place[P4_NODES];
  p4_places(place);
  ck_assert_int_eq(mesh_sphere(&mesh, 2, NULL, &error), STATUS_OK);
  for (int group = 0; group < mesh.n_elements / P4_CHILDREN; group++) {
    int node[P4_NODES];
    for (int m = 0; m < P4_NODES; m++) {
      node[m] = mesh.element[P4_CHILDREN * group + place[m].child][place[m].local];
      for (int before = 0; before < m; before++) ck_assert_int_ne(node[m], node[before]);
    }
    for (int child = 0; child < P4_CHILDREN; child++)
      for (int local = 0; local < 6; local++) {
        bool is_there = false;
        for (int m = 0; m < P4_NODES; m++)
          is_there = is_there || node[m] == mesh.element[P4_CHILDREN * group + child][local];
        ck_assert(is_there);
      }
  }
  mesh_free(&mesh);
}
END_TEST

int main(void) {
  return suite_run("p4", (SuiteTests){gradients_of_polynomials_of_degree_four_are_exact,
                                      nodes_of_a_group_of_a_mesh_are_all_different_and_those_of_its_elements,
                                      NULL});
}
