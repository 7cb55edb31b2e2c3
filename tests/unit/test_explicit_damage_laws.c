/* The damage laws of plugins/damage that are functions of the largest Y (power, exponential, bundles of
 * fibres), through their shared objects and the host: onset, evolution against closed forms and tables. */
#include "damage_point.h"
#include "random.h"
#include "suite.h"

static DamagePoint driven_by_Y(const char *law, const char *third, double value) {
  SceneParameter parameters[] = {number("Y_D", 0.2), number("Y_C", 2.0), number(third, value)};
  return damage_point(law, parameters, third[0] ? 3 : 2);
}

/* d after a monotone loading to Y. */
static double damage_at(const DamagePoint *sound, double Y) {
  DamagePoint point = *sound;
  return damage_drive(&point, MLAW_Y, Y, 0.1);
}

START_TEST(power_hardening_follows_its_closed_form) {
  for (double m = 0.25; m <= 4.0; m *= 2.0) {
    DamagePoint point = driven_by_Y("power", "m", m);
    ck_assert_double_eq(damage_at(&point, 0.2), 0.0);
    for (int i = 1; i < 20; i++) { /* kappa(d) = Y_D + Y_C d^m */
      const double d = 0.05 * i;
      ck_assert_double_eq_tol(damage_at(&point, 0.2 + 2.0 * pow(d, m)), d, 1e-13);
    }
    ck_assert_double_eq(damage_at(&point, 2.2), 1.0);
    ck_assert_double_eq(damage_at(&point, 1e300), 1.0);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(power_hardening_of_exponent_one_is_marigo) {
  DamagePoint power = driven_by_Y("power", "m", 1.0), marigo = driven_by_Y("marigo", "", 0.0);
  for (double Y = 0.0; Y < 3.0; Y += 0.01) ck_assert_double_eq(damage_at(&power, Y), damage_at(&marigo, Y));
  material_free(&power.material);
  material_free(&marigo.material);
}
END_TEST

START_TEST(exponential_damage_follows_its_closed_form_and_stays_below_its_limit) {
  for (double d_inf = 0.25; d_inf <= 1.0; d_inf += 0.25) {
    DamagePoint point = driven_by_Y("exponential", "d_inf", d_inf);
    ck_assert_double_eq(damage_at(&point, 0.2), 0.0);
    for (int i = 1; i < 20; i++) { /* kappa(d) = Y_D - Y_C ln(1 - d/d_inf) */
      const double part = 0.05 * i;
      ck_assert_double_eq_tol(damage_at(&point, 0.2 - 2.0 * log(1.0 - part)), part * d_inf, 1e-14);
    }
    ck_assert_double_eq(damage_at(&point, 1e300), d_inf);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(a_bundle_of_uniform_strength_is_marigo_to_the_bit) {
  uint64_t state = 61;
  for (int k = 0; k < 50; k++) {
    SceneParameter parameters[] = {number("Y_D", 0.5 + 0.5 * random_uniform(&state)),
                                   number("Y_C", k ? 2.0 + 1.9 * random_uniform(&state) : 0.0)};
    DamagePoint bundle = damage_point("fibre_bundle", parameters, 2),
                marigo = damage_point("marigo", parameters, 2);
    for (int i = 0; i < 200; i++) {
      const double Y = 2.5 + 2.5 * random_uniform(&state);
      ck_assert_double_eq(damage_at(&bundle, Y), damage_at(&marigo, Y));
    }
    material_free(&bundle.material);
    material_free(&marigo.material);
  }
}
END_TEST

START_TEST(a_bundle_of_weibull_strength_has_the_shares_of_its_distribution) {
  for (double m = 0.5; m < 20.0; m *= 2.0) {
    SceneParameter parameters[] = {number("Y_D", 0.1), number("Y_0", 0.4), number("m", m)};
    DamagePoint point = damage_point("fibre_weibull", parameters, 3);
    ck_assert_double_eq(damage_at(&point, 0.1), 0.0);
    for (int i = 1; i < 20; i++) { /* the quantile: x = (-ln(1 - P))^(1/m) */
      const double share = 0.05 * i, x = pow(-log(1.0 - share), 1.0 / m);
      ck_assert_double_eq_tol(damage_at(&point, 0.1 + 0.4 * x), share, 1e-13);
    }
    ck_assert_double_eq(damage_at(&point, 1e300), 1.0);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(a_bundle_of_log_normal_strength_has_the_shares_of_the_normal_table) {
  static const double table[][2] = {{-3.0, 0.001349898031630095}, {-2.0, 0.022750131948179207},
                                    {-1.0, 0.15865525393145705},  {0.0, 0.5},
                                    {1.0, 0.8413447460685429},    {2.0, 0.9772498680518208}};
  SceneParameter parameters[] = {number("Y_D", 0.1), number("Y_50", 0.6), number("s", 0.3)};
  DamagePoint point = damage_point("fibre_log_normal", parameters, 3);
  ck_assert_double_eq(damage_at(&point, 0.1), 0.0);
  for (int k = 0; k < 6; k++)
    ck_assert_double_eq_tol(damage_at(&point, 0.1 + 0.6 * exp(0.3 * table[k][0])), table[k][1], 1e-15);
  ck_assert_double_eq(damage_at(&point, 1e300), 1.0);
  material_free(&point.material);
}
END_TEST

START_TEST(at_the_critical_damage_the_rest_breaks_at_once) {
  const double d_c = 0.6, share[] = {d_c - 1e-6, d_c + 1e-6}; /* and the Y of these shares: */
  const double exponential[] = {-log(1.0 - share[0]), -log(1.0 - share[1])};
  const double weibull[] = {sqrt(exponential[0]), sqrt(exponential[1])};
  const double log_normal = 0.2533471031357997; /* normal quantile of 0.6 */
  SceneParameter e[] = {number("Y_D", 0.0), number("Y_C", 1.0), number("d_c", d_c)};
  SceneParameter w[] = {number("Y_0", 1.0), number("m", 2.0), number("d_c", d_c)};
  SceneParameter l[] = {number("Y_50", 1.0), number("s", 1.0), number("d_c", d_c)};
  DamagePoint points[] = {damage_point("exponential", e, 3), damage_point("fibre_weibull", w, 3),
                          damage_point("fibre_log_normal", l, 3)};
  const double Y[][2] = {{exponential[0], exponential[1]},
                         {weibull[0], weibull[1]},
                         {exp(log_normal - 1e-5), exp(log_normal + 1e-5)}};
  for (int k = 0; k < 3; k++) {
    ck_assert_double_eq_tol(damage_at(&points[k], Y[k][0]), d_c, 1e-5);
    ck_assert_double_eq(damage_at(&points[k], Y[k][1]), 1.0);
    material_free(&points[k].material);
  }
}
END_TEST

static DamagePoint quartiles(const double Y[5]) {
  SceneParameter parameters[] = {number("Y_0", Y[0]), number("Y_25", Y[1]), number("Y_50", Y[2]),
                                 number("Y_75", Y[3]), number("Y_100", Y[4])};
  return damage_point("fibre_quartiles", parameters, 5);
}

START_TEST(a_bundle_known_by_quartiles_interpolates_between_them) {
  DamagePoint point = quartiles((const double[]){0.1, 0.3, 0.4, 0.8, 2.0});
  static const double expected[][2] = {{0.1, 0.0},   {0.2, 0.125}, {0.3, 0.25},  {0.35, 0.375}, {0.4, 0.5},
                                       {0.6, 0.625}, {0.8, 0.75},  {1.4, 0.875}, {2.0, 1.0},    {9.0, 1.0}};
  for (int k = 0; k < 10; k++)
    ck_assert_double_eq_tol(damage_at(&point, expected[k][0]), expected[k][1], 1e-15);
  material_free(&point.material);

  DamagePoint even = quartiles((const double[]){0.2, 0.7, 1.2, 1.7, 2.2}),
              marigo = driven_by_Y("marigo", "", 0.0),
              jump = quartiles((const double[]){0, 0.5, 0.5, 0.5, 1});
  for (double Y = 0.0; Y < 3.0; Y += 0.01)
    ck_assert_double_eq_tol(damage_at(&even, Y), damage_at(&marigo, Y), 1e-15);
  ck_assert_double_eq(damage_at(&jump, 0.5), 0.25);
  ck_assert_double_eq_tol(damage_at(&jump, 0.5 + 1e-12), 0.75, 1e-11);
  material_free(&even.material);
  material_free(&marigo.material);
  material_free(&jump.material);
}
END_TEST

START_TEST(quartiles_out_of_order_are_refused) {
  Error error;
  Material material;
  SceneParameter parameters[] = {number("Y_0", 0.1), number("Y_25", 0.3), number("Y_50", 0.2),
                                 number("Y_75", 0.5), number("Y_100", 1.0)};
  const SceneLaw elastic = scene_law("neo_hookean", NULL, 0);
  ck_assert_int_eq(try_material(&material, elastic, scene_law("fibre_quartiles", parameters, 5), &error),
                   STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "Y_0 <= Y_25 <= Y_50"));
}
END_TEST

/* f, zeta and dzeta of an explicit law at (Y, d), straight from the law. */
typedef struct {
  double f, zeta, dzeta;
} Explicit;

static Explicit call(const DamagePoint *point, double Y, double d) {
  const mlaw_damage *law = point->material.damage.damage;
  const double *chan[MLAW_N_CHANNELS] = {[MLAW_Y] = &Y};
  Explicit e;
  mlaw_error err;
  const mlaw_damage_args args = {.size = sizeof args,
                                 .n_channels = MLAW_N_CHANNELS,
                                 .n = 1,
                                 .ld = 1,
                                 .param = point->material.damage_field,
                                 .chan = chan,
                                 .d0 = &d,
                                 .f = &e.f,
                                 .zeta = &e.zeta,
                                 .dzeta = &e.dzeta,
                                 .err = &err};
  ck_assert_int_eq(law->threshold(&args), MLAW_OK);
  ck_assert_int_eq(law->evolution(&args), MLAW_OK);
  return e;
}

static void check_explicit(DamagePoint point, double Y_start) {
  ck_assert_double_le(call(&point, 0.0, 0.0).f, 0.0);
  for (int i = 1; i < 40; i++) {
    const double Y = Y_start + 0.04 * i + 0.011, h = 1e-4;
    const Explicit at = call(&point, Y, 0.0), plus = call(&point, Y + h, 0.0),
                   minus = call(&point, Y - h, 0.0), half_plus = call(&point, Y + 0.5 * h, 0.0),
                   half_minus = call(&point, Y - 0.5 * h, 0.0);
    const double slope =
        (4.0 * (half_plus.zeta - half_minus.zeta) / h - (plus.zeta - minus.zeta) / (2.0 * h)) / 3.0;
    ck_assert_double_eq_tol(at.dzeta, slope, 1e-8 * (1.0 + fabs(slope)));
    ck_assert_double_eq_tol(call(&point, Y, at.zeta).f, 0.0, 1e-14);
    ck_assert_double_lt(call(&point, Y, at.zeta + 0.01).f, 0.0);
    if (at.zeta > 0.01) ck_assert_double_gt(call(&point, Y, at.zeta - 0.01).f, 0.0);
  }
  material_free(&point.material);
}

START_TEST(threshold_and_evolution_are_inverses_and_slopes_agree_with_differences) {
  SceneParameter weibull[] = {number("Y_0", 0.9), number("m", 2.5)};
  SceneParameter log_normal[] = {number("Y_50", 0.9), number("s", 0.5)};
  check_explicit(driven_by_Y("power", "m", 1.7), 0.2);
  check_explicit(driven_by_Y("power", "m", 0.6), 0.2);
  check_explicit(driven_by_Y("exponential", "d_inf", 0.9), 0.2);
  check_explicit(driven_by_Y("fibre_bundle", "", 0.0), 0.2);
  check_explicit(damage_point("fibre_weibull", weibull, 2), 0.0);
  check_explicit(damage_point("fibre_log_normal", log_normal, 2), 0.0);
  check_explicit(quartiles((const double[]){0.1, 0.33, 0.47, 0.86, 2.0}), 0.1);
}
END_TEST

int main(void) {
  return suite_run(
      "explicit damage laws",
      (SuiteTests){power_hardening_follows_its_closed_form, power_hardening_of_exponent_one_is_marigo,
                   exponential_damage_follows_its_closed_form_and_stays_below_its_limit,
                   a_bundle_of_uniform_strength_is_marigo_to_the_bit,
                   a_bundle_of_weibull_strength_has_the_shares_of_its_distribution,
                   a_bundle_of_log_normal_strength_has_the_shares_of_the_normal_table,
                   at_the_critical_damage_the_rest_breaks_at_once,
                   a_bundle_known_by_quartiles_interpolates_between_them, quartiles_out_of_order_are_refused,
                   threshold_and_evolution_are_inverses_and_slopes_agree_with_differences, NULL});
}
