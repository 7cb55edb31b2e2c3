/* A membrane whose damage is driven by the mean of the energy around each point. */
#include "base/array.h"
#include "membrane/surface_average.h"

#include "shell.h"
#include "suite.h"

static const double LENGTH = 0.5;

static void open_nonlocal(Shell *shell, const char *law, const char *const names[2], const double values[2]) {
  SceneParameter parameters[] = {number(names[0], values[0]), number(names[1], values[1])};
  Error error;
  shell_open_with(shell, 1, scene_law("neo_hookean", NULL, 0), scene_law(law, parameters, 2), MASS_PCG);
  membrane_free(shell->membrane);
  shell->material.nonlocal_length = LENGTH;
  ck_assert_int_eq(membrane_new(&shell->membrane, &shell->mesh, NULL, &shell->material,
                                (MembraneMethod){.solver = MASS_PCG}, &error),
                   STATUS_OK);
}

static void open_brittle(Shell *shell) {
  open_nonlocal(shell, "marigo", (const char *const[]){"Y_D", "Y_C"}, (const double[]){0.02, 1});
}

/* mean [n_points] of f by a matrix of this test's own. */
static void take_mean(const Shell *shell, const double *f, double *mean) {
  Symmetry none;
  SurfaceAverage average;
  Error error;
  const int n = membrane_points(shell->membrane);
  double *X = zeros(3 * n);
  for (int k = 0; k < n; k++) membrane_point_position(shell->membrane, k, shell->mesh.X, X + 3 * k);
  ck_assert_int_eq(symmetry_none(&none, &shell->mesh, &error), STATUS_OK);
  ck_assert_int_eq(
      surface_average_new(&average, n, X, membrane_points_view(shell->membrane).dS0, &none, LENGTH, &error),
      STATUS_OK);
  surface_average_apply(&average, f, mean);
  surface_average_free(&average);
  symmetry_free(&none);
  free(X);
}

START_TEST(damage_follows_the_mean_of_the_energy) {
  Shell shell;
  open_brittle(&shell);
  const int n = membrane_points(shell.membrane);
  double *x = zeros(shell.n), *R = zeros(shell.n), *mean = zeros(n);
  shell_crumple(&shell, 1.1, 0.02, 1, x);
  must_force(&shell, x, R);
  const MembranePoints points = membrane_points_view(shell.membrane);
  take_mean(&shell, points.phi, mean);
  for (int k = 0; k < n; k++) ck_assert_double_eq_tol(points.d[k], fmax(mean[k] - 0.02, 0), 1e-14);
  free(x);
  free(R);
  free(mean);
  shell_close(&shell);
}
END_TEST

START_TEST(a_law_of_another_drive_gets_the_mean_of_that) {
  Shell shell;
  open_nonlocal(&shell, "rankine", (const char *const[]){"T_D", "T_C"}, (const double[]){0.1, 5});
  const int n = membrane_points(shell.membrane);
  double *x = zeros(shell.n), *R = zeros(shell.n), *T1 = zeros(n), *mean = zeros(n);
  double *const channel[MLAW_N_CHANNELS] = {[MLAW_T1] = T1};
  shell_crumple(&shell, 1.1, 0.02, 2, x);
  must_force(&shell, x, R);
  membrane_channels(shell.membrane, channel);
  take_mean(&shell, T1, mean);
  const double *d = membrane_points_view(shell.membrane).d;
  for (int k = 0; k < n; k++) ck_assert_double_eq_tol(d[k], fmax(mean[k] - 0.1, 0) / 5, 1e-13);
  free(x);
  free(R);
  free(T1);
  free(mean);
  shell_close(&shell);
}
END_TEST

START_TEST(on_an_inflated_sphere_it_changes_nothing) {
  Shell shell;
  open_brittle(&shell);
  double *x = zeros(shell.n), *R = zeros(shell.n);
  shell_inflate(&shell, 1.2, x);
  must_force(&shell, x, R);
  const double Y = (2 * 1.2 * 1.2 + pow(1.2, -4) - 3) / 2;
  for (int k = 0; k < membrane_points(shell.membrane); k++)
    ck_assert_double_eq_tol(membrane_points_view(shell.membrane).d[k], Y - 0.02, 1e-13);
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

START_TEST(each_point_releases_its_own_energy) {
  Shell shell;
  open_brittle(&shell);
  const int n = membrane_points(shell.membrane);
  double *x = zeros(shell.n), *R = zeros(shell.n), *Y0 = zeros(n), *d0 = zeros(n), expected = 0;
  shell_crumple(&shell, 1.1, 0.02, 1, x);
  must_force(&shell, x, R);
  MembranePoints points = membrane_points_view(shell.membrane);
  memcpy(Y0, points.phi, (size_t)n * sizeof *Y0);
  memcpy(d0, points.d, (size_t)n * sizeof *d0);
  membrane_commit(shell.membrane);
  shell_crumple(&shell, 1.2, 0.02, 3, x);
  must_force(&shell, x, R);
  points = membrane_points_view(shell.membrane);
  for (int k = 0; k < n; k++)
    expected += 0.5 * (Y0[k] + points.phi[k]) * (points.d[k] - d0[k]) * points.dS0[k];
  ck_assert_double_gt(expected, 0.01);
  ck_assert_double_eq_tol(membrane_dissipation(shell.membrane), expected, 1e-13);
  free(x);
  free(R);
  free(Y0);
  free(d0);
  shell_close(&shell);
}
END_TEST

START_TEST(setup_survives_the_failure_of_any_allocation) {
  Shell shell;
  open_brittle(&shell);
  Status status = STATUS_MEMORY;
  for (long nth = 1; status != STATUS_OK; nth++) {
    ck_assert_int_lt((int)nth, 200);
    Membrane *membrane;
    Error error;
    array_fail_nth(nth);
    status = membrane_new(&membrane, &shell.mesh, NULL, &shell.material, (MembraneMethod){.solver = MASS_PCG},
                          &error);
    array_fail_nth(0);
    if (status == STATUS_OK)
      membrane_free(membrane);
    else
      ck_assert_int_eq(status, STATUS_MEMORY);
  }
  shell_close(&shell);
}
END_TEST

int main(void) {
  return suite_run("nonlocal_drive",
                   (SuiteTests){damage_follows_the_mean_of_the_energy,
                                a_law_of_another_drive_gets_the_mean_of_that,
                                on_an_inflated_sphere_it_changes_nothing, each_point_releases_its_own_energy,
                                setup_survives_the_failure_of_any_allocation, NULL});
}
