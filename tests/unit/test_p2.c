/* The P2 shape functions against what defines them. */
#include "mesh/p2.h"

#include "suite.h"

START_TEST(shape_functions_are_one_at_their_node_and_zero_at_the_others) {
  for (int p = 0; p < 6; p++) {
    double N[6];
    p2_values(p2_node[p][0], p2_node[p][1], N);
    for (int q = 0; q < 6; q++) ck_assert_double_eq(N[q], p == q ? 1.0 : 0.0);
  }
}
END_TEST

START_TEST(shape_functions_sum_to_one_and_their_gradients_to_zero) {
  for (double xi = -0.2; xi < 1.2; xi += 0.17)
    for (double eta = -0.2; eta < 1.2; eta += 0.13) {
      double N[6], dN[6][2], sum[3] = {0.0, 0.0, 0.0};
      p2_values(xi, eta, N);
      p2_gradients(xi, eta, dN);
      for (int p = 0; p < 6; p++) {
        sum[0] += N[p];
        sum[1] += dN[p][0];
        sum[2] += dN[p][1];
      }
      ck_assert_double_eq_tol(sum[0], 1.0, 1e-14); /* round-off of six terms of order 1 */
      ck_assert_double_eq_tol(sum[1], 0.0, 1e-14);
      ck_assert_double_eq_tol(sum[2], 0.0, 1e-14);
    }
}
END_TEST

START_TEST(quadratic_fields_and_their_gradients_are_interpolated_exactly) {
  /* f = xi^i eta^j for all i + j <= 2 */
  for (int i = 0; i <= 2; i++)
    for (int j = 0; i + j <= 2; j++) {
      double at_node[6];
      for (int p = 0; p < 6; p++) {
        at_node[p] = 1.0;
        for (int k = 0; k < i; k++) at_node[p] *= p2_node[p][0];
        for (int k = 0; k < j; k++) at_node[p] *= p2_node[p][1];
      }
      const double xi = 0.37, eta = 0.21;
      const double power_xi[3] = {1.0, xi, xi * xi}, power_eta[3] = {1.0, eta, eta * eta};
      double N[6], dN[6][2], value = 0.0, d_xi = 0.0, d_eta = 0.0;
      p2_values(xi, eta, N);
      p2_gradients(xi, eta, dN);
      for (int p = 0; p < 6; p++) {
        value += N[p] * at_node[p];
        d_xi += dN[p][0] * at_node[p];
        d_eta += dN[p][1] * at_node[p];
      }
      ck_assert_double_eq_tol(value, power_xi[i] * power_eta[j], 1e-15);
      ck_assert_double_eq_tol(d_xi, i ? i * power_xi[i - 1] * power_eta[j] : 0.0, 1e-15);
      ck_assert_double_eq_tol(d_eta, j ? j * power_xi[i] * power_eta[j - 1] : 0.0, 1e-15);
    }
}
END_TEST

START_TEST(table_holds_the_rule_and_the_functions_at_its_points) {
  const TriangleRule *rule = triangle_rule(7);
  const P2Table table = p2_table(rule);
  ck_assert_int_eq(table.n, 7);
  for (int g = 0; g < rule->n; g++) {
    double N[6], dN[6][2];
    p2_values(rule->point[g][0], rule->point[g][1], N);
    p2_gradients(rule->point[g][0], rule->point[g][1], dN);
    ck_assert_double_eq(table.weight[g], rule->weight[g]);
    ck_assert_mem_eq(table.N[g], N, sizeof N);
    ck_assert_mem_eq(table.dN[g], dN, sizeof dN);
  }
}
END_TEST

START_TEST(element_is_placed_and_its_tangents_differentiate_the_position) {
  /* Six nodes on a quadratic surface, listed out of order in x. */
  static const int node[6] = {5, 0, 3, 1, 4, 2};
  double x[18];
  for (int p = 0; p < 6; p++) {
    double xi = p2_node[p][0], eta = p2_node[p][1];
    double *position = &x[3 * node[p]];
    position[0] = 1.0 + xi - 0.3 * eta;
    position[1] = 2.0 * eta + xi * eta;
    position[2] = xi * xi - eta;
  }
  static const double point[1][2] = {{0.15, 0.45}}, weight[1] = {0.5};
  const double xi = point[0][0], eta = point[0][1];
  const P2Table table = p2_table(&(TriangleRule){.n = 1, .point = point, .weight = weight});
  double position[3], a1[3], a2[3];
  p2_interpolate(x, node, table.N[0], position);
  p2_tangents(x, node, table.dN[0], a1, a2);
  const double expected[3][3] = {{1.0 + xi - 0.3 * eta, 2.0 * eta + xi * eta, xi * xi - eta},
                                 {1.0, eta, 2.0 * xi},
                                 {-0.3, 2.0 + xi, -1.0}};
  for (int i = 0; i < 3; i++) { /* exact but for round-off, the surface being quadratic */
    ck_assert_double_eq_tol(position[i], expected[0][i], 1e-15);
    ck_assert_double_eq_tol(a1[i], expected[1][i], 1e-14);
    ck_assert_double_eq_tol(a2[i], expected[2][i], 1e-14);
  }
}
END_TEST

int main(void) {
  return suite_run("p2", (SuiteTests){shape_functions_are_one_at_their_node_and_zero_at_the_others,
                                      shape_functions_sum_to_one_and_their_gradients_to_zero,
                                      quadratic_fields_and_their_gradients_are_interpolated_exactly,
                                      table_holds_the_rule_and_the_functions_at_its_points,
                                      element_is_placed_and_its_tangents_differentiate_the_position, NULL});
}
