/* Curves of laws for pictures, against closed forms. */
#include "laws/curves.h"

#include "law_scene.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static const double G = 1.3;

static Material neo_hookean(SceneLaw damage) {
  static SceneParameter parameters[1];
  parameters[0] = number("G_s", G);
  return make_material(scene_law("neo_hookean", parameters, 1), damage);
}

/* A sheet of an incompressible neo-Hookean solid: Cauchy stress times thickness 1/(l1 l2). */
static double sheet_tension(double along, double across) {
  const double thickness = 1 / (along * across);
  return G * (along * along - thickness * thickness) * thickness;
}

START_TEST(tensions_of_a_neo_hookean_sheet_are_those_of_the_textbook) {
  Material material = neo_hookean(scene_law(NULL, NULL, 0));
  Error error;
  for (double along = 0.6; along < 2.5; along += 0.1) {
    const double across[N_STRETCHES] = {1 / sqrt(along), along, 1};
    for (int mode = 0; mode < N_STRETCHES; mode++) {
      double l[2], T[2];
      ck_assert_int_eq(curve_stretches(&material, (StretchMode)mode, along, l, &error), STATUS_OK);
      ck_assert_double_eq(l[0], along);
      ck_assert_double_eq_tol(l[1], across[mode], 1e-13);
      ck_assert_int_eq(curve_tensions(&material, l, T, &error), STATUS_OK);
      ck_assert_double_eq_tol(T[0], sheet_tension(along, across[mode]), 1e-12);
      ck_assert_double_eq_tol(T[1], sheet_tension(across[mode], along), 1e-12);
    }
  }
  material_free(&material);
}
END_TEST

/* Energy of the sheet in pure shear: G (l^2 + l^-2 - 2)/2. */
static double sheet_energy(double l) {
  return 0.5 * G * (l * l + 1 / (l * l) - 2);
}

START_TEST(damage_grows_under_load_stays_under_unloading_and_goes_on_where_it_stopped) {
  static const double Y_D = 0.1, Y_C = 3;
  enum { N = 7 };
  const double path[N] = {1.1, 1.5, 2, 1.5, 1, 2, 2.2};
  SceneParameter parameters[] = {number("Y_D", Y_D), number("Y_C", Y_C)};
  Material material = neo_hookean(scene_law("marigo", parameters, 2));
  DamageState state[N];
  Error error;
  double Ymax = 0;
  ck_assert_int_eq(curve_damage(&material, N, path, 1, state, &error), STATUS_OK);
  for (int k = 0; k < N; k++) {
    Ymax = fmax(Ymax, sheet_energy(path[k]));
    const double d = fmax(0, (Ymax - Y_D) / Y_C);
    ck_assert_double_eq_tol(state[k].d, d, 1e-14);
    ck_assert_double_eq_tol(state[k].threshold, Y_D + Y_C * d, 1e-12);
    ck_assert_double_eq_tol(state[k].tension, (1 - d) * sheet_tension(path[k], 1), 1e-13);
    ck_assert_double_eq_tol(state[k].channel[MLAW_Y], sheet_energy(path[k]), 1e-14);
  }
  material_free(&material);
}
END_TEST

/* At constant drive, d' = (1 - exp(-a <z - d>))/tau_c of the law `delay` stays below 1/tau_c. */
START_TEST(a_law_in_time_sees_the_time_that_the_path_takes) {
  enum { N = 200 };
  double path[N];
  SceneParameter parameters[] = {number("Y_D", 0.1), number("Y_C", 1), number("tau_c", 2)};
  Material material = neo_hookean(scene_law("delay", parameters, 3));
  DamageState slow[N], fast[N];
  Error error;
  for (int k = 0; k < N; k++) path[k] = 1 + 0.005 * k;
  ck_assert_int_eq(curve_damage(&material, N, path, 0.1, slow, &error), STATUS_OK);
  ck_assert_int_eq(curve_damage(&material, N, path, 10, fast, &error), STATUS_OK);
  ck_assert_double_gt(slow[N - 1].d, 0.1 / 2);
  ck_assert_double_le(fast[N - 1].d, 0.1 / 2); /* a tenth of a unit of time */
  ck_assert(isnan(slow[0].threshold));
  material_free(&material);
}
END_TEST

static int refuse_all(const mlaw_damage_args *a) {
  return mlaw_fail(a->err, MLAW_INTERNAL, -1, "never");
}

START_TEST(a_law_that_does_not_tell_its_threshold_is_named) {
  SceneParameter parameters[] = {number("Y_D", 0.1), number("Y_C", 3)};
  Material material = neo_hookean(scene_law("marigo", parameters, 2));
  mlaw_damage silent = *material.damage.damage;
  silent.threshold = refuse_all;
  material.damage.damage = &silent;
  const double path[] = {1.1};
  DamageState state[1];
  Error error;
  ck_assert_int_eq(curve_damage(&material, 1, path, 1, state, &error), STATUS_REJECT);
  ck_assert_msg(strstr(error.text, "law marigo: no threshold at d = ") && strstr(error.text, "(status -3)"),
                "%s", error.text);
  material_free(&material);
}
END_TEST

int main(void) {
  return suite_run("curves",
                   (SuiteTests){tensions_of_a_neo_hookean_sheet_are_those_of_the_textbook,
                                damage_grows_under_load_stays_under_unloading_and_goes_on_where_it_stopped,
                                a_law_in_time_sees_the_time_that_the_path_takes,
                                a_law_that_does_not_tell_its_threshold_is_named, NULL});
}
