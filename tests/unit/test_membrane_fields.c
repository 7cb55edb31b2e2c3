/* Fields, energies and positions that are read from the membrane, and the channels of a general damage law.
 */
#include "mesh/p2.h"
#include "mesh/surface.h"

#include "shell.h"
#include "suite.h"
#include <stdio.h>

static const double pi = 3.14159265358979323846;

/* ---- fields at the nodes ---- */

/* Largest error at the nodes of the field a . X known at the integration points. */
static double linear_field_error(int subdivisions, const double a[3]) {
  Shell shell;
  shell_open(&shell, subdivisions);
  const int n = membrane_points(shell.membrane);
  double *values = zeros(n), *nodes = zeros(shell.mesh.n_nodes), worst = 0;
  for (int k = 0; k < n; k++) {
    double X[3];
    membrane_point_position(shell.membrane, k, shell.mesh.X, X);
    values[k] = dot(3, a, X);
  }
  membrane_nodal_field(shell.membrane, values, nodes);
  for (int p = 0; p < shell.mesh.n_nodes; p++)
    worst = fmax(worst, fabs(nodes[p] - dot(3, a, shell.mesh.X + 3 * p)));
  free(values);
  free(nodes);
  shell_close(&shell);
  return worst;
}

START_TEST(a_field_linear_in_space_reaches_the_nodes_to_second_order) {
  const double a[3] = {1, -0.5, 0.3};
  double before = linear_field_error(2, a);
  for (int level = 3; level <= 4; level++) {
    const double now = linear_field_error(level, a);
    ck_assert_double_eq_tol(log2(before / now), 2, 0.2); /* a plane cannot follow a curvature: h^2 a.X / 8 */
    before = now;
  }
  ck_assert_double_lt(before, 1e-3);
}
END_TEST

START_TEST(a_constant_field_stays_constant) {
  Shell shell;
  shell_open(&shell, 1);
  const int n = membrane_points(shell.membrane);
  double *values = zeros(n), *nodes = zeros(shell.mesh.n_nodes);
  for (int k = 0; k < n; k++) values[k] = 0.7;
  membrane_nodal_field(shell.membrane, values, nodes);
  for (int p = 0; p < shell.mesh.n_nodes; p++) ck_assert_double_eq_tol(nodes[p], 0.7, 1e-15);
  free(values);
  free(nodes);
  shell_close(&shell);
}
END_TEST

START_TEST(a_nodal_value_never_leaves_the_range_of_the_values_around_it) {
  Shell shell;
  shell_open(&shell, 1);
  const Mesh *mesh = &shell.mesh;
  const int n = membrane_points(shell.membrane);
  double *values = zeros(n), *nodes = zeros(mesh->n_nodes);
  for (uint64_t seed = 1; seed <= 20; seed++) {
    uint64_t state = seed;
    for (int k = 0; k < n; k++) values[k] = pow(random_uniform(&state), 5); /* spikes on a calm ground */
    membrane_nodal_field(shell.membrane, values, nodes);
    for (int p = 0; p < mesh->n_nodes; p++) {
      double low = INFINITY, high = -INFINITY;
      for (int e = 0; e < mesh->n_elements; e++)
        for (int q = 0; q < 6; q++)
          if (mesh->element[e][q] == p)
            for (int g = 0; g < POINTS_PER_ELEMENT; g++) {
              low = fmin(low, values[g * mesh->n_elements + e]);
              high = fmax(high, values[g * mesh->n_elements + e]);
            }
      ck_assert_msg(nodes[p] >= low && nodes[p] <= high, "seed %llu, node %d", (unsigned long long)seed, p);
    }
  }
  free(values);
  free(nodes);
  shell_close(&shell);
}
END_TEST

/* ---- points ---- */

START_TEST(integration_points_stand_where_the_rule_says) {
  Shell shell;
  shell_open(&shell, 1);
  double *x = zeros(shell.n);
  shell_crumple(&shell, 1, 0.05, 4, x);
  const TriangleRule *rule = triangle_rule(POINTS_PER_ELEMENT);
  const int n_elements = shell.mesh.n_elements;
  ck_assert_int_eq(membrane_points(shell.membrane), POINTS_PER_ELEMENT * n_elements);
  for (int k = 0; k < membrane_points(shell.membrane); k++) {
    double N[6], expected[3], position[3];
    p2_values(rule->point[k / n_elements][0], rule->point[k / n_elements][1], N);
    p2_interpolate(x, shell.mesh.element[k % n_elements], N, expected);
    membrane_point_position(shell.membrane, k, x, position);
    for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(position[c], expected[c], 1e-15);
  }
  free(x);
  shell_close(&shell);
}
END_TEST

START_TEST(area_weights_integrate_over_the_reference_and_over_the_current_surface) {
  Shell shell;
  shell_open(&shell, 3);
  double *x = zeros(shell.n), *R = zeros(shell.n), reference = 0, current = 0;
  const double F[3][3] = {{2, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};
  shell_map(&shell, F, x);
  must_force(&shell, x, R);
  const MembranePoints points = membrane_points_view(shell.membrane);
  ck_assert_ptr_null(points.d);
  for (int k = 0; k < membrane_points(shell.membrane); k++) {
    reference += points.dS0[k];
    current += points.dS0[k] * points.J[k];
  }
  /* six points against the rule of surface_area, at 1280 elements */
  ck_assert_double_eq_tol(reference / surface_area(&shell.mesh, NULL, shell.mesh.X), 1, 1e-6);
  ck_assert_double_eq_tol(current / surface_area(&shell.mesh, NULL, x), 1, 1e-5);
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

/* ---- energies ---- */

static double energy_density(double stretch) {
  return 0.5 * (2 * stretch * stretch + pow(stretch, -4) - 3);
}

START_TEST(the_energy_of_the_inflated_sphere_is_its_area_times_the_density) {
  Shell shell;
  shell_open_damaged(&shell, 3);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  for (double stretch = 1.1; stretch < 2; stretch += 0.2) {
    shell_inflate(&shell, stretch, x);
    must_force(&shell, x, R);
    const double Y = energy_density(stretch), d = fmin(fmax((Y - Y_D) / Y_C, 0), 1);
    ck_assert_double_eq_tol(membrane_energy(shell.membrane) / (4 * pi * (1 - d) * Y), 1, 1e-5); /* geometry */
  }
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

START_TEST(dissipation_is_the_area_under_the_threshold) {
  /* int Y dd with Y = Y_D + Y_C d: Y_D d + Y_C d^2/2, exact in any step that starts beyond the threshold. */
  Shell shell;
  shell_open_damaged(&shell, 3);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  const double path[] = {1.2116009, 1.3, 1.2, 1.25, 1.6, 1.0, 1.7}; /* the first is where Y = Y_D */
  double d_before = 0, stretch_max = 1;
  for (size_t i = 0; i < sizeof path / sizeof *path; i++) {
    stretch_max = fmax(stretch_max, path[i]);
    shell_inflate(&shell, path[i], x);
    must_force(&shell, x, R);
    const double d = fmax((energy_density(stretch_max) - Y_D) / Y_C, 0);
    const double spent = 4 * pi * (Y_D * (d - d_before) + 0.5 * Y_C * (d * d - d_before * d_before));
    ck_assert_double_eq_tol(membrane_dissipation(shell.membrane), spent, 1e-5 * spent + 1e-7);
    membrane_commit(shell.membrane);
    ck_assert_double_eq(membrane_dissipation(shell.membrane), 0);
    d_before = d;
  }
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

START_TEST(an_elastic_membrane_dissipates_nothing) {
  Shell shell;
  shell_open(&shell, 1);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  shell_inflate(&shell, 1.9, x);
  must_force(&shell, x, R);
  ck_assert_double_eq(membrane_dissipation(shell.membrane), 0);
  ck_assert_ptr_null(membrane_trial(shell.membrane)->d);
  membrane_commit(shell.membrane);
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

/* ---- areas ---- */

START_TEST(the_compressed_area_is_the_share_of_the_sphere_where_T2_is_negative) {
  Shell shell;
  shell_open(&shell, 3);
  const int n = membrane_points(shell.membrane);
  double *T2 = zeros(n);
  for (int k = 0; k < n; k++) T2[k] = k % 2 ? -1e-9 : 1e-9; /* round-off of a membrane at rest */
  ck_assert_double_eq(membrane_compressed_area(shell.membrane, T2), 0);
  for (int k = 0; k < n; k++) {
    double X[3];
    membrane_point_position(shell.membrane, k, shell.mesh.X, X);
    T2[k] = 0.5 - X[2]; /* negative on the cap beyond z = 0.5, which is a quarter of the sphere */
  }
  /* 7680 points, of which those in a band of half a distance of points around a circle of 0.87 may be wrong
   */
  ck_assert_double_eq_tol(membrane_compressed_area(shell.membrane, T2), 0.25, 0.01);
  for (int k = 0; k < n; k++) T2[k] = -1;
  ck_assert_double_eq_tol(membrane_compressed_area(shell.membrane, T2), 1, 1e-12);
  free(T2);
  shell_close(&shell);
}
END_TEST

/* ---- channels of a general damage law ---- */

enum { TIME = 2 * MLAW_N_CHANNELS };

/* Channels of the undamaged sphere at a stretch. */
static void inflated_channels(double stretch, double channel[MLAW_N_CHANNELS]) {
  const double l = stretch, T = 1 - pow(l, -6);
  const double values[MLAW_N_CHANNELS] = {energy_density(l), 2 * l * l - 2, pow(l, 4) - 1, l, l, T, T};
  memcpy(channel, values, sizeof values);
}

static void check_channels(const Shell *shell, const double *state, double stretch) {
  const int n = membrane_points(shell->membrane);
  double expected[MLAW_N_CHANNELS];
  inflated_channels(stretch, expected);
  for (int c = 0; c < MLAW_N_CHANNELS; c++)
    for (int k = 0; k < n; k++) /* stretches and tensions that are equal: sqrt(eps) */
      ck_assert_double_eq_tol(state[c * n + k], expected[c], c < MLAW_L1 ? 1e-13 : 2e-7);
}

START_TEST(a_general_law_is_handed_the_undamaged_state_at_both_ends_of_the_step) {
  SceneParameter rate[] = {number("rate", 0.5)};
  Shell shell;
  shell_open_with(&shell, 1, scene_law("neo_hookean", NULL, 0), scene_law("channels.all", rate, 1), MASS_PCG);
  const int n = membrane_points(shell.membrane);
  const double path[] = {1.2, 1.1, 1.5, 1.4}, dt = 0.1; /* the dt of must_force */
  double *x = zeros(shell.n), *R = zeros(shell.n), before = 1, damage = 0;
  for (size_t i = 0; i < sizeof path / sizeof *path; i++) {
    shell_inflate(&shell, 2, x); /* a trial that comes to nothing */
    must_force(&shell, x, R);
    shell_inflate(&shell, path[i], x);
    must_force(&shell, x, R);
    const MembraneHistory *trial = membrane_trial(shell.membrane);
    damage += dt * 0.5 * (1 - pow(path[i], -6));
    check_channels(&shell, trial->damage_state, path[i]);
    check_channels(&shell, trial->damage_state + MLAW_N_CHANNELS * n, before);
    for (int k = 0; k < n; k++) {
      ck_assert_double_eq_tol(trial->damage_state[TIME * n + k], 0.5 + dt * (double)(i + 1), 1e-14);
      ck_assert_double_eq_tol(trial->d[k], damage, 1e-7);
    }
    membrane_commit(shell.membrane);
    before = path[i];
  }
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

START_TEST(channels_that_nobody_asked_for_are_not_handed_over) {
  SceneParameter rate[] = {number("rate", 0.5)};
  Shell shell;
  shell_open_with(&shell, 1, scene_law("neo_hookean", NULL, 0), scene_law("channels.few", rate, 1), MASS_PCG);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  shell_crumple(&shell, 1.1, 0.02, 1, x);
  for (int i = 0; i < 2; i++) {
    must_force(&shell, x, R);
    membrane_commit(shell.membrane);
  }
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

/* Lifts one node off the sphere until the law gives up in the elements around it. */
static void check_law_failure(const char *law, double lift, Status expected, const char *reason) {
  SceneParameter G[] = {number("G_s", 1)};
  Shell shell;
  shell_open_with(&shell, 1, scene_law(law, G, 1), no_law(), MASS_PCG);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  const int node = 31;
  Error error;
  shell_inflate(&shell, 1, x);
  for (int c = 0; c < 3; c++) x[3 * node + c] *= lift;
  ck_assert_int_eq(membrane_force(shell.membrane, x, 0, 0.1, R, &error), expected);
  ck_assert_int_eq(error.code, expected);
  ck_assert_ptr_nonnull(strstr(error.text, reason));
  int element = -1, point = -1;
  ck_assert_int_eq(sscanf(error.text, "element %d, integration point %d: ", &element, &point), 2);
  bool touches = false;
  for (int p = 0; p < 6; p++) touches |= shell.mesh.element[element][p] == node;
  ck_assert(touches);
  free(x);
  free(R);
  shell_close(&shell);
}

START_TEST(a_law_that_fails_is_named_with_its_element) {
  check_law_failure("domain", 1.6, STATUS_REJECT, "I1 is beyond 1");
  check_law_failure("nan_energy", 1.6, STATUS_REJECT, "nan");
}
END_TEST

int main(void) {
  return suite_run(
      "membrane_fields",
      (SuiteTests){a_field_linear_in_space_reaches_the_nodes_to_second_order, a_constant_field_stays_constant,
                   a_nodal_value_never_leaves_the_range_of_the_values_around_it,
                   integration_points_stand_where_the_rule_says,
                   area_weights_integrate_over_the_reference_and_over_the_current_surface,
                   the_energy_of_the_inflated_sphere_is_its_area_times_the_density,
                   dissipation_is_the_area_under_the_threshold, an_elastic_membrane_dissipates_nothing,
                   the_compressed_area_is_the_share_of_the_sphere_where_T2_is_negative,
                   a_general_law_is_handed_the_undamaged_state_at_both_ends_of_the_step,
                   channels_that_nobody_asked_for_are_not_handed_over,
                   a_law_that_fails_is_named_with_its_element, NULL});
}
