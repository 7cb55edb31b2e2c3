/* What the host makes of laws: values against closed forms, and everything that the host owns
 * (irreversibility, caps, refusals of what is not finite). */
#include "base/array.h"
#include "law_scene.h"
#include "laws/material.h"
#include "suite.h"
#include <math.h>
#include <string.h>

enum { N = 40 };
static const SceneLaw NONE = {0};

/* Rounding of a few operations on numbers of order 10. */
static const double ROUNDING = 1e-13;

static Material neo_hookean(void) {
  return make_material(scene_law("neo_hookean", NULL, 0), NONE);
}

static Material neo_hookean_with_damage(double Y_D, double Y_C) {
  SceneParameter parameters[] = {number("Y_D", Y_D), number("Y_C", Y_C)};
  return make_material(scene_law("neo_hookean", NULL, 0), scene_law("marigo", parameters, 2));
}

/* T1 (principal Cauchy tension of the undamaged membrane) and phi at principal stretches l1, l2. */
static double tension(const Material *material, double l1, double l2, double *phi) {
  Error error;
  double I1 = l1 * l1 + l2 * l2 - 2.0, I2 = l1 * l1 * l2 * l2 - 1.0, dphi[2];
  const ElasticBatch batch = {.n = 1, .ld = 1, .I1 = &I1, .I2 = &I2, .phi = phi, .dphi = dphi};
  ck_assert_int_eq(material_elastic(material, &batch, NULL, &error), STATUS_OK);
  return 2.0 * (l1 / l2) * (dphi[0] + l2 * l2 * dphi[1]);
}

START_TEST(inflated_neo_hookean_membrane_has_the_tension_and_energy_of_the_paper) {
  Material material = neo_hookean();
  for (double l = 1.0; l < 3.0; l += 0.1) { /* equations 4.1 and 4.2 */
    double phi, T = tension(&material, l, l, &phi);
    ck_assert_double_eq_tol(T, 1.0 - pow(l, -6.0), ROUNDING);
    ck_assert_double_eq_tol(phi, (2.0 * l * l + pow(l, -4.0) - 3.0) / 2.0, ROUNDING);
  }
  material_free(&material);
}
END_TEST

START_TEST(stretched_neo_hookean_membrane_has_the_tension_of_the_paper) {
  Material material = neo_hookean();
  for (double l1 = 0.7; l1 < 2.0; l1 += 0.1) { /* equation 2.19, principal: T1 = l1/l2 - 1/(l1 l2)^3 */
    for (double l2 = 0.7; l2 < 2.0; l2 += 0.1) {
      double phi;
      ck_assert_double_eq_tol(tension(&material, l1, l2, &phi), l1 / l2 - pow(l1 * l2, -3.0), 1e-12);
    }
  }
  material_free(&material);
}
END_TEST

START_TEST(stretched_skalak_membrane_has_its_published_tension) {
  SceneParameter parameters[] = {number("C", 2.5), number("G_s", 1.3)};
  Material material = make_material(scene_law("skalak", parameters, 2), NONE);
  for (double l1 = 0.7; l1 < 2.0; l1 += 0.1) { /* T1 = G l1/l2 [l1^2 - 1 + C l2^2 ((l1 l2)^2 - 1)] */
    for (double l2 = 0.7; l2 < 2.0; l2 += 0.1) {
      double phi, J2 = l1 * l1 * l2 * l2;
      double T = 1.3 * (l1 / l2) * (l1 * l1 - 1.0 + 2.5 * l2 * l2 * (J2 - 1.0));
      ck_assert_double_eq_tol(tension(&material, l1, l2, &phi), T, 1e-12 * (1.0 + fabs(T)));
    }
  }
  material_free(&material);
}
END_TEST

START_TEST(moduli_at_rest_are_those_of_linear_theory) {
  SceneParameter parameters[] = {number("C", 7.0), number("G_s", 2.0)};
  Material hookean = neo_hookean(), skalak = make_material(scene_law("skalak", parameters, 2), NONE);
  ck_assert_double_eq_tol(hookean.shear_modulus, 1.0, ROUNDING);
  ck_assert_double_eq_tol(hookean.dilatation_modulus, 3.0, ROUNDING);
  ck_assert_double_eq_tol(skalak.shear_modulus, 2.0, ROUNDING);
  ck_assert_double_eq_tol(skalak.dilatation_modulus, 30.0, 1e-12); /* (1 + 2C) G_s */
  material_free(&hookean);
  material_free(&skalak);
}
END_TEST

START_TEST(moduli_of_a_law_without_second_derivatives_come_from_differences) {
  Material material = make_material(scene_law("domain", NULL, 0), NONE); /* neo-Hookean, no Hessian */
  ck_assert_double_eq_tol(material.shear_modulus, 1.0, ROUNDING);
  ck_assert_double_eq_tol(material.dilatation_modulus, 3.0, 1e-9); /* truncation (1e-3)^4 times 48 */
  material_free(&material);
}
END_TEST

/* ---- Refusals of the elastic law ---- */

typedef struct {
  double I1[N], I2[N], phi[N], dphi[2 * N];
} Strains;

static ElasticBatch strained(Strains *s) {
  for (int i = 0; i < N; i++) s->I1[i] = s->I2[i] = 0.01 * i;
  return (ElasticBatch){.n = N, .ld = N, .I1 = s->I1, .I2 = s->I2, .phi = s->phi, .dphi = s->dphi};
}

START_TEST(a_law_that_refuses_a_point_rejects_the_step_and_the_point_is_named) {
  Error error;
  Strains s;
  ptrdiff_t point;
  Material material = make_material(scene_law("domain", NULL, 0), NONE);
  ElasticBatch batch = strained(&s);
  ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_OK);
  s.I1[17] = 2.0;
  ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, 17);
  ck_assert_ptr_nonnull(strstr(error.text, "law domain, point 17"));
  ck_assert_ptr_nonnull(strstr(error.text, "I1 is beyond 1"));
  s.I1[3] = 11.0;
  ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_FAILED);
  ck_assert_int_eq(point, 3);
  material_free(&material);
}
END_TEST

START_TEST(a_value_that_is_not_finite_rejects_the_step_and_the_point_is_named) {
  Error error;
  Strains s;
  ptrdiff_t point;
  Material material = make_material(scene_law("nan_energy", NULL, 0), NONE);
  ElasticBatch batch = strained(&s);
  s.I1[N - 1] = 1.5;
  ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, N - 1);
  ck_assert_ptr_nonnull(strstr(error.text, "law nan_energy: expected a finite dphi, found"));
  material_free(&material);
}
END_TEST

START_TEST(a_law_never_sees_a_strain_that_cannot_be) {
  Error error;
  Strains s;
  ptrdiff_t point;
  const double bad[] = {-1.0, -2.0, NAN, INFINITY};
  Material material = neo_hookean();
  for (int k = 0; k < 4; k++) {
    ElasticBatch batch = strained(&s);
    s.I2[k] = bad[k];
    ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_REJECT);
    ck_assert_int_eq(point, k);
    ck_assert_ptr_nonnull(strstr(error.text, "expected finite strains and I2 > -1")); /* no law is blamed */
  }
  ElasticBatch batch = strained(&s);
  s.I1[9] = NAN;
  ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, 9);
  ck_assert_ptr_nonnull(strstr(error.text, "expected finite strains"));
  material_free(&material);
}
END_TEST

START_TEST(a_law_with_tension_at_rest_is_refused) {
  Error error;
  Material material;
  ck_assert_int_eq(try_material(&material, scene_law("prestressed", NULL, 0), NONE, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(
      strstr(error.text, "scene.yaml:5:8: law prestressed: expected no energy and no tension"));
}
END_TEST

/* ---- Damage ---- */

typedef struct {
  double Y[N], Ymax0[N], Ymax1[N], d0[N], d1[N];
} Damaged;

static DamageBatch damaged(Damaged *s) {
  return (DamageBatch){.n = N,
                       .ld = N,
                       .chan = {[MLAW_Y] = s->Y},
                       .Ymax0 = s->Ymax0,
                       .d0 = s->d0,
                       .Ymax1 = s->Ymax1,
                       .d1 = s->d1};
}

/* One accepted step at a uniform Y. */
static void advance(const Material *material, Damaged *s, double Y) {
  Error error;
  const DamageBatch batch = damaged(s);
  for (int i = 0; i < N; i++) s->Y[i] = Y;
  ck_assert_int_eq(material_damage(material, &batch, NULL, &error), STATUS_OK);
  memcpy(s->Ymax0, s->Ymax1, sizeof s->Ymax0);
  memcpy(s->d0, s->d1, sizeof s->d0);
}

START_TEST(damage_is_zeta_of_the_largest_Y) {
  Material material = neo_hookean_with_damage(0.2, 2.0);
  Damaged s = {0};
  const double path[][2] = {/* Y, d = <(Ymax - 0.2)/2>, equations 2.28 to 2.31 */
                            {0.1, 0.0},  {0.2, 0.0}, {0.0, 0.0}, {0.6, 0.2}, {0.3, 0.2},
                            {0.59, 0.2}, {1.2, 0.5}, {0.0, 0.5}, {2.2, 1.0}, {5.0, 1.0}};
  for (size_t k = 0; k < sizeof path / sizeof *path; k++) {
    advance(&material, &s, path[k][0]);
    for (int i = 0; i < N; i++) ck_assert_double_eq_tol(s.d0[i], path[k][1], 1e-15);
  }
  ck_assert_double_eq(s.Ymax0[0], 5.0);
  material_free(&material);
}
END_TEST

START_TEST(damage_stops_at_the_cap_of_the_scene) {
  Material material = neo_hookean_with_damage(0.2, 2.0);
  Damaged s = {0};
  material.d_max = 0.7;
  advance(&material, &s, 3.0);
  ck_assert_double_eq(s.d0[0], 0.7);
  material_free(&material);
}
END_TEST

START_TEST(a_trial_leaves_the_accepted_values_alone) {
  Error error;
  Material material = neo_hookean_with_damage(0.2, 2.0);
  Damaged s = {0};
  advance(&material, &s, 0.6);
  for (int i = 0; i < N; i++) s.Y[i] = 1.2;
  const DamageBatch batch = damaged(&s);
  ck_assert_int_eq(material_damage(&material, &batch, NULL, &error), STATUS_OK);
  ck_assert_double_eq_tol(s.d1[0], 0.5, 1e-15);
  ck_assert_double_eq_tol(s.d0[0], 0.2, 1e-15);
  ck_assert_double_eq(s.Ymax0[0], 0.6);
  material_free(&material);
}
END_TEST

START_TEST(without_hardening_the_first_excess_breaks) {
  Material material = neo_hookean_with_damage(0.2, 0.0);
  Damaged s = {0};
  advance(&material, &s, 0.2);
  ck_assert_double_eq(s.d0[0], 0.0);
  advance(&material, &s, nextafter(0.2, 1.0));
  ck_assert_double_eq(s.d0[0], 1.0);
  material_free(&material);
}
END_TEST

START_TEST(a_damage_law_is_not_called_while_no_point_exceeds_its_largest_Y) {
  Error error;
  ptrdiff_t point;
  SceneParameter Y_D[] = {number("Y_D", 0.2)};
  Material material = /* this law gives NaN whenever it is called */
      make_material(scene_law("neo_hookean", NULL, 0), scene_law("nan_damage", Y_D, 1));
  Damaged s = {0};
  for (int i = 0; i < N; i++) {
    s.Ymax0[i] = 1.0 + i;
    s.Y[i] = 0.99;
    s.d0[i] = 0.01 * i;
  }
  s.Y[5] = s.Ymax0[5]; /* equal is not beyond */
  DamageBatch batch = damaged(&s);
  ck_assert_int_eq(material_damage(&material, &batch, &point, &error), STATUS_OK);
  ck_assert_mem_eq(s.d1, s.d0, sizeof s.d0);
  ck_assert_mem_eq(s.Ymax1, s.Ymax0, sizeof s.Ymax0);
  s.Y[30] = 40.0;
  ck_assert_int_eq(material_damage(&material, &batch, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, 0);
  ck_assert_ptr_nonnull(strstr(error.text, "law nan_damage: expected a finite zeta"));
  material_free(&material);
}
END_TEST

START_TEST(a_release_rate_that_is_not_a_number_is_refused) {
  Error error;
  ptrdiff_t point;
  Material material = neo_hookean_with_damage(0.2, 2.0);
  Damaged s = {0};
  s.Y[12] = NAN;
  const DamageBatch batch = damaged(&s);
  ck_assert_int_eq(material_damage(&material, &batch, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, 12);
  ck_assert_ptr_nonnull(strstr(error.text, "expected a finite Y")); /* no law is blamed */
  material_free(&material);
}
END_TEST

START_TEST(a_general_law_whose_damage_falls_stops_the_run) {
  Error error;
  ptrdiff_t point;
  Material material = make_material(scene_law("neo_hookean", NULL, 0), scene_law("healing", NULL, 0));
  Damaged s = {0};
  const DamageBatch batch = damaged(&s);
  ck_assert_int_eq(material_damage(&material, &batch, &point, &error), STATUS_FAILED);
  ck_assert_ptr_nonnull(strstr(error.text, "law healing: expected damage that never falls"));
  material_free(&material);
}
END_TEST

/* dd/dt = <T1/T_R - 1>/tau with the time of overload as a variable: the template of the general kind. */
static Material overloaded(double T_R, double tau) {
  SceneParameter parameters[] = {number("T_R", T_R), number("tau", tau)};
  return make_material(scene_law("neo_hookean", NULL, 0),
                       scene_law(BUILD_DIR "/template/general_damage_law.so", parameters, 2));
}

START_TEST(a_general_law_steps_from_the_accepted_state_in_its_own_channels) {
  enum { STEPS = 20 };
  Error error;
  Material material = overloaded(0.5, 2.0);
  double Y = 0.3, T1 = 0.75, Ymax[2] = {0}, d[2] = {0}, time[2];
  ck_assert_uint_eq(material_channels(&material), 1u << MLAW_Y | 1u << MLAW_T1);
  ck_assert_int_eq(material_damage_vars(&material), 1);
  material_start_state(&material, LAW_DAMAGE, 1, 1, time);
  for (int k = 0; k < STEPS; k++) {
    const DamageBatch batch = {.n = 1,
                               .ld = 1,
                               .t = 0.1 * k,
                               .dt = 0.1,
                               .chan0 = {[MLAW_Y] = &Y, [MLAW_T1] = &T1},
                               .chan = {[MLAW_Y] = &Y, [MLAW_T1] = &T1},
                               .Ymax0 = &Ymax[0],
                               .d0 = &d[0],
                               .state0 = &time[0],
                               .Ymax1 = &Ymax[1],
                               .d1 = &d[1],
                               .state1 = &time[1]};
    ck_assert_int_eq(material_damage(&material, &batch, NULL, &error), STATUS_OK);
    Ymax[0] = Ymax[1];
    d[0] = d[1];
    time[0] = time[1];
  }
  ck_assert_double_eq_tol(d[0], 0.5 * 0.1 * STEPS / 2.0, 1e-14); /* (0.75/0.5 - 1) t/tau */
  ck_assert_double_eq_tol(time[0], 0.1 * STEPS, 1e-14);
  ck_assert_double_eq(Ymax[0], 0.3);
  material_free(&material);
}
END_TEST

START_TEST(damage_of_a_general_law_stops_at_the_cap_too) {
  Error error;
  Material material = overloaded(0.5, 0.01);
  double Y = 0.3, T1 = 1.5, Ymax[2] = {0}, d[2] = {0}, time[2] = {0};
  const DamageBatch batch = {.n = 1,
                             .ld = 1,
                             .dt = 1.0,
                             .chan0 = {[MLAW_Y] = &Y, [MLAW_T1] = &T1},
                             .chan = {[MLAW_Y] = &Y, [MLAW_T1] = &T1},
                             .Ymax0 = &Ymax[0],
                             .d0 = &d[0],
                             .state0 = &time[0],
                             .Ymax1 = &Ymax[1],
                             .d1 = &d[1],
                             .state1 = &time[1]};
  ck_assert_int_eq(material_damage(&material, &batch, NULL, &error), STATUS_OK);
  ck_assert_double_eq(d[1], 1.0);
  material_free(&material);
}
END_TEST

START_TEST(a_law_built_with_longer_structures_runs) {
  SceneParameter spare[] = {number("spare", 3.0)};
  Material material = make_material(scene_law("from_the_future", spare, 1), NONE);
  ck_assert_double_eq(material.elastic_values.value[0], 1.0);
  ck_assert_double_eq(material.elastic_values.value[1], 3.0);
  ck_assert_double_eq_tol(material.dilatation_modulus, 3.0, 1e-9);
  material_free(&material);
}
END_TEST

/* Y = 1.5 with Y_D = 1 gives zeta = 1/2. */
START_TEST(laws_built_with_shorter_or_longer_structures_damage_as_they_say) {
  static const char *const requests[] = {BUILD_DIR "/tests/abi/older.so", BROKEN "/from_the_future.so"};
  for (int k = 0; k < 2; k++) {
    Error error;
    Material material = make_material(scene_law(requests[k], NULL, 0), scene_law(requests[k], NULL, 0));
    const double Y = 1.5, Ymax0 = 0.0, d0 = 0.0;
    double Ymax1, d1;
    const DamageBatch batch = {.n = 1,
                               .ld = 1,
                               .dt = 1.0,
                               .chan = {[MLAW_Y] = &Y},
                               .Ymax0 = &Ymax0,
                               .d0 = &d0,
                               .Ymax1 = &Ymax1,
                               .d1 = &d1};
    ck_assert_int_eq(material_damage(&material, &batch, NULL, &error), STATUS_OK);
    ck_assert_double_eq(d1, 0.5);
    material_free(&material);
  }
}
END_TEST

START_TEST(a_unit_in_a_scene_without_physical_flow_is_refused) {
  Error error;
  Material material;
  SceneParameter modulus[] = {number("G_s", 0.1)};
  modulus[0].value.has_unit = true;
  memcpy(modulus[0].value.dim, (const signed char[4]){1, 0, -2, 0}, 4);
  ck_assert_int_eq(try_material(&material, scene_law("neo_hookean", modulus, 1), NONE, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "the scene gives no physical scales"));
}
END_TEST

START_TEST(an_elastic_material_has_no_damage_and_asks_for_no_channel) {
  Material material = neo_hookean();
  ck_assert(!material_has_damage(&material));
  ck_assert_uint_eq(material_channels(&material), 0);
  ck_assert_int_eq(material_damage_vars(&material), 0);
  material_free(&material);
  material = neo_hookean_with_damage(0.2, 2.0);
  ck_assert(material_has_damage(&material));
  ck_assert_uint_eq(material_channels(&material), 1u << MLAW_Y);
  material_free(&material);
}
END_TEST

START_TEST(set_up_survives_the_failure_of_any_allocation) {
  SceneParameter parameters[] = {number("Y_D", 0.2), number("Y_C", 2.0)};
  Material material;
  Error error;
  Status status;
  long n = 0;
  do {
    array_fail_nth(++n);
    status = try_material(&material, scene_law("neo_hookean", NULL, 0), scene_law("marigo", parameters, 2),
                          &error);
    array_fail_nth(0);
    ck_assert(status == STATUS_OK || status == STATUS_MEMORY);
  } while (status != STATUS_OK && n < 1000);
  ck_assert_int_gt(n, 10);
  ck_assert_int_eq(status, STATUS_OK);
  material_free(&material);
}
END_TEST

START_TEST(a_law_of_negative_moduli_is_refused) {
  Material material;
  Error error; /* its default is a modulus of -1 */
  ck_assert_int_eq(try_material(&material, scene_law(BROKEN "/bad_tables.so", NULL, 0), NONE, &error),
                   STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "expected positive moduli at rest, found G_s = -1 and K_s = -3"));
}
END_TEST

static int give_no_reason(const mlaw_energy_args *a) {
  a->err->point = -1;
  a->err->text[0] = '\0';
  return MLAW_INTERNAL;
}

START_TEST(a_law_that_fails_at_no_point_and_without_reason_is_named) {
  Error error;
  Strains s;
  ptrdiff_t point = 5;
  Material material = neo_hookean();
  mlaw_energy mute = *material.elastic.energy;
  mute.eval = give_no_reason;
  material.elastic.energy = &mute;
  ElasticBatch batch = strained(&s);
  ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_FAILED);
  ck_assert_str_eq(error.text, "law neo_hookean: the law gives no reason (status -3)");
  ck_assert_int_eq(point, -1);
  material_free(&material);
}
END_TEST

int main(void) {
  return suite_run("material",
                   (SuiteTests){inflated_neo_hookean_membrane_has_the_tension_and_energy_of_the_paper,
                                stretched_neo_hookean_membrane_has_the_tension_of_the_paper,
                                stretched_skalak_membrane_has_its_published_tension,
                                moduli_at_rest_are_those_of_linear_theory,
                                moduli_of_a_law_without_second_derivatives_come_from_differences,
                                a_law_that_refuses_a_point_rejects_the_step_and_the_point_is_named,
                                a_value_that_is_not_finite_rejects_the_step_and_the_point_is_named,
                                a_law_never_sees_a_strain_that_cannot_be,
                                a_law_with_tension_at_rest_is_refused,
                                damage_is_zeta_of_the_largest_Y,
                                damage_stops_at_the_cap_of_the_scene,
                                a_trial_leaves_the_accepted_values_alone,
                                without_hardening_the_first_excess_breaks,
                                a_damage_law_is_not_called_while_no_point_exceeds_its_largest_Y,
                                a_release_rate_that_is_not_a_number_is_refused,
                                a_general_law_whose_damage_falls_stops_the_run,
                                a_general_law_steps_from_the_accepted_state_in_its_own_channels,
                                damage_of_a_general_law_stops_at_the_cap_too,
                                a_law_built_with_longer_structures_runs,
                                laws_built_with_shorter_or_longer_structures_damage_as_they_say,
                                a_unit_in_a_scene_without_physical_flow_is_refused,
                                an_elastic_material_has_no_damage_and_asks_for_no_channel,
                                set_up_survives_the_failure_of_any_allocation,
                                a_law_of_negative_moduli_is_refused,
                                a_law_that_fails_at_no_point_and_without_reason_is_named,
                                NULL});
}
