/* Pattern, look-up and product of sparse matrices against the dense way. */
#include "base/array.h"
#include "mass_matrix.h"
#include "random.h"
#include "suite.h"
#include <stdbool.h>

START_TEST(pattern_joins_the_nodes_that_share_an_element) {
  /* Two triangles that share the edge 1-3 and one apart from them; node 5 is in none. */
  static const int nodes[] = {0, 1, 3, 1, 2, 3, 4, 6, 7};
  static const bool joined[8][8] = {
      {1, 1, 0, 1, 0, 0, 0, 0}, {1, 1, 1, 1, 0, 0, 0, 0}, {0, 1, 1, 1, 0, 0, 0, 0}, {1, 1, 1, 1, 0, 0, 0, 0},
      {0, 0, 0, 0, 1, 0, 1, 1}, {0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 1, 1}, {0, 0, 0, 0, 1, 0, 1, 1}};
  SparseMatrix matrix;
  Error error;
  ck_assert_int_eq(sparse_from_elements(&matrix, 8, 3, 3, nodes, &error), STATUS_OK);
  int entry = 0;
  for (int i = 0; i < 8; i++) {
    ck_assert_int_eq(matrix.row_start[i], entry);
    for (int j = 0; j < 8; j++) {
      ck_assert_int_eq(sparse_index(&matrix, i, j), joined[i][j] ? entry : -1);
      if (joined[i][j]) {
        ck_assert_int_eq(matrix.column[entry], j);
        ck_assert(matrix.value[entry] == 0.0);
        entry++;
      }
    }
  }
  ck_assert_int_eq(matrix.row_start[8], entry);
  sparse_free(&matrix);
}
END_TEST

START_TEST(pattern_of_a_closed_p2_mesh_has_19_16_and_9_entries_in_a_row) {
  SparseMatrix matrix = mass_matrix(2, (const double[3]){1.0, 1.0, 1.0});
  int rows[20] = {0};
  for (int i = 0; i < matrix.n; i++) {
    int size = matrix.row_start[i + 1] - matrix.row_start[i];
    ck_assert(size == 9 || size == 16 || size == 19);
    rows[size]++;
  }
  ck_assert_int_eq(rows[16], 12);  /* corners of the icosahedron: 1 + 3 * 5 nodes around */
  ck_assert_int_eq(rows[19], 150); /* the other corners: 1 + 3 * 6 */
  ck_assert_int_eq(rows[9], 480);  /* mid-edge nodes: two elements that share three nodes */
  sparse_free(&matrix);
}
END_TEST

START_TEST(product_with_three_columns_is_the_dense_one) {
  const uint64_t seed = 7;
  uint64_t state = seed;
  SparseMatrix matrix = mass_matrix(0, (const double[3]){2.0, 1.0, 0.5});
  enum { N = 42 };
  ck_assert_int_eq(matrix.n, N);
  double x[3 * N], y[3 * N];
  random_fill(&state, matrix.row_start[N], matrix.value);
  random_fill(&state, 3 * N, x);
  sparse_multiply3(&matrix, x, y);
  for (int i = 0; i < N; i++)
    for (int c = 0; c < 3; c++) {
      double expected = 0.0;
      for (int j = 0; j < N; j++) {
        int k = sparse_index(&matrix, i, j);
        if (k >= 0) expected += matrix.value[k] * x[3 * j + c];
      }
      ck_assert_double_eq(y[3 * i + c], expected); /* the same terms in the same order */
    }
  sparse_free(&matrix);
}
END_TEST

START_TEST(mass_matrix_is_symmetric_and_sums_to_the_area) {
  SparseMatrix matrix = mass_matrix(3, (const double[3]){1.0, 1.0, 1.0});
  double sum = 0.0;
  for (int i = 0; i < matrix.n; i++)
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; k++) {
      sum += matrix.value[k];
      double mirrored = matrix.value[sparse_index(&matrix, matrix.column[k], i)];
      ck_assert_double_eq_tol(matrix.value[k], mirrored, 1e-17); /* round-off of entries below 1e-2 */
    }
  ck_assert_double_eq_tol(sum, 4.0 * acos(-1.0), 1e-4); /* P2 geometry at 1280 elements */
  sparse_free(&matrix);
}
END_TEST

START_TEST(any_failing_allocation_is_reported_and_leaves_nothing) {
  static const int nodes[] = {0, 1, 2, 1, 2, 3};
  int failures = 0;
  for (long n = 1; n < 100; n++) {
    SparseMatrix matrix;
    Error error;
    array_fail_nth(n);
    Status status = sparse_from_elements(&matrix, 4, 2, 3, nodes, &error);
    array_fail_nth(0);
    if (status == STATUS_OK) {
      sparse_free(&matrix);
      break;
    }
    failures++;
    ck_assert_int_eq(status, STATUS_MEMORY);
    ck_assert_ptr_null(matrix.row_start);
  }
  ck_assert_int_eq(failures, 7); /* four work arrays, three of the matrix */
}
END_TEST

int main(void) {
  return suite_run("sparse", (SuiteTests){pattern_joins_the_nodes_that_share_an_element,
                                          pattern_of_a_closed_p2_mesh_has_19_16_and_9_entries_in_a_row,
                                          product_with_three_columns_is_the_dense_one,
                                          mass_matrix_is_symmetric_and_sums_to_the_area,
                                          any_failing_allocation_is_reported_and_leaves_nothing, NULL});
}
