/* The membrane against the exact inflation of a sphere, the gradient of its own energy, affine maps, and its
 * own mass. */
#include "mesh/p2.h"
#include "mesh/surface.h"

#include "shell.h"
#include "suite.h"

/* ---- the inflated sphere (paper section 4) ---- */

typedef struct {
  double Y, d, T, p;
} Inflated;

static Inflated inflated(double stretch, double largest_stretch) {
  const double l = stretch, m = largest_stretch;
  const double Ymax = 0.5 * (2 * m * m + pow(m, -4) - 3);
  Inflated exact = {.Y = 0.5 * (2 * l * l + pow(l, -4) - 3)};
  exact.d = fmin(fmax((Ymax - Y_D) / Y_C, 0), 1);
  exact.T = (1 - exact.d) * (1 - pow(l, -6));
  exact.p = 2 * exact.T / l;
  return exact;
}

static void check_inflated(const Shell *shell, Inflated exact) {
  const MembranePoints points = membrane_points_view(shell->membrane);
  const int n = membrane_points(shell->membrane);
  double *T1 = zeros(n), *T2 = zeros(n);
  membrane_principal_tensions(shell->membrane, T1, T2);
  for (int k = 0; k < n; k++) {
    ck_assert_double_eq_tol(points.phi[k], exact.Y, 1e-13);
    ck_assert_double_eq_tol(points.d[k], exact.d, 1e-13);
    ck_assert_double_eq_tol(0.5 * (T1[k] + T2[k]), exact.T, 1e-13);
    /* Equal stretches come from the square root of a difference of order eps: each errs by sqrt(eps). */
    ck_assert_double_eq_tol(T1[k], T2[k], 2e-7);
    ck_assert_double_ge(T1[k], T2[k] - 1e-15);
  }
  free(T1);
  free(T2);
}

START_TEST(the_inflated_sphere_has_the_exact_energy_damage_and_tension) {
  const double stretches[] = {1, 1.0001, 1.1, 1.2116009, 1.35, 1.7, 1.9138, 2.1};
  for (size_t i = 0; i < sizeof stretches / sizeof *stretches; i++) {
    Shell shell;
    shell_open_damaged(&shell, 2);
    double *x = zeros(shell.n), *R = zeros(shell.n);
    shell_inflate(&shell, stretches[i], x);
    must_force(&shell, x, R);
    check_inflated(&shell, inflated(stretches[i], stretches[i]));
    free(x);
    free(R);
    shell_close(&shell);
  }
}
END_TEST

START_TEST(a_cycle_of_inflation_keeps_the_damage_of_the_largest_stretch) {
  const double path[] = {1.1, 1.5, 1.2, 1.0, 1.4, 1.6, 1.3, 1.9};
  Shell shell;
  double largest = 1;
  shell_open_damaged(&shell, 1);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  for (size_t i = 0; i < sizeof path / sizeof *path; i++) {
    largest = fmax(largest, path[i]);
    shell_inflate(&shell, path[i], x);
    must_force(&shell, x, R);
    check_inflated(&shell, inflated(path[i], largest));
    membrane_commit(shell.membrane);
  }
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

/* Relative errors of the pressure, as surface average of q . n, and of the worst nodal load. */
static void pressure_errors(int subdivisions, double stretch, double *average, double *nodal) {
  const Inflated exact = inflated(stretch, stretch);
  Shell shell;
  shell_open_damaged(&shell, subdivisions);
  double *x = zeros(shell.n), *R = zeros(shell.n), *q = zeros(shell.n), *A = zeros(shell.n);
  shell_inflate(&shell, stretch, x);
  must_force(&shell, x, R);
  must_load(&shell, R, q);
  surface_area_vectors(&shell.mesh, NULL, x, A);
  *average = dot(shell.n, q, A) / surface_area(&shell.mesh, NULL, x) / exact.p - 1;
  *nodal = 0;
  for (int p = 0; p < shell.mesh.n_nodes; p++) {
    double gap[3];
    for (int c = 0; c < 3; c++) gap[c] = q[3 * p + c] / exact.p - shell.mesh.X[3 * p + c];
    *nodal = fmax(*nodal, norm(3, gap));
  }
  free(x);
  free(R);
  free(q);
  free(A);
  shell_close(&shell);
}

START_TEST(the_pressure_of_the_inflated_sphere_converges) {
  double average[5], nodal[5];
  for (int level = 1; level <= 4; level++) pressure_errors(level, 1.3, &average[level], &nodal[level]);
  ck_assert_double_le(fabs(average[3]), 5e-6); /* 3.0e-6 at 1280 elements: the P2 geometry */
  ck_assert_double_le(nodal[3], 1.5e-2);       /* 1.43e-2 */
  for (int level = 2; level <= 4; level++) {
    ck_assert_double_eq_tol(log2(average[level - 1] / average[level]), 4, 0.3);
    ck_assert_double_eq_tol(log2(nodal[level - 1] / nodal[level]), 2, 0.3);
  }
}
END_TEST

/* ---- R is the gradient of the energy ---- */

static double energy_at(Shell *shell, const double *x, double step, const double *direction) {
  double *moved = zeros(shell->n), *R = zeros(shell->n);
  for (int i = 0; i < shell->n; i++) moved[i] = x[i] + step * direction[i];
  must_force(shell, moved, R);
  free(moved);
  free(R);
  return membrane_energy(shell->membrane);
}

/* dE along a random direction, by central differences with one Richardson step, against R . direction. */
static void check_gradient(Shell *shell, const double *x, uint64_t seed) {
  double *direction = zeros(shell->n), *R = zeros(shell->n);
  const double h = 2e-4;
  uint64_t state = seed;
  random_fill(&state, shell->n, direction);
  must_force(shell, x, R);
  const double slope = dot(shell->n, R, direction);
  double wide = energy_at(shell, x, 2 * h, direction) - energy_at(shell, x, -2 * h, direction);
  double narrow = energy_at(shell, x, h, direction) - energy_at(shell, x, -h, direction);
  const double difference = (8 * narrow - wide) / (12 * h);
  /* h^4 E^(5)/30, with derivatives of E that grow as the inverse node distance; round-off is eps E/h = 1e-11
   */
  ck_assert_msg(fabs(difference - slope) <= 1e-10 * norm(shell->n, R) * norm(shell->n, direction),
                "seed %llu: dE = %.15g, R . w = %.15g", (unsigned long long)seed, difference, slope);
  free(direction);
  free(R);
}

START_TEST(the_force_is_the_gradient_of_the_elastic_energy) {
  SceneParameter C[] = {number("C", 2.5)};
  const SceneLaw laws[] = {scene_law("neo_hookean", NULL, 0), scene_law("skalak", C, 1)};
  for (int law = 0; law < 2; law++)
    for (uint64_t seed = 1; seed <= 5; seed++) {
      Shell shell;
      shell_open_with(&shell, 1, laws[law], no_law(), MASS_PCG);
      double *x = zeros(shell.n);
      shell_crumple(&shell, 1, 0.05, 100 + seed, x);
      check_gradient(&shell, x, seed);
      free(x);
      shell_close(&shell);
    }
}
END_TEST

START_TEST(the_force_is_the_gradient_of_the_energy_at_frozen_damage) {
  for (uint64_t seed = 1; seed <= 5; seed++) {
    Shell shell;
    shell_open_damaged(&shell, 1);
    double *x = zeros(shell.n), *R = zeros(shell.n);
    shell_crumple(&shell, 1.5, 0.05, seed, x); /* damages unevenly */
    must_force(&shell, x, R);
    membrane_commit(shell.membrane);
    const MembraneHistory *accepted = membrane_accepted(shell.membrane);
    double least = INFINITY, most = 0;
    for (int k = 0; k < membrane_points(shell.membrane); k++) {
      least = fmin(least, accepted->d[k]);
      most = fmax(most, accepted->d[k]);
    }
    ck_assert_double_gt(most - least, 0.1);
    shell_crumple(&shell, 1.02, 0.01, seed, x); /* unloads everywhere */
    check_gradient(&shell, x, seed);
    const MembraneHistory *trial = membrane_trial(shell.membrane);
    ck_assert_mem_eq(trial->d, accepted->d, (size_t)membrane_points(shell.membrane) * sizeof *trial->d);
    free(x);
    free(R);
    shell_close(&shell);
  }
}
END_TEST

/* ---- frames ---- */

/* Rotation by Rodrigues' formula. */
static void rotation(const double axis[3], double angle, double Q[3][3]) {
  const double length = norm(3, axis), c = cos(angle), s = sin(angle);
  const double u[3] = {axis[0] / length, axis[1] / length, axis[2] / length};
  const double cross[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) Q[i][j] = (i == j) * c + s * cross[i][j] + (1 - c) * u[i] * u[j];
}

START_TEST(the_force_moves_and_turns_with_the_capsule) {
  double Q[3][3];
  rotation((const double[3]){1, -2, 0.5}, 1.1, Q);
  Shell shell;
  shell_open(&shell, 2);
  double *x = zeros(shell.n), *moved = zeros(shell.n), *R = zeros(shell.n), *R_moved = zeros(shell.n);
  shell_crumple(&shell, 1, 0.01, 3, x);
  for (int p = 0; p < shell.n; p += 3)
    for (int i = 0; i < 3; i++)
      moved[p + i] = 5.0 - i + Q[i][0] * x[p] + Q[i][1] * x[p + 1] + Q[i][2] * x[p + 2];
  must_force(&shell, x, R);
  const double energy = membrane_energy(shell.membrane);
  must_force(&shell, moved, R_moved);
  ck_assert_double_eq_tol(membrane_energy(shell.membrane) / energy, 1, 1e-13);
  for (int p = 0; p < shell.n; p += 3)
    for (int i = 0; i < 3; i++) { /* round-off of positions of order 5 over edges of order 0.3 */
      const double turned = Q[i][0] * R[p] + Q[i][1] * R[p + 1] + Q[i][2] * R[p + 2];
      ck_assert_double_eq_tol(R_moved[p + i], turned, 1e-13);
    }
  free(x);
  free(moved);
  free(R);
  free(R_moved);
  shell_close(&shell);
}
END_TEST

START_TEST(the_force_has_no_resultant_and_no_torque) {
  Shell shell;
  shell_open_damaged(&shell, 2);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  shell_crumple(&shell, 1.4, 0.02, 8, x);
  must_force(&shell, x, R);
  double force[3] = {0}, torque[3] = {0}, scale = 0;
  for (int p = 0; p < shell.n; p += 3)
    for (int i = 0; i < 3; i++) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      force[i] += R[p + i];
      torque[i] += x[p + j] * R[p + k] - x[p + k] * R[p + j];
      scale += fabs(R[p + i]);
    }
  for (int i = 0; i < 3; i++) {
    ck_assert_double_le(fabs(force[i]), 1e-14 * scale);
    ck_assert_double_le(fabs(torque[i]), 1e-14 * scale);
  }
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

/* ---- affine maps ---- */

/* Principal stretches of F on the tangent plane spanned by A1 and A2: eigenvalues of the metric of F e_1,
 * F e_2 for an orthonormal pair e. */
static void principal_stretches(const double F[3][3], const double A1[3], const double A2[3], double *l1,
                                double *l2) {
  double e[2][3], Fe[2][3] = {{0}}, metric[3];
  const double length = norm(3, A1), along = dot(3, A1, A2) / length;
  for (int i = 0; i < 3; i++) e[0][i] = A1[i] / length;
  for (int i = 0; i < 3; i++) e[1][i] = A2[i] - along * e[0][i];
  const double height = norm(3, e[1]);
  for (int i = 0; i < 3; i++) e[1][i] /= height;
  for (int a = 0; a < 2; a++)
    for (int i = 0; i < 3; i++) Fe[a][i] = dot(3, F[i], e[a]);
  metric[0] = dot(3, Fe[0], Fe[0]);
  metric[1] = dot(3, Fe[0], Fe[1]);
  metric[2] = dot(3, Fe[1], Fe[1]);
  const double mean = 0.5 * (metric[0] + metric[2]), radius = hypot(0.5 * (metric[0] - metric[2]), metric[1]);
  *l1 = sqrt(mean + radius);
  *l2 = sqrt(mean - radius);
}

typedef double Tension(double l1, double l2); /* along l1; the other is the same with l1 and l2 exchanged */

static double neo_hookean_tension(double l1, double l2) {
  return (l1 * l1 - 1 / (l1 * l1 * l2 * l2)) / (l1 * l2);
}
static double skalak_tension(double l1, double l2) {
  const double C = 2.5;
  return l1 / l2 * (l1 * l1 - 1 + C * l2 * l2 * (l1 * l1 * l2 * l2 - 1));
}

/* Tensions of the map F against the closed form at every integration point; the surface is the P2 one, on
 * which an affine map of the nodes is the map itself. */
static void check_affine(Shell *shell, Tension *tension, const double F[3][3]) {
  const int n_elements = shell->mesh.n_elements, n = membrane_points(shell->membrane);
  double *x = zeros(shell->n), *R = zeros(shell->n), *T1 = zeros(n), *T2 = zeros(n);
  shell_map(shell, F, x);
  must_force(shell, x, R);
  membrane_principal_tensions(shell->membrane, T1, T2);
  const MembranePoints points = membrane_points_view(shell->membrane);
  const P2Table table = p2_table(triangle_rule(POINTS_PER_ELEMENT));
  for (int k = 0; k < n; k++) {
    double A1[3], A2[3], l1, l2;
    p2_tangents(shell->mesh.X, shell->mesh.element[k % n_elements], table.dN[k / n_elements], A1, A2);
    principal_stretches(F, A1, A2, &l1, &l2);
    const double spread = fmax(l1 - l2, 1e-7); /* eps over the difference of the stretches */
    ck_assert_double_eq_tol(points.J[k], l1 * l2, 1e-13);
    ck_assert_double_eq_tol(T1[k], tension(l1, l2), 1e-13 / spread);
    ck_assert_double_eq_tol(T2[k], tension(l2, l1), 1e-13 / spread);
  }
  free(x);
  free(R);
  free(T1);
  free(T2);
}

START_TEST(tensions_of_an_affine_map_follow_the_closed_form_of_the_law) {
  const double maps[][3][3] = {{{1.7, 0, 0}, {0, 1, 0}, {0, 0, 1}}, /* uniaxial stretch */
                               {{1.6, 0, 0}, {0, 0.9, 0}, {0, 0, 0.7}},
                               {{1.2, 0.3, 0.8}, {-0.1, 1.1, 0}, {0.2, 0, 0.8}}};
  SceneParameter C[] = {number("C", 2.5)};
  for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
    Shell shell;
    shell_open(&shell, 1);
    check_affine(&shell, neo_hookean_tension, maps[i]);
    shell_close(&shell);
    shell_open_with(&shell, 1, scene_law("skalak", C, 1), no_law(), MASS_PCG);
    check_affine(&shell, skalak_tension, maps[i]);
    shell_close(&shell);
  }
}
END_TEST

/* ---- M q = R ---- */

START_TEST(conjugate_gradients_and_umfpack_agree) {
  Shell iterative, direct;
  shell_open(&iterative, 2);
  shell_open_with(&direct, 2, scene_law("neo_hookean", NULL, 0), no_law(), MASS_UMFPACK);
  double *x = zeros(iterative.n), *R = zeros(iterative.n), *q = zeros(iterative.n),
         *q_direct = zeros(iterative.n);
  for (uint64_t seed = 1; seed <= 3; seed++) { /* the first from zero, the others from the last q */
    shell_crumple(&iterative, 1.1, 0.005 * (double)seed, seed, x);
    must_force(&iterative, x, R);
    must_load(&iterative, R, q);
    must_force(&direct, x, R);
    must_load(&direct, R, q_direct);
    double worst = 0;
    for (int i = 0; i < iterative.n; i++) worst = fmax(worst, fabs(q[i] - q_direct[i]));
    ck_assert_double_le(worst, 1e-9 * norm(iterative.n, q_direct));
  }
  ck_assert_int_gt((int)membrane_count(iterative.membrane).mass_iterations, 0);
  ck_assert_int_eq((int)membrane_count(direct.membrane).mass_iterations, 0);
  free(x);
  free(R);
  free(q);
  free(q_direct);
  shell_close(&iterative);
  shell_close(&direct);
}
END_TEST

START_TEST(the_mass_of_the_load_gives_back_the_force) {
  /* sum_p R_p . c = int q . c dS for any constant c, since the shape functions sum to one: the resultant of q
   * is that of R, here by the 12-point rule on the deformed surface. */
  Shell shell;
  shell_open(&shell, 2);
  double *x = zeros(shell.n), *R = zeros(shell.n), *q = zeros(shell.n);
  shell_crumple(&shell, 1.1, 0, 1, x);
  must_force(&shell, x, R);
  for (int p = 0; p < shell.n; p += 3) R[p] += 1e-3 * x[p] * x[p]; /* so that the resultant is not zero */
  must_load(&shell, R, q);
  const P2Table table = p2_table(triangle_rule(12));
  double resultant = 0, expected = 0;
  for (int e = 0; e < shell.mesh.n_elements; e++)
    for (int g = 0; g < table.n; g++) {
      const int *node = shell.mesh.element[e];
      double a1[3], a2[3], value[3];
      p2_tangents(x, node, table.dN[g], a1, a2);
      p2_interpolate(q, node, table.N[g], value);
      const double a11 = dot(3, a1, a1), a12 = dot(3, a1, a2), a22 = dot(3, a2, a2);
      resultant += table.weight[g] * sqrt(a11 * a22 - a12 * a12) * value[0];
    }
  for (int p = 0; p < shell.n; p += 3) expected += R[p];
  ck_assert_double_eq_tol(resultant / expected, 1, 1e-3); /* six points integrate to degree 4 */
  free(x);
  free(R);
  free(q);
  shell_close(&shell);
}
END_TEST

int main(void) {
  return suite_run("membrane", (SuiteTests){the_inflated_sphere_has_the_exact_energy_damage_and_tension,
                                            a_cycle_of_inflation_keeps_the_damage_of_the_largest_stretch,
                                            the_pressure_of_the_inflated_sphere_converges,
                                            the_force_is_the_gradient_of_the_elastic_energy,
                                            the_force_is_the_gradient_of_the_energy_at_frozen_damage,
                                            the_force_moves_and_turns_with_the_capsule,
                                            the_force_has_no_resultant_and_no_torque,
                                            tensions_of_an_affine_map_follow_the_closed_form_of_the_law,
                                            conjugate_gradients_and_umfpack_agree,
                                            the_mass_of_the_load_gives_back_the_force, NULL});
}
