/* UMFPACK against known solutions and against conjugate gradients. */
#include "base/array.h"
#include "linalg/direct.h"
#include "linalg/pcg.h"
#include "mass_matrix.h"
#include "random.h"
#include "suite.h"
#include <string.h>

#ifdef CAPSELLA_UMFPACK

START_TEST(conjugate_gradients_agree_with_umfpack_on_a_stretched_sphere) {
  uint64_t state = 11;
  SparseMatrix matrix = mass_matrix(3, (const double[3]){2.0, 1.0, 0.5});
  size_t size = 3 * (size_t)matrix.n;
  double *b = calloc(size, sizeof *b), *direct = calloc(size, sizeof *b), *iterated = calloc(size, sizeof *b);
  ck_assert(b && direct && iterated);
  random_fill(&state, (int)size, b);
  DirectSolver *solver;
  PcgWork work;
  Error error;
  int iterations;
  ck_assert_int_eq(direct_new(&solver, &matrix, &error), STATUS_OK);
  ck_assert_int_eq(direct_factor(solver, &error), STATUS_OK);
  ck_assert_int_eq(direct_solve3(solver, b, direct, &error), STATUS_OK);
  ck_assert_int_eq(pcg_work_new(&work, matrix.n, &error), STATUS_OK);
  ck_assert_int_eq(pcg_solve3(&matrix, b, iterated, 1e-13, 100, &work, &iterations, &error), STATUS_OK);
  double largest = 0.0;
  for (size_t k = 0; k < size; k++) largest = fmax(largest, fabs(direct[k]));
  for (size_t k = 0; k < size; k++) /* tolerance times the condition number of the scaled matrix */
    ck_assert_double_eq_tol(iterated[k] / largest, direct[k] / largest, 1e-12);
  pcg_work_free(&work);
  direct_free(solver);
  sparse_free(&matrix);
  free(b);
  free(direct);
  free(iterated);
}
END_TEST

enum { N = 42 }; /* nodes of the icosahedron with its mid-edge nodes */

START_TEST(unsymmetric_values_are_solved_as_they_stand_and_refactored) {
  uint64_t state = 12;
  SparseMatrix matrix = mass_matrix(0, (const double[3]){1.0, 1.0, 1.0});
  ck_assert_int_eq(matrix.n, N);
  double exact[3 * N], b[3 * N], x[3 * N];
  DirectSolver *solver;
  Error error;
  ck_assert_int_eq(direct_new(&solver, &matrix, &error), STATUS_OK);
  for (int trial = 0; trial < 5; trial++) { /* one analysis, new values each time */
    random_fill(&state, matrix.row_start[N], matrix.value);
    for (int i = 0; i < N; i++) matrix.value[sparse_index(&matrix, i, i)] += 10.0; /* well conditioned */
    random_fill(&state, 3 * N, exact);
    sparse_multiply3(&matrix, exact, b);
    ck_assert_int_eq(direct_factor(solver, &error), STATUS_OK);
    ck_assert_int_eq(direct_solve3(solver, b, x, &error), STATUS_OK);
    for (int k = 0; k < 3 * N; k++) ck_assert_double_eq_tol(x[k], exact[k], 1e-14);
  }
  direct_free(solver);
  sparse_free(&matrix);
}
END_TEST

START_TEST(a_singular_matrix_is_rejected_and_the_next_one_solved) {
  SparseMatrix matrix = mass_matrix(0, (const double[3]){1.0, 1.0, 1.0});
  double b[3 * N] = {1.0}, x[3 * N], kept[N];
  int first = matrix.row_start[5], size = matrix.row_start[6] - first;
  DirectSolver *solver;
  Error error;
  ck_assert_int_eq(direct_new(&solver, &matrix, &error), STATUS_OK);
  memcpy(kept, &matrix.value[first], (size_t)size * sizeof *kept);
  memset(&matrix.value[first], 0, (size_t)size * sizeof *kept); /* a row of zeros */
  ck_assert_int_eq(direct_factor(solver, &error), STATUS_REJECT);
  ck_assert_ptr_nonnull(strstr(error.text, "singular"));
  ck_assert_int_eq(direct_solve3(solver, b, x, &error), STATUS_FAILED); /* no factors to use */
  memcpy(&matrix.value[first], kept, (size_t)size * sizeof *kept);
  ck_assert_int_eq(direct_factor(solver, &error), STATUS_OK);
  ck_assert_int_eq(direct_solve3(solver, b, x, &error), STATUS_OK);
  direct_free(solver);
  sparse_free(&matrix);
}
END_TEST

START_TEST(any_failing_allocation_is_reported_and_leaves_nothing) {
  SparseMatrix matrix = mass_matrix(0, (const double[3]){1.0, 1.0, 1.0});
  for (long n = 1; n <= 3; n++) {
    DirectSolver *solver;
    Error error;
    array_fail_nth(n);
    ck_assert_int_eq(direct_new(&solver, &matrix, &error), STATUS_MEMORY);
    array_fail_nth(0);
    ck_assert_ptr_null(solver);
  }
  sparse_free(&matrix);
}
END_TEST

int main(void) {
  return suite_run("direct", (SuiteTests){conjugate_gradients_agree_with_umfpack_on_a_stretched_sphere,
                                          unsymmetric_values_are_solved_as_they_stand_and_refactored,
                                          a_singular_matrix_is_rejected_and_the_next_one_solved,
                                          any_failing_allocation_is_reported_and_leaves_nothing, NULL});
}

#else

START_TEST(a_build_without_umfpack_says_what_to_do) {
  SparseMatrix matrix = {0};
  DirectSolver *solver;
  Error error;
  ck_assert_int_eq(direct_new(&solver, &matrix, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "mass_solver: pcg"));
  ck_assert_ptr_null(solver);
}
END_TEST

int main(void) {
  return suite_run("direct", (SuiteTests){a_build_without_umfpack_says_what_to_do, NULL});
}

#endif
