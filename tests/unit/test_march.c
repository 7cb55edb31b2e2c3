/* Steps of an inflation, radius 1 + t, through the radius at which the membrane ruptures. */
#include "run/march.h"

#include "suite.h"
#include "voyage.h"
#include <math.h>

#define SCENE(at_rupture)                                                                                    \
  "schema: 1\n"                                                                                              \
  "capsule: {mesh: {subdivisions: 0}}\n"                                                                     \
  "membrane:\n"                                                                                              \
  "  law: neo_hookean\n  check_laws: false\n"                                                                \
  "  damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: 2.0}}\n"                                              \
  "flow: {kind: inflation, path: [[0, 0], [1, 1]]}\n"                                                        \
  "time: {end: 1}\n"                                                                                         \
  "stop: {rupture: " at_rupture "}\n"

/* Root of Y = (2 l^2 + l^-4 - 3)/2 = Y_D + Y_C at l = 1 + t. */
static const double RUPTURE = 0.9138259926;
/* Events are located to 1e-6 of a step, which is 0.1 long at most. */
static const double RESOLUTION = 1e-7;

/* Steps until rupture is told or the end is reached; which of them it was. */
static bool march(Voyage *v) {
  Log log = {.quiet = true};
  Error error;
  bool ruptured = false;
  while (!ruptured && v->simulation.motion->t < v->scene.time.end) {
    ck_assert_int_eq(march_propose(&v->record, v->scene.time.end, &log, &ruptured, &error), STATUS_OK);
    ck_assert_int_eq(march_accept(&v->record, &error), STATUS_OK);
  }
  return ruptured;
}

START_TEST(a_run_stops_at_the_instant_of_rupture_and_not_at_the_end_of_its_step) {
  Voyage v;
  voyage_open(&v, SCENE("stop"));
  ck_assert(march(&v));
  ck_assert_double_eq_tol(v.record.data.t_l, RUPTURE, RESOLUTION);
  ck_assert_double_eq(v.simulation.motion->t, v.record.data.t_l);
  ck_assert_double_eq(v.record.t1, v.record.data.t_l);
  /* dd/dt = (2 l - 2 l^-5) / Y_C = 1.9 */
  const double d = membrane_release_accepted(v.simulation.membrane).d[0];
  ck_assert_double_eq_tol(d, 1, 2 * RESOLUTION);
  voyage_close(&v);
}
END_TEST

START_TEST(a_run_that_is_to_go_on_notes_the_instant_and_does) {
  Voyage v;
  voyage_open(&v, SCENE("continue"));
  ck_assert(!march(&v));
  ck_assert_double_eq_tol(v.record.data.t_l, RUPTURE, RESOLUTION);
  ck_assert_double_eq(v.simulation.motion->t, 1);
  voyage_close(&v);
}
END_TEST

int main(void) {
  return suite_run("march", (SuiteTests){a_run_stops_at_the_instant_of_rupture_and_not_at_the_end_of_its_step,
                                         a_run_that_is_to_go_on_notes_the_instant_and_does, NULL});
}
