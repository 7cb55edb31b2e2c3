/* The membrane with quartic interpolation: exact energies, the balance of power, and what both interpolations
 * share. */
#include "shell.h"
#include "suite.h"

static void open_shell(Shell *shell, int subdivisions, Interpolation interpolation, const Symmetry *symmetry,
                       SceneLaw damage) {
  Error error;
  shell->symmetry = (Symmetry){0};
  ck_assert_int_eq(mesh_sphere(&shell->mesh, subdivisions, NULL, &error), STATUS_OK);
  shell->material = make_material(scene_law("neo_hookean", NULL, 0), damage);
  shell->n = 3 * shell->mesh.n_nodes;
  ck_assert_int_eq(membrane_new(&shell->membrane, &shell->mesh, symmetry, &shell->material,
                                (MembraneMethod){.interpolation = interpolation}, &error),
                   STATUS_OK);
}

static SceneLaw marigo(void) {
  static SceneParameter parameters[2];
  parameters[0] = number("Y_D", Y_D);
  parameters[1] = number("Y_C", Y_C);
  return scene_law("marigo", parameters, 2);
}

/* ---- a smooth map of the unit sphere that no element interpolates exactly ---- */

/* x = X + s (3 X_y^2 X_z, X_z^3 - X_x X_y, 2 X_x^2 X_y) */
static void mapped(double s, const double X[3], double x[3]) {
  x[0] = X[0] + s * 3 * X[1] * X[1] * X[2];
  x[1] = X[1] + s * (X[2] * X[2] * X[2] - X[0] * X[1]);
  x[2] = X[2] + s * 2 * X[0] * X[0] * X[1];
}

/* dx/dX t */
static void mapped_tangent(double s, const double X[3], const double t[3], double a[3]) {
  a[0] = t[0] + s * (6 * X[1] * X[2] * t[1] + 3 * X[1] * X[1] * t[2]);
  a[1] = t[1] + s * (3 * X[2] * X[2] * t[2] - X[1] * t[0] - X[0] * t[1]);
  a[2] = t[2] + s * (4 * X[0] * X[1] * t[0] + 2 * X[0] * X[0] * t[1]);
}

/* Energy of the neo-Hookean membrane, G_s = 1: phi = (C_11 + C_22 + 1/det C - 3)/2 with the metric C of the
 * map along two unit tangents, integrated over the sphere by the midpoint rule in both angles. */
static double exact_energy(double s) {
  enum { SLICES = 2000, SECTORS = 64 }; /* exact to 1e-6, and to round-off in the second */
  const double pi = 3.14159265358979324;
  double sum = 0;
  for (int i = 0; i < SLICES; i++)
    for (int j = 0; j < SECTORS; j++) {
      const double theta = pi * (i + 0.5) / SLICES, angle = 2 * pi * (j + 0.5) / SECTORS;
      const double X[3] = {sin(theta) * cos(angle), sin(theta) * sin(angle), cos(theta)};
      const double t1[3] = {cos(theta) * cos(angle), cos(theta) * sin(angle), -sin(theta)};
      const double t2[3] = {-sin(angle), cos(angle), 0};
      double a1[3], a2[3];
      mapped_tangent(s, X, t1, a1);
      mapped_tangent(s, X, t2, a2);
      const double C11 = dot(3, a1, a1), C22 = dot(3, a2, a2), C12 = dot(3, a1, a2);
      sum += 0.5 * (C11 + C22 + 1 / (C11 * C22 - C12 * C12) - 3) * sin(theta);
    }
  return sum * (pi / SLICES) * (2 * pi / SECTORS);
}

/* Relative errors of the energy at s = 0.15 and of the virtual work R . dx/ds, whose exact value is dE/ds. */
typedef struct {
  double energy, work;
} MappedError;

static MappedError mapped_error(int subdivisions, Interpolation interpolation) {
  const double s = 0.15, ds = 1e-4;
  Shell shell;
  open_shell(&shell, subdivisions, interpolation, NULL, no_law());
  double *x = zeros(shell.n), *R = zeros(shell.n), *w = zeros(shell.n);
  for (int i = 0; i < shell.n; i += 3) {
    mapped(s, &shell.mesh.X[i], &x[i]);
    mapped(1, &shell.mesh.X[i], &w[i]);
    for (int c = 0; c < 3; c++) w[i + c] -= shell.mesh.X[i + c];
  }
  must_force(&shell, x, R);
  const double slope = (exact_energy(s + ds) - exact_energy(s - ds)) / (2 * ds); /* to 1e-7 */
  const MappedError error = {.energy = fabs(membrane_energy(shell.membrane) / exact_energy(s) - 1),
                             .work = fabs(dot(shell.n, R, w) / slope - 1)};
  free(x);
  free(R);
  free(w);
  shell_close(&shell);
  return error;
}

/* The work is what moves the capsule; the energy is as good as the quadrature of either. */
START_TEST(virtual_work_of_a_smooth_map_is_far_nearer_to_the_exact_one) {
  for (int level = 2; level <= 3; level++) {
    const MappedError quadratic = mapped_error(level, INTERPOLATION_QUADRATIC),
                      quartic = mapped_error(level, INTERPOLATION_QUARTIC);
    ck_assert_double_lt(quartic.work, quadratic.work / 20); /* 160 and 40 times, measured */
    ck_assert_double_lt(quartic.energy, 2 * quadratic.energy);
  }
}
END_TEST

/* ---- any shape ---- */

START_TEST(the_gradient_of_the_energy_is_that_of_the_energy) {
  const Interpolation interpolations[] = {INTERPOLATION_QUADRATIC, INTERPOLATION_QUARTIC};
  for (int k = 0; k < 2; k++) {
    Shell shell;
    open_shell(&shell, 2, interpolations[k], NULL, no_law());
    double *x = zeros(shell.n), *moved = zeros(shell.n), *v = zeros(shell.n), *R = zeros(shell.n);
    uint64_t seed = 7;
    shell_crumple(&shell, 1.1, 0.01, 7, x);
    for (int i = 0; i < shell.n; i++) v[i] = random_uniform(&seed);
    must_force(&shell, x, R);
    membrane_energy_gradient(shell.membrane, x, R);
    const double power = dot(shell.n, R, v), step = 1e-5;
    double energy[2];
    for (int side = 0; side < 2; side++) {
      for (int i = 0; i < shell.n; i++) moved[i] = x[i] + (side ? step : -step) * v[i];
      must_force(&shell, moved, R);
      energy[side] = membrane_energy(shell.membrane);
    }
    /* The difference quotient is off by step^2 times third derivatives of order 1/h^2. */
    ck_assert_double_eq_tol(power, (energy[1] - energy[0]) / (2 * step), 1e-6 * fabs(power));
    free(x);
    free(moved);
    free(v);
    free(R);
    shell_close(&shell);
  }
}
END_TEST

START_TEST(a_rigid_motion_meets_no_force) {
  Shell shell;
  open_shell(&shell, 1, INTERPOLATION_QUARTIC, NULL, no_law());
  double *x = zeros(shell.n), *R = zeros(shell.n);
  const double F[3][3] = {{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}};
  shell_map(&shell, F, x);
  for (int i = 0; i < shell.n; i++) x[i] += 0.3 * (i % 3 + 1);
  must_force(&shell, x, R);
  ck_assert_double_lt(norm(shell.n, R), 1e-12); /* round-off of terms of order 1 */
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

START_TEST(the_force_has_no_resultant) {
  Shell shell;
  open_shell(&shell, 2, INTERPOLATION_QUARTIC, NULL, no_law());
  double *x = zeros(shell.n), *R = zeros(shell.n), sum[3] = {0, 0, 0};
  shell_crumple(&shell, 1.1, 0.01, 11, x);
  must_force(&shell, x, R);
  for (int i = 0; i < shell.n; i++) sum[i % 3] += R[i];
  for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(sum[c], 0, 1e-12 * norm(shell.n, R));
  free(x);
  free(R);
  shell_close(&shell);
}
END_TEST

START_TEST(one_element_of_each_orbit_gives_force_energy_and_gradient_of_all) {
  const double shear[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  const double F[3][3] = {{1.4, 0, 0.5}, {0, 0.9, 0}, {0.2, 0, 0.95}}; /* has the symmetry of the flow */
  Shell whole, part;
  Symmetry symmetry;
  Error error;
  open_shell(&whole, 2, INTERPOLATION_QUARTIC, NULL, marigo());
  ck_assert_int_eq(symmetry_find(&symmetry, &whole.mesh, whole.mesh.X, shear, &error), STATUS_OK);
  ck_assert_int_eq(symmetry.n_operations, 4);
  open_shell(&part, 2, INTERPOLATION_QUARTIC, &symmetry, marigo());
  double *x = zeros(whole.n), *R = zeros(whole.n), *R_part = zeros(whole.n);
  shell_map(&whole, F, x);
  must_force(&whole, x, R);
  must_force(&part, x, R_part);
  for (int i = 0; i < whole.n; i++) ck_assert_double_eq_tol(R_part[i], R[i], 1e-13 * norm(whole.n, R));
  ck_assert_double_eq_tol(membrane_energy(part.membrane), membrane_energy(whole.membrane), 1e-12);
  membrane_energy_gradient(whole.membrane, x, R);
  membrane_energy_gradient(part.membrane, x, R_part);
  for (int i = 0; i < whole.n; i++) ck_assert_double_eq_tol(R_part[i], R[i], 1e-13 * norm(whole.n, R));
  free(x);
  free(R);
  free(R_part);
  shell_close(&part);
  shell_close(&whole);
  symmetry_free(&symmetry);
}
END_TEST

START_TEST(an_icosahedron_that_was_not_halved_is_refused) {
  Shell shell = {0};
  Error error;
  ck_assert_int_eq(mesh_sphere(&shell.mesh, 0, NULL, &error), STATUS_OK);
  shell.material = make_material(scene_law("neo_hookean", NULL, 0), no_law());
  ck_assert_int_eq(membrane_new(&shell.membrane, &shell.mesh, NULL, &shell.material,
                                (MembraneMethod){.interpolation = INTERPOLATION_QUARTIC}, &error),
                   STATUS_INPUT);
  ck_assert_ptr_null(shell.membrane);
  ck_assert_ptr_nonnull(strstr(error.text, "at least 1, found 0"));
  shell_close(&shell);
}
END_TEST

int main(void) {
  return suite_run("quartic", (SuiteTests){virtual_work_of_a_smooth_map_is_far_nearer_to_the_exact_one,
                                           the_gradient_of_the_energy_is_that_of_the_energy,
                                           a_rigid_motion_meets_no_force, the_force_has_no_resultant,
                                           one_element_of_each_orbit_gives_force_energy_and_gradient_of_all,
                                           an_icosahedron_that_was_not_halved_is_refused, NULL});
}
