/* What is read off a damage law, against its formula. */
#include "law_scene.h"
#include "study/onset.h"
#include "suite.h"
#include <math.h>
#include <stdint.h>

static Material material(const char *law, SceneParameter *parameters, size_t n) {
  SceneParameter G_s[] = {number("G_s", 1)};
  return make_material(scene_law("neo_hookean", G_s, 1), scene_law(law, parameters, n));
}

START_TEST(marigo_begins_at_Y_D_and_gives_way_at_its_largest_tension) {
  static const double table[][2] = {{0.2, 2}, {0.05, 1}, {0.4, 3}, {5e-4, 3.1e-3}};
  for (int k = 0; k < 4; k++) {
    const double Y_D = table[k][0], Y_C = table[k][1];
    SceneParameter parameters[] = {number("Y_D", Y_D), number("Y_C", Y_C)};
    Material m = material("marigo", parameters, 2);
    bool known;
    DamageOnset onset;
    Error error;
    ck_assert_int_eq(damage_onset(&m, &known, &onset, &error), STATUS_OK);
    ck_assert(known);
    ck_assert_double_eq_tol(onset.onset, Y_D, 1e-12 * Y_D);
    const double severity = 4 * pow(Y_D + Y_C, 3) / (27 * Y_C * Y_C);
    ck_assert_double_eq_tol(onset.severity, severity, 1e-4 * severity); /* a scan of 400 values */
    material_free(&m);
  }
}
END_TEST

START_TEST(a_brittle_law_gives_way_where_it_begins) {
  SceneParameter parameters[] = {number("Y_D", 0.3), number("Y_C", 0)};
  Material m = material("marigo", parameters, 2);
  bool known;
  DamageOnset onset;
  Error error;
  ck_assert_int_eq(damage_onset(&m, &known, &onset, &error), STATUS_OK);
  ck_assert(known);
  ck_assert_double_eq_tol(onset.onset, 0.3, 1e-12);
  ck_assert_double_eq_tol(onset.severity, 0.3, 1e-6);
  material_free(&m);
}
END_TEST

START_TEST(a_law_with_another_drive_or_none_is_not_known) {
  SceneParameter parameters[] = {number("T_D", 1.5), number("T_C", 1)};
  bool known = true;
  DamageOnset onset;
  Error error;
  Material m = material("rankine", parameters, 2);
  ck_assert_int_eq(damage_onset(&m, &known, &onset, &error), STATUS_OK);
  ck_assert(!known);
  material_free(&m);
  SceneParameter G_s[] = {number("G_s", 1)};
  m = make_material(scene_law("neo_hookean", G_s, 1), scene_law(NULL, NULL, 0));
  known = true;
  ck_assert_int_eq(damage_onset(&m, &known, &onset, &error), STATUS_OK);
  ck_assert(!known);
  material_free(&m);
}
END_TEST

int main(void) {
  return suite_run("onset", (SuiteTests){marigo_begins_at_Y_D_and_gives_way_at_its_largest_tension,
                                         a_brittle_law_gives_way_where_it_begins,
                                         a_law_with_another_drive_or_none_is_not_known, NULL});
}
