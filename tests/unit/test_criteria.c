/* Criteria along an inflation, where every drive is known: Y, tension and area of a sphere of radius
 * 1 + alpha, with alpha = t. */
#include "run/criteria.h"

#include "run/record.h"
#include "suite.h"
#include "voyage.h"
#include <math.h>
#include <string.h>

#define SCENE                                                                                                \
  "schema: 1\n"                                                                                              \
  "capsule: {mesh: {subdivisions: 1}}\n"                                                                     \
  "membrane:\n"                                                                                              \
  "  law: neo_hookean\n"                                                                                     \
  "  damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: 2.0}}\n"                                              \
  "flow: {kind: inflation, path: [[0, 0], [1, 1]]}\n"                                                        \
  "time: {end: 1}\n"                                                                                         \
  "stop: {rupture: continue}\n"
#define CRITERIA                                                                                             \
  "observe:\n"                                                                                               \
  "  criteria:\n"                                                                                            \
  "    - {law: marigo, parameters: {Y_D: 0.2, Y_C: 2.0}}\n"                                                  \
  "    - {name: area, law: area_dilation, parameters: {alpha_D: 0.2, alpha_C: 1.05}}\n"                      \
  "    - {name: tension, law: rankine, parameters: {T_D: 0.5, T_C: 0.25}}\n"                                 \
  "    - {name: never, law: max_stretch, parameters: {L_D: 2.5, L_C: 1}}\n"

static void sail(Voyage *v) {
  Motion *motion = v->simulation.motion;
  Error error;
  double t1;
  while (motion->t < v->scene.time.end) {
    ck_assert_int_eq(motion->propose(motion, v->scene.time.end, &t1, NULL, &error), STATUS_OK);
    ck_assert_int_eq(record_step(&v->record, t1, &error), STATUS_OK);
    ck_assert_int_eq(record_events(&v->record, &error), STATUS_OK);
    ck_assert_int_eq(record_advance(&v->record, &error), STATUS_OK);
    motion->accept(motion);
    membrane_commit(v->simulation.membrane);
  }
}

/* Events are located to 1e-6 of a step, which is 0.05 long. */
static const double RESOLUTION = 1e-7;

START_TEST(an_inflation_is_judged_at_the_exact_radii) {
  Voyage v;
  Error error;
  Verdict verdict[4];
  voyage_open(&v, SCENE CRITERIA);
  sail(&v);
  ck_assert_int_eq(record_probe(&v.record, v.simulation.motion->t, &error), STATUS_OK);
  ck_assert_int_eq(criteria_verdicts(&v.record, verdict, &error), STATUS_OK);
  /* t_c, t_l: roots of Y = (2 l^2 + l^-4 - 3)/2 = 0.2, 2.2; l^2 - 1 = 0.2, 1.25; T = 1 - l^-6 = 0.5, 0.75 */
  const double expected[3][2] = {
      {0.2116009, 0.9138260}, {sqrt(1.2) - 1, 0.5}, {pow(2, 1.0 / 6) - 1, pow(4, 1.0 / 6) - 1}};
  for (int i = 0; i < 3; i++) {
    ck_assert_double_eq_tol(verdict[i].finding.t_c, expected[i][0], RESOLUTION);
    ck_assert_double_eq_tol(verdict[i].finding.t_l, expected[i][1], RESOLUTION);
    ck_assert_double_eq_tol(verdict[i].finding.t, expected[i][1], RESOLUTION);
    ck_assert_double_eq_tol(verdict[i].finding.damaged_area_fraction, 1, 1e-15);
  }
  ck_assert_str_eq(verdict[0].name, "marigo");
  ck_assert_str_eq(verdict[1].law, "area_dilation");
  ck_assert_double_eq_tol(verdict[1].finding.thickness_min, 1 / 2.25, 1e-6); /* radius 1.5 */
  ck_assert(isnan(verdict[3].finding.t_c) && isnan(verdict[3].finding.t_l));
  ck_assert_double_eq(verdict[3].finding.d_max, 0);
  ck_assert_double_eq_tol(verdict[3].finding.thickness_min, 0.25, 1e-14); /* at the end, radius 2 */
  voyage_close(&v);
}
END_TEST

START_TEST(the_law_of_the_membrane_judges_as_the_membrane_behaves) {
  Voyage v;
  voyage_open(&v, SCENE CRITERIA);
  sail(&v);
  const Finding *same = &v.record.criteria.finding[0];
  ck_assert_double_eq_tol(same->t_c, v.record.data.t_c, RESOLUTION);
  ck_assert_double_eq_tol(same->t_l, v.record.data.t_l, RESOLUTION);
  voyage_close(&v);
}
END_TEST

START_TEST(a_membrane_that_starts_inflated_is_judged_from_there) {
  Voyage v;
  voyage_open(&v, "schema: 1\ncapsule: {mesh: {subdivisions: 0}}\nmembrane: {law: neo_hookean}\n"
                  "flow: {kind: inflation, path: [[0, 0.5], [1, 0]]}\ntime: {end: 1}\n"
                  "observe: {criteria: [{law: area_dilation, parameters: {alpha_D: 1, alpha_C: 1}}]}\n");
  ck_assert_double_eq_tol(v.record.criteria.observers.history0[0].d[0], 0.25, 1e-12); /* 1.5^2 - 2 */
  voyage_close(&v);
}
END_TEST

START_TEST(nothing_is_set_up_for_a_scene_without_criteria) {
  Voyage v;
  voyage_open(&v, SCENE);
  ck_assert_uint_eq(v.record.criteria.observers.n, 0);
  ck_assert_ptr_null(v.record.criteria.observers.accepted);
  ck_assert_ptr_null(v.simulation.criterion);
  voyage_close(&v);
}
END_TEST

START_TEST(an_unknown_law_is_refused_at_its_place) {
  static const char text[] = SCENE "observe: {criteria: [{law: marigoo}]}\n";
  Scene scene;
  Simulation simulation;
  Error error;
  setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1);
  ck_assert_int_eq(scene_read_text(&scene, "scene.yaml", text, strlen(text), NULL, 0, &error), STATUS_OK);
  ck_assert_int_eq(simulation_new(&simulation, &scene, NULL, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "scene.yaml:9:28: "));
  ck_assert_ptr_nonnull(strstr(error.text, "did you mean `marigo`"));
  scene_free(&scene);
}
END_TEST

static int n_collapsed; /* nodes */
static void collapse(const Motion *motion, double t, double *x, double *v) {
  (void)motion;
  (void)t;
  for (int k = 0; k < 3 * n_collapsed; k++) x[k] = v[k] = 0;
}

START_TEST(a_state_inside_a_step_that_cannot_be_is_told_with_the_step) {
  Voyage v;
  Error error;
  double t1;
  voyage_open(&v, SCENE);
  Motion *motion = v.simulation.motion;
  ck_assert_int_eq(motion->propose(motion, v.scene.time.end, &t1, NULL, &error), STATUS_OK);
  ck_assert_int_eq(record_step(&v.record, t1, &error), STATUS_OK);
  n_collapsed = v.simulation.mesh.n_nodes;
  motion->at = collapse;
  ck_assert_int_eq(record_probe(&v.record, 0.5 * t1, &error), STATUS_FAILED);
  ck_assert_msg(strncmp(error.text, "inside the step from t = 0 to ", 30) == 0, "%s", error.text);
  voyage_close(&v);
}
END_TEST

int main(void) {
  return suite_run("criteria",
                   (SuiteTests){an_inflation_is_judged_at_the_exact_radii,
                                the_law_of_the_membrane_judges_as_the_membrane_behaves,
                                a_membrane_that_starts_inflated_is_judged_from_there,
                                nothing_is_set_up_for_a_scene_without_criteria,
                                an_unknown_law_is_refused_at_its_place,
                                a_state_inside_a_step_that_cannot_be_is_told_with_the_step, NULL});
}
