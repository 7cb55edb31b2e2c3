/* Assembly of element masses, and the two solvers of M q = R with the fallback from one to the other. */
#include "membrane/element_kernel.h"
#include "membrane/mass.h"
#include "mesh/p2.h"

#include "random.h"
#include "suite.h"
#include <math.h>

typedef struct {
  Mesh mesh;
  Symmetry symmetry;
  MassSystem mass;
  double *element_mass; /* [21][n_elements] */
  double *R, *q;
  int n;
} Problem;

/* The exact mass of a flat P2 triangle of area 1/2, by the 16-point rule, times a weight for each element. */
static void problem_open(Problem *problem, MassSolver solver) {
  Error error;
  ck_assert_int_eq(mesh_sphere(&problem->mesh, 1, NULL, &error), STATUS_OK);
  ck_assert_int_eq(symmetry_none(&problem->symmetry, &problem->mesh, &error), STATUS_OK);
  ck_assert_int_eq(mass_new(&problem->mass, &problem->mesh, &problem->symmetry, solver, &error), STATUS_OK);
  const int n_elements = problem->mesh.n_elements;
  problem->n = 3 * problem->mesh.n_nodes;
  problem->element_mass = calloc((size_t)(MASS_PAIRS * n_elements), sizeof(double));
  problem->R = calloc((size_t)problem->n, sizeof(double));
  problem->q = calloc((size_t)problem->n, sizeof(double));
  const P2Table table = p2_table(triangle_rule(16));
  for (int p = 0; p < 6; p++)
    for (int q = p; q < 6; q++)
      for (int e = 0; e < n_elements; e++)
        for (int g = 0; g < table.n; g++)
          problem->element_mass[mass_pair(p, q) * n_elements + e] +=
              (1 + e % 7) * table.weight[g] * table.N[g][p] * table.N[g][q];
  uint64_t seed = 11;
  random_fill(&seed, problem->n, problem->R);
}

static void problem_close(Problem *problem) {
  mass_free(&problem->mass);
  symmetry_free(&problem->symmetry);
  mesh_free(&problem->mesh);
  free(problem->element_mass);
  free(problem->R);
  free(problem->q);
}

/* M from the element masses, entry by entry. */
static void multiply(const Problem *problem, const double *q, double *Mq) {
  const Mesh *mesh = &problem->mesh;
  for (int i = 0; i < problem->n; i++) Mq[i] = 0;
  for (int e = 0; e < mesh->n_elements; e++)
    for (int a = 0; a < 6; a++)
      for (int b = 0; b < 6; b++) {
        const double m =
            problem->element_mass[mass_pair(a < b ? a : b, a < b ? b : a) * mesh->n_elements + e];
        for (int c = 0; c < 3; c++) Mq[3 * mesh->element[e][a] + c] += m * q[3 * mesh->element[e][b] + c];
      }
}

/* ||M q - R|| / ||R|| */
static double residual(const Problem *problem) {
  double *Mq = calloc((size_t)problem->n, sizeof *Mq), sum = 0, scale = 0;
  multiply(problem, problem->q, Mq);
  for (int i = 0; i < problem->n; i++) {
    sum += (Mq[i] - problem->R[i]) * (Mq[i] - problem->R[i]);
    scale += problem->R[i] * problem->R[i];
  }
  free(Mq);
  return sqrt(sum / scale);
}

START_TEST(pairs_number_the_upper_triangle) {
  int next = 0;
  for (int p = 0; p < 6; p++)
    for (int q = p; q < 6; q++) ck_assert_int_eq(mass_pair(p, q), next++);
  ck_assert_int_eq(next, MASS_PAIRS);
}
END_TEST

START_TEST(both_solvers_solve_what_the_elements_add_up_to) {
  const MassSolver solvers[] = {MASS_PCG, MASS_UMFPACK};
  for (int k = 0; k < 2; k++) {
    Problem problem;
    Error error;
    problem_open(&problem, solvers[k]);
    mass_update(&problem.mass, problem.element_mass);
    ck_assert_int_eq(mass_solve(&problem.mass, LOAD_FULL, problem.R, problem.q, &error), STATUS_OK);
    ck_assert_double_le(residual(&problem), k ? 1e-14 : 1e-9); /* conjugate gradients stop at 1e-10, scaled */
    ck_assert_int_eq(problem.mass.direct != NULL, k);
    problem_close(&problem);
  }
}
END_TEST

START_TEST(a_good_start_saves_iterations) {
  Problem problem;
  Error error;
  problem_open(&problem, MASS_PCG);
  mass_update(&problem.mass, problem.element_mass);
  ck_assert_int_eq(mass_solve(&problem.mass, LOAD_FULL, problem.R, problem.q, &error), STATUS_OK);
  const long long cold = problem.mass.iterations;
  for (int i = 0; i < problem.n; i++) problem.q[i] *= 1 + 1e-6;
  ck_assert_int_eq(mass_solve(&problem.mass, LOAD_FULL, problem.R, problem.q, &error), STATUS_OK);
  const long long warm = problem.mass.iterations - cold;
  ck_assert_int_gt((int)warm, 0);
  ck_assert_int_lt((int)warm, (int)cold * 2 / 3);
  ck_assert_double_le(residual(&problem), 1e-9);
  problem_close(&problem);
}
END_TEST

START_TEST(a_spoilt_start_does_not_spoil_the_solution) {
  Problem problem;
  Error error;
  problem_open(&problem, MASS_PCG);
  mass_update(&problem.mass, problem.element_mass);
  problem.q[17] = NAN;
  ck_assert_int_eq(mass_solve(&problem.mass, LOAD_FULL, problem.R, problem.q, &error), STATUS_OK);
  ck_assert_ptr_nonnull(problem.mass.direct); /* the direct solver stepped in */
  ck_assert_double_le(residual(&problem), 1e-14);
  problem_close(&problem);
}
END_TEST

START_TEST(a_singular_mass_is_refused_by_both) {
  const MassSolver solvers[] = {MASS_PCG, MASS_UMFPACK};
  for (int k = 0; k < 2; k++) {
    Problem problem;
    Error error;
    problem_open(&problem, solvers[k]);
    for (int i = 0; i < MASS_PAIRS * problem.mesh.n_elements; i++) problem.element_mass[i] = 0;
    mass_update(&problem.mass, problem.element_mass);
    ck_assert_int_eq(mass_solve(&problem.mass, LOAD_FULL, problem.R, problem.q, &error), STATUS_REJECT);
    problem_close(&problem);
  }
}
END_TEST

int main(void) {
  return suite_run(
      "mass", (SuiteTests){pairs_number_the_upper_triangle, both_solvers_solve_what_the_elements_add_up_to,
                           a_good_start_saves_iterations, a_spoilt_start_does_not_spoil_the_solution,
                           a_singular_mass_is_refused_by_both, NULL});
}
