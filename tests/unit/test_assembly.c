/* A membrane and a capsule of which one element of each orbit is computed, against the whole ones. */
#include "coupling/stepper.h"
#include "membrane/assembly.h"

#include "capsule.h"
#include "suite.h"
#include <stdio.h>

static const double HYPERBOLIC[3][3] = {{1, 0, 0}, {0, 0, 0}, {0, 0, -1}};

/* A flow, and an affine shape that has its symmetry. */
typedef struct {
  const double (*gradient)[3];
  double F[3][3];
  int n_operations;
} Case;

static Case the_case(int k) {
  if (k == 0) return (Case){SIMPLE_SHEAR, {{1.3, 0, 0.3}, {0, 1.05, 0}, {0.1, 0, 0.9}}, 4};
  return (Case){HYPERBOLIC, {{1.4, 0, 0}, {0, 1.1, 0}, {0, 0, 0.8}}, 8};
}
enum { N_CASES = 2 };

static void shell_open_damaged_symmetric(Shell *shell, int subdivisions, const double gradient[3][3],
                                         MassSolver solver) {
  Error error;
  SceneParameter parameters[] = {number("Y_D", Y_D), number("Y_C", Y_C)};
  ck_assert_int_eq(mesh_sphere(&shell->mesh, subdivisions, NULL, &error), STATUS_OK);
  ck_assert_int_eq(symmetry_find(&shell->symmetry, &shell->mesh, shell->mesh.X, gradient, &error), STATUS_OK);
  shell_add_membrane(shell, scene_law("neo_hookean", NULL, 0), scene_law("marigo", parameters, 2), solver);
}

/* A shape of the case with symmetric noise. */
static void symmetric_shape(const Shell *shell, Case c, double scale, uint64_t seed, double *x) {
  double *noise = zeros(shell->n);
  shell_map(shell, (const double(*)[3])c.F, x);
  random_fill(&seed, shell->n, noise);
  for (int i = 0; i < shell->n; i++) x[i] = scale * x[i] + 0.004 * noise[i];
  symmetry_spread(&shell->symmetry, x);
  free(noise);
}

static double farthest(int n, const double *a, const double *b) {
  double most = 0;
  for (int i = 0; i < n; i++) most = fmax(most, fabs(a[i] - b[i]));
  return most;
}

/* Checks that two shells, one of them symmetric, give the same at x. */
static void check_same(Shell *whole, Shell *part, const double *x) {
  const int n = whole->n, nodes = whole->mesh.n_nodes;
  double *R = zeros(n), *R_part = zeros(n), *q = zeros(n), *q_part = zeros(n), *d = zeros(nodes),
         *d_part = zeros(nodes);
  must_force(whole, x, R);
  must_force(part, x, R_part);
  ck_assert_double_le(farthest(n, R, R_part), 1e-13 * norm(n, R));
  must_load(whole, R, q);
  must_load(part, R_part, q_part);
  ck_assert_double_le(farthest(n, q, q_part), 1e-9 * norm(n, q)); /* where the iterations stop */
  ck_assert_double_eq_tol(membrane_energy(part->membrane) / membrane_energy(whole->membrane), 1, 1e-13);
  ck_assert_double_eq_tol(membrane_dissipation(part->membrane), membrane_dissipation(whole->membrane), 1e-12);
  membrane_nodal_field(whole->membrane, membrane_trial(whole->membrane)->d, d);
  membrane_nodal_field(part->membrane, membrane_trial(part->membrane)->d, d_part);
  ck_assert_double_le(farthest(nodes, d, d_part), 1e-13);
  free(R);
  free(R_part);
  free(q);
  free(q_part);
  free(d);
  free(d_part);
}

START_TEST(one_element_of_each_orbit_gives_the_forces_loads_and_damage_of_all) {
  for (int k = 0; k < N_CASES; k++)
    for (int direct = 0; direct < 2; direct++) {
      const Case c = the_case(k);
      Shell whole, part;
      shell_open_damaged(&whole, 2);
      shell_open_damaged_symmetric(&part, 2, c.gradient, direct ? MASS_UMFPACK : MASS_PCG);
      ck_assert_int_eq(part.symmetry.n_operations, c.n_operations);
      const int share = membrane_points(whole.membrane) / c.n_operations; /* and those on the mirrors */
      ck_assert_int_ge(membrane_points(part.membrane), share);
      ck_assert_int_le(membrane_points(part.membrane), share * 3 / 2);
      double *x = zeros(whole.n);
      for (uint64_t seed = 1; seed <= 3; seed++) { /* growing, so that each adds damage */
        symmetric_shape(&part, c, 1 + 0.15 * (double)seed, seed, x);
        check_same(&whole, &part, x);
        membrane_commit(whole.membrane);
        membrane_commit(part.membrane);
      }
      free(x);
      shell_close(&whole);
      shell_close(&part);
    }
}
END_TEST

START_TEST(weights_of_the_points_cover_the_whole_surface) {
  for (int k = 0; k < N_CASES; k++) {
    Shell whole, part;
    shell_open_damaged(&whole, 2);
    shell_open_damaged_symmetric(&part, 2, the_case(k).gradient, MASS_PCG);
    double area[2] = {0};
    const MembranePoints all = membrane_points_view(whole.membrane),
                         some = membrane_points_view(part.membrane);
    for (int i = 0; i < membrane_points(whole.membrane); i++) area[0] += all.dS0[i];
    for (int i = 0; i < membrane_points(part.membrane); i++) area[1] += some.dS0[i];
    ck_assert_double_eq_tol(area[1] / area[0], 1, 1e-13);
    shell_close(&whole);
    shell_close(&part);
  }
}
END_TEST

START_TEST(the_forces_are_symmetric_to_the_last_bit) {
  for (int k = 0; k < N_CASES; k++) {
    Shell part;
    shell_open_damaged_symmetric(&part, 2, the_case(k).gradient, MASS_PCG);
    double *x = zeros(part.n), *R = zeros(part.n), *q = zeros(part.n);
    symmetric_shape(&part, the_case(k), 1.2, 1, x);
    must_force(&part, x, R);
    must_load(&part, R, q);
    for (int s = 0; s < part.symmetry.n_operations; s++) {
      const SymmetryOperation *S = &part.symmetry.operation[s];
      for (int p = 0; p < part.mesh.n_nodes; p++)
        for (int c = 0; c < 3; c++) {
          ck_assert_double_eq(R[3 * S->node[p] + c], S->sign[c] * R[3 * p + c]);
          ck_assert_double_eq(q[3 * S->node[p] + c], S->sign[c] * q[3 * p + c]);
        }
    }
    free(x);
    free(R);
    free(q);
    shell_close(&part);
  }
}
END_TEST

START_TEST(an_element_that_is_refused_is_named_by_its_number_in_the_mesh) {
  Shell part;
  shell_open_damaged_symmetric(&part, 2, SIMPLE_SHEAR, MASS_PCG);
  const int *computed = part.symmetry.elements.representative, orbit = part.symmetry.elements.n / 2;
  const int node = part.mesh.element[computed[orbit]][3];
  int first = part.symmetry.elements.n; /* of the computed elements that hold the node */
  for (int i = part.symmetry.elements.n - 1; i >= 0; i--)
    for (int p = 0; p < 6; p++)
      if (part.mesh.element[computed[i]][p] == node) first = i;
  ck_assert_int_gt(computed[first], first);
  double *x = zeros(part.n), *R = zeros(part.n);
  shell_inflate(&part, 1, x);
  x[3 * node] = NAN;
  Error error;
  ck_assert_int_eq(membrane_force(part.membrane, x, 0, 0, R, &error), STATUS_REJECT);
  int named = -1;
  ck_assert_int_eq(sscanf(error.text, "element %d", &named), 1);
  ck_assert_int_eq(named, computed[first]);
  free(x);
  free(R);
  shell_close(&part);
}
END_TEST

/* ---- the capsule in its flow ---- */

static void symmetric_capsule(Capsule *capsule, int subdivisions, const double gradient[3][3]) {
  shell_open_damaged_symmetric(&capsule->shell, subdivisions, gradient, MASS_PCG);
  capsule_immerse(capsule, gradient, 0.7, FLUID_REFERENCE, true);
  single_layer_use_symmetry(capsule->layer, &capsule->shell.symmetry);
  capsule->system.symmetry = &capsule->shell.symmetry;
}

START_TEST(the_velocity_is_that_of_the_whole_capsule) {
  for (int k = 0; k < N_CASES; k++) {
    const Case c = the_case(k);
    Capsule whole, part;
    shell_open_damaged(&whole.shell, 2);
    capsule_immerse(&whole, c.gradient, 0.7, FLUID_REFERENCE, true);
    symmetric_capsule(&part, 2, c.gradient);
    const int n = whole.shell.n;
    double *x = zeros(n), *v = zeros(n), *v_part = zeros(n);
    symmetric_shape(&part.shell, c, 1.1, 2, x);
    must_move(&whole, x, v);
    must_move(&part, x, v_part);
    /* The quadrature of an element is not that of its mirror image: 2e-6, the error of the method. */
    ck_assert_double_le(farthest(n, v, v_part), 1e-5);
    ck_assert_double_gt(norm(n, v), 1);
    free(x);
    free(v);
    free(v_part);
    capsule_close(&whole);
    capsule_close(&part);
  }
}
END_TEST

static Stepper started(Capsule *capsule) {
  const StepperOptions options = {.integrator = INTEGRATOR_RK2, .fixed_step = 0.05, .tolerance = 1e-3};
  Stepper s;
  Error error;
  ck_assert_int_eq(stepper_new(&s, system_rhs(&capsule->system), options, &error), STATUS_OK);
  ck_assert_int_eq(stepper_start(&s, 0, capsule->shell.mesh.X, &error), STATUS_OK);
  return s;
}

START_TEST(a_run_follows_that_of_the_whole_capsule) {
  Capsule whole, part;
  Error error;
  shell_open_damaged(&whole.shell, 1);
  capsule_immerse(&whole, SIMPLE_SHEAR, 0.7, FLUID_REFERENCE, true);
  symmetric_capsule(&part, 1, SIMPLE_SHEAR);
  Stepper a = started(&whole), b = started(&part);
  for (int step = 0; step < 40; step++) {
    ck_assert_int_eq(stepper_propose(&a, 2, NULL, &error), STATUS_OK);
    ck_assert_int_eq(stepper_propose(&b, 2, NULL, &error), STATUS_OK);
    stepper_accept(&a);
    stepper_accept(&b);
    membrane_commit(whole.shell.membrane);
    membrane_commit(part.shell.membrane);
  }
  double d_max[2] = {0};
  for (int k = 0; k < membrane_points(whole.shell.membrane); k++)
    d_max[0] = fmax(d_max[0], membrane_accepted(whole.shell.membrane)->d[k]);
  for (int k = 0; k < membrane_points(part.shell.membrane); k++)
    d_max[1] = fmax(d_max[1], membrane_accepted(part.shell.membrane)->d[k]);
  ck_assert_double_gt(d_max[0], 0.01);
  ck_assert_double_eq_tol(d_max[1], d_max[0], 1e-6); /* the same quadrature over the run: 1e-7 */
  ck_assert_double_le(farthest(whole.shell.n, a.x, b.x), 1e-6);
  stepper_free(&a);
  stepper_free(&b);
  capsule_close(&whole);
  capsule_close(&part);
}
END_TEST

int main(void) {
  return suite_run(
      "assembly",
      (SuiteTests){one_element_of_each_orbit_gives_the_forces_loads_and_damage_of_all,
                   weights_of_the_points_cover_the_whole_surface, the_forces_are_symmetric_to_the_last_bit,
                   an_element_that_is_refused_is_named_by_its_number_in_the_mesh,
                   the_velocity_is_that_of_the_whole_capsule, a_run_follows_that_of_the_whole_capsule, NULL});
}
