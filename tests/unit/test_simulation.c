/* What a scene becomes before its first step: the symmetries that are left to use, and the state that it
 * starts from. */
#include "run/simulation.h"

#include "suite.h"
#include <math.h>
#include <string.h>

/* Simple shear of an icosahedron: four symmetries, as long as nothing else breaks them. */
#define SHEAR                                                                                                \
  "schema: 1\ncapsule: {mesh: {subdivisions: 0}}\nflow: {kind: simple_shear, capillary_number: 0.5}\n"
#define END "time: {end: 1}\n"
/* Around P, on the vorticity axis, which only the identity and the half turn about it keep in place. */
#define SPOT        "{around: P, radius: 0.7, inside: 0.5, outside: 1}"
#define SPOT_BESIDE "{around: [0.6, 0.8, 0], radius: 0.7, inside: 0.5, outside: 1}"

typedef struct {
  Scene scene;
  Simulation simulation;
} Voyage;

static void voyage_open(Voyage *v, const char *text) {
  Error error;
  setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1);
  ck_assert_int_eq(scene_read_text(&v->scene, "scene.yaml", text, strlen(text), NULL, 0, &error), STATUS_OK);
  const Status status = simulation_new(&v->simulation, &v->scene, NULL, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
}

static void voyage_close(Voyage *v) {
  simulation_free(&v->simulation);
  scene_free(&v->scene);
}

static bool is_told(const Simulation *s, const char *words) {
  for (size_t i = 0; i < s->n_skipped; i++)
    if (strstr(s->skipped[i], words)) return true;
  return false;
}

/* The scene has so many symmetries left, and says this (or, with NULL, nothing) of those that it lost. */
static void expect_symmetries(const char *text, int n_operations, const char *words) {
  Voyage v;
  voyage_open(&v, text);
  ck_assert_int_eq(v.simulation.symmetry.n_operations, n_operations);
  ck_assert(is_told(&v.simulation, words ? words : "symmetries of mesh and flow") == (words != NULL));
  voyage_close(&v);
}

START_TEST(numbers_keep_all_symmetries) {
  expect_symmetries(SHEAR END "membrane: {check_laws: false, law: neo_hookean, parameters: {G_s: 0.5}}\n", 4,
                    NULL);
}
END_TEST

START_TEST(values_of_the_elastic_law_leave_only_the_symmetries_that_they_have) {
  expect_symmetries(
      SHEAR END "membrane: {check_laws: false, law: neo_hookean, parameters: {G_s: " SPOT "}}\n", 2,
      "2 of 4 symmetries of mesh and flow: the values of G_s of law neo_hookean do not have them");
  expect_symmetries(
      SHEAR END "membrane: {check_laws: false, law: neo_hookean, parameters: {G_s: " SPOT_BESIDE "}}\n", 1,
      "3 of 4 symmetries of mesh and flow: the values of G_s of law neo_hookean do not have them");
}
END_TEST

START_TEST(values_of_the_damage_law_do_too) {
  expect_symmetries(SHEAR END "membrane: {check_laws: false, law: neo_hookean, damage: {law: marigo, "
                              "parameters: {Y_D: 0.2, Y_C: " SPOT "}}}\n",
                    2,
                    "2 of 4 symmetries of mesh and flow: the values of Y_C of law marigo do not have them");
}
END_TEST

START_TEST(values_of_a_law_that_looks_on_do_too) {
  expect_symmetries(SHEAR END "membrane: {check_laws: false, law: neo_hookean}\n"
                              "observe: {criteria: [{law: rankine, parameters: {T_D: " SPOT ", T_C: 1}}]}\n",
                    2,
                    "2 of 4 symmetries of mesh and flow: the values of T_D of law rankine do not have them");
}
END_TEST

/* Inflated by 30 %: Y = (2 1.3^2 + 1.3^-4 - 3)/2 everywhere, and d = (Y - Y_D)/Y_C. */
START_TEST(what_the_start_itself_damages_is_accepted_before_the_first_step) {
  Voyage v;
  Error error;
  voyage_open(&v, SHEAR END "membrane: {check_laws: false, law: neo_hookean, damage: {law: marigo, "
                            "parameters: {Y_D: 0.2, Y_C: 2}}}\n"
                            "start: {axes: [1.3, 1.3, 1.3]}\n");
  ck_assert_int_eq(simulation_start(&v.simulation, &error), STATUS_OK);
  const Membrane *membrane = v.simulation.membrane;
  const double Y = (2 * 1.69 + pow(1.3, -4) - 3) / 2;
  const double *d = membrane_release_accepted(membrane).d;
  for (int k = 0; k < membrane_points(membrane); k++) ck_assert_double_eq_tol(d[k], (Y - 0.2) / 2, 1e-13);
  voyage_close(&v);
}
END_TEST

int main(void) {
  return suite_run("simulation",
                   (SuiteTests){numbers_keep_all_symmetries,
                                values_of_the_elastic_law_leave_only_the_symmetries_that_they_have,
                                values_of_the_damage_law_do_too, values_of_a_law_that_looks_on_do_too,
                                what_the_start_itself_damages_is_accepted_before_the_first_step, NULL});
}
