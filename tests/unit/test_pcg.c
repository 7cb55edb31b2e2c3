/* Conjugate gradients on P2 mass matrices with known solutions, and what they refuse. */
#include "base/array.h"
#include "linalg/pcg.h"
#include "mass_matrix.h"
#include "random.h"
#include "suite.h"
#include <string.h>

static const double stretched[3] = {2.0, 1.0, 0.5};

/* A mass matrix with a random solution, its right-hand side and room to work. */
typedef struct {
  SparseMatrix matrix;
  PcgWork work;
  double *exact, *b, *x; /* [n][3] */
  int size;              /* 3 n */
} Problem;

static Problem problem_new(int subdivisions, uint64_t seed) {
  Problem problem = {.matrix = mass_matrix(subdivisions, stretched)};
  Error error;
  problem.size = 3 * problem.matrix.n;
  size_t bytes = (size_t)problem.size * sizeof(double);
  problem.exact = malloc(bytes);
  problem.b = malloc(bytes);
  problem.x = calloc(1, bytes);
  ck_assert(problem.exact && problem.b && problem.x);
  random_fill(&seed, problem.size, problem.exact);
  sparse_multiply3(&problem.matrix, problem.exact, problem.b);
  ck_assert_int_eq(pcg_work_new(&problem.work, problem.matrix.n, &error), STATUS_OK);
  return problem;
}

static void problem_free(Problem *problem) {
  sparse_free(&problem->matrix);
  pcg_work_free(&problem->work);
  free(problem->exact);
  free(problem->b);
  free(problem->x);
}

static int problem_solve(Problem *problem, double tolerance) {
  Error error;
  int iterations;
  ck_assert_int_eq(pcg_solve3(&problem->matrix, problem->b, problem->x, tolerance, 100, &problem->work,
                              &iterations, &error),
                   STATUS_OK);
  return iterations;
}

static double problem_error(const Problem *problem) {
  double worst = 0.0;
  for (int k = 0; k < problem->size; k++) worst = fmax(worst, fabs(problem->x[k] - problem->exact[k]));
  return worst;
}

START_TEST(known_solution_is_found_to_the_tolerance) {
  Problem problem = problem_new(3, 1);
  static const double tolerance[] = {1e-4, 1e-8, 1e-12};
  for (int k = 0; k < 3; k++) {
    memset(problem.x, 0, (size_t)problem.size * sizeof *problem.x);
    problem_solve(&problem, tolerance[k]);
    /* the scaled matrix has a condition number of 5, and single nodes exceed the mean error */
    ck_assert_double_lt(problem_error(&problem), 10.0 * tolerance[k]);
  }
  problem_free(&problem);
}
END_TEST

START_TEST(iterations_do_not_grow_with_the_mesh) {
  int iterations[3];
  for (int level = 1; level <= 3; level++) {
    Problem problem = problem_new(level, 2);
    iterations[level - 1] = problem_solve(&problem, 1e-8);
    problem_free(&problem);
  }
  ck_assert_int_le(iterations[2], iterations[0] + 3);
  ck_assert_int_le(iterations[2], 25);
}
END_TEST

START_TEST(a_good_start_saves_iterations_and_the_solution_needs_none) {
  Problem problem = problem_new(2, 3);
  int cold = problem_solve(&problem, 1e-10);
  for (int k = 0; k < problem.size; k++) problem.x[k] = problem.exact[k] * (1.0 + 1e-5 * (k % 7));
  int warm = problem_solve(&problem, 1e-10);
  ck_assert_int_lt(warm, cold - 5);
  memcpy(problem.x, problem.exact, (size_t)problem.size * sizeof *problem.x);
  ck_assert_int_eq(problem_solve(&problem, 1e-10), 0);
  ck_assert_mem_eq(problem.x, problem.exact, (size_t)problem.size * sizeof *problem.x);
  problem_free(&problem);
}
END_TEST

START_TEST(columns_do_not_influence_each_other) {
  Problem problem = problem_new(2, 4), single = problem_new(2, 4);
  problem_solve(&problem, 1e-8);
  for (int column = 0; column < 3; column++) { /* the other two right-hand sides set to zero */
    for (int k = 0; k < single.size; k++) {
      single.b[k] = k % 3 == column ? problem.b[k] : 0.0;
      single.x[k] = 0.0;
    }
    problem_solve(&single, 1e-8);
    for (int k = column; k < single.size; k += 3) ck_assert_double_eq(single.x[k], problem.x[k]);
  }
  problem_free(&problem);
  problem_free(&single);
}
END_TEST

START_TEST(zero_right_hand_side_gives_zero_from_any_start) {
  Problem problem = problem_new(1, 5);
  memset(problem.b, 0, (size_t)problem.size * sizeof *problem.b);
  memcpy(problem.x, problem.exact, (size_t)problem.size * sizeof *problem.x);
  ck_assert_int_eq(problem_solve(&problem, 1e-8), 0);
  for (int k = 0; k < problem.size; k++) ck_assert(problem.x[k] == 0.0);
  problem_free(&problem);
}
END_TEST

/* The status of a solve that must fail, with x untouched and a message that holds `word`. */
static void assert_rejected(Problem *problem, double tolerance, int max_iterations, const char *word) {
  Error error;
  int iterations;
  double kept[3] = {problem->x[0], problem->x[1], problem->x[2]};
  ck_assert_int_eq(pcg_solve3(&problem->matrix, problem->b, problem->x, tolerance, max_iterations,
                              &problem->work, &iterations, &error),
                   STATUS_REJECT);
  ck_assert_ptr_nonnull(strstr(error.text, word));
  ck_assert_mem_eq(problem->x, kept, sizeof kept);
}

START_TEST(what_cannot_be_solved_is_rejected_by_name) {
  Problem problem = problem_new(1, 6);
  assert_rejected(&problem, 1e-12, 2, "not converged");

  double kept = problem.b[17];
  problem.b[17] = NAN;
  assert_rejected(&problem, 1e-8, 100, "not finite");
  problem.b[17] = kept;

  int diagonal = sparse_index(&problem.matrix, 3, 3);
  problem.matrix.value[diagonal] *= -1.0;
  assert_rejected(&problem, 1e-8, 100, "positive");
  problem.matrix.value[diagonal] *= -1.0;

  int entry = sparse_index(&problem.matrix, 0, problem.matrix.column[1]);
  int mirrored = sparse_index(&problem.matrix, problem.matrix.column[1], 0);
  problem.matrix.value[entry] = problem.matrix.value[mirrored] = 100.0; /* indefinite, diagonal kept */
  assert_rejected(&problem, 1e-8, 100, "positive");
  problem_free(&problem);
}
END_TEST

START_TEST(any_failing_allocation_is_reported_and_leaves_nothing) {
  for (long n = 1; n <= 5; n++) {
    PcgWork work;
    Error error;
    array_fail_nth(n);
    ck_assert_int_eq(pcg_work_new(&work, 10, &error), STATUS_MEMORY);
    array_fail_nth(0);
    ck_assert_ptr_null(work.x);
  }
}
END_TEST

int main(void) {
  return suite_run(
      "pcg", (SuiteTests){known_solution_is_found_to_the_tolerance, iterations_do_not_grow_with_the_mesh,
                          a_good_start_saves_iterations_and_the_solution_needs_none,
                          columns_do_not_influence_each_other, zero_right_hand_side_gives_zero_from_any_start,
                          what_cannot_be_solved_is_rejected_by_name,
                          any_failing_allocation_is_reported_and_leaves_nothing, NULL});
}
