/* The constitutive laws of plugins/constitutive, through their shared objects and the host: curves against
 * closed forms written here from the stretches, derivatives against differences, moduli, limits, refusals. */
#include "law_scene.h"
#include "laws/material.h"
#include "random.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static const SceneLaw NONE = {0};

/* ---- Closed forms ---- */

/* A state of the sheet: principal stretches and the principal tension along the first. */
typedef struct {
  double l1, l2, T1;
} Point;

static const double G = 1.3;

/* Sheets of incompressible solids: Cauchy stress s (l1^2 - l3^2) by the textbook, times the thickness l3. */
typedef double Slope(double x); /* twice dW/dI_1 at x = I_1 - 3 */

static Point sheet_uniaxial(Slope *s, double l) {
  const double x = l * l + 2.0 / l - 3.0;
  return (Point){l, 1.0 / sqrt(l), s(x) * (l * l - 1.0 / l) / sqrt(l)};
}
static Point sheet_equibiaxial(Slope *s, double l) {
  const double x = 2.0 * l * l + pow(l, -4.0) - 3.0;
  return (Point){l, l, s(x) * (l * l - pow(l, -4.0)) / (l * l)};
}
static Point sheet_pure_shear(Slope *s, double l) {
  const double x = l * l + pow(l, -2.0) - 2.0;
  return (Point){l, 1.0, s(x) * (l * l - pow(l, -2.0)) / l};
}

#define SHEET(name, formula)                                                                                 \
  static double name##_slope(double x) {                                                                     \
    return formula;                                                                                          \
  }                                                                                                          \
  static Point name##_uniaxial(double l) {                                                                   \
    return sheet_uniaxial(name##_slope, l);                                                                  \
  }                                                                                                          \
  static Point name##_equibiaxial(double l) {                                                                \
    return sheet_equibiaxial(name##_slope, l);                                                               \
  }                                                                                                          \
  static Point name##_pure_shear(double l) {                                                                 \
    return sheet_pure_shear(name##_slope, l);                                                                \
  }

static const double c2 = -0.2, c3 = 0.05, J_m = 9.0, b = 0.8;
SHEET(neo_hookean, G + 0.0 * x)
SHEET(yeoh, G *(1.0 + 2.0 * c2 * x + 3.0 * c3 * x * x))
SHEET(gent, G *J_m / (J_m - x))
SHEET(fung, G *exp(b *x))

static const double PSI = 0.3; /* 2 C1 = Psi G, 2 C2 = (1 - Psi) G */
static Point mooney_rivlin_uniaxial(double l) {
  return (Point){l, 1.0 / sqrt(l), G * (PSI + (1.0 - PSI) / l) * (l * l - 1.0 / l) / sqrt(l)};
}
static Point mooney_rivlin_equibiaxial(double l) {
  return (Point){l, l, G * (PSI + (1.0 - PSI) * l * l) * (l * l - pow(l, -4.0)) / (l * l)};
}
static Point mooney_rivlin_pure_shear(double l) {
  return (Point){l, 1.0, G * (l * l - pow(l, -2.0)) / l};
}

/* T1 = G (l1/l2) [l1^2 - 1 + C l2^2 (l1^2 l2^2 - 1)]; pulled one way, l2^2 = (1 + C l1^2)/(1 + C l1^4). */
static const double C = 1.5;
static Point skalak_uniaxial(double l) {
  const double left = 1.0 + C * pow(l, 4.0), l2 = sqrt((1.0 + C * l * l) / left);
  return (Point){l, l2, G * (l / l2) * (l * l - 1.0) * (1.0 + C * l2 * l2 / left)};
}
static Point skalak_equibiaxial(double l) {
  return (Point){l, l, G * (l * l - 1.0) * (1.0 + C * l * l * (l * l + 1.0))};
}
static Point skalak_pure_shear(double l) {
  return (Point){l, 1.0, G * (1.0 + C) * l * (l * l - 1.0)};
}

/* Plane stress with E_s = 2 G (1 + nu): force E_s e1 along the reference direction, T = force l1/l2. */
static const double NU = 0.4;
static Point hooke_uniaxial(double l) {
  const double strain = 0.5 * (l * l - 1.0), l2 = sqrt(1.0 - 2.0 * NU * strain);
  return (Point){l, l2, 2.0 * G * (1.0 + NU) * strain * l / l2};
}
static Point hooke_equibiaxial(double l) {
  return (Point){l, l, G * (1.0 + NU) / (1.0 - NU) * (l * l - 1.0)};
}
static Point hooke_pure_shear(double l) {
  return (Point){l, 1.0, G / (1.0 - NU) * l * (l * l - 1.0)};
}

static const double K = 5.0;
static Point st_venant_kirchhoff_uniaxial(double l) {
  const double strain = 0.5 * (l * l - 1.0), E_s = 4.0 * G * K / (G + K), nu = (K - G) / (K + G);
  const double l2 = sqrt(1.0 - 2.0 * nu * strain);
  return (Point){l, l2, E_s * strain * l / l2};
}
static Point st_venant_kirchhoff_equibiaxial(double l) {
  return (Point){l, l, K * (l * l - 1.0)};
}
static Point st_venant_kirchhoff_pure_shear(double l) {
  return (Point){l, 1.0, 0.5 * (K + G) * l * (l * l - 1.0)};
}

/* Uniaxial: no second tension at area ratio J when l1^2 solves s^2 - c J^2 s - J^2 = 0. */
static Point evans_skalak_uniaxial(double parameter) {
  const double J = 1.0 + 0.05 * (parameter - 1.0), c = 2.0 * K / G * (J - 1.0);
  const double l1 = sqrt(0.5 * (c * J * J + J * sqrt(c * c * J * J + 4.0)));
  return (Point){l1, J / l1, 2.0 * K * (J - 1.0)};
}
static Point evans_skalak_equibiaxial(double l) {
  return (Point){l, l, K * (l * l - 1.0)};
}
static Point evans_skalak_pure_shear(double l) {
  return (Point){l, 1.0, K * (l - 1.0) + 0.5 * G * (1.0 - 1.0 / (l * l))};
}

/* ---- The laws under test ---- */

enum { MAX_PARAMS = 3 };

typedef struct {
  const char *id;
  const char *name[MAX_PARAMS];
  double value[MAX_PARAMS];
  int n_params;
  double K_s;
  Point (*uniaxial)(double), (*equibiaxial)(double), (*pure_shear)(double);
} Case;

#define CURVES(law) law##_uniaxial, law##_equibiaxial, law##_pure_shear

static const Case cases[] = {
    {"neo_hookean", {"G_s"}, {1.3}, 1, 3.9, CURVES(neo_hookean)},
    {"skalak", {"G_s", "C"}, {1.3, 1.5}, 2, 1.3 * 4.0, CURVES(skalak)},
    {"hooke", {"G_s", "nu_s"}, {1.3, 0.4}, 2, 1.3 * 1.4 / 0.6, CURVES(hooke)},
    {"st_venant_kirchhoff", {"G_s", "K_s"}, {1.3, 5.0}, 2, 5.0, CURVES(st_venant_kirchhoff)},
    {"evans_skalak", {"G_s", "K_s"}, {1.3, 5.0}, 2, 5.0, CURVES(evans_skalak)},
    {"mooney_rivlin", {"G_s", "Psi"}, {1.3, 0.3}, 2, 3.9, CURVES(mooney_rivlin)},
    {"yeoh", {"G_s", "c_2", "c_3"}, {1.3, -0.2, 0.05}, 3, 3.9, CURVES(yeoh)},
    {"gent", {"G_s", "J_m"}, {1.3, 9.0}, 2, 3.9, CURVES(gent)},
    {"fung", {"G_s", "b"}, {1.3, 0.8}, 2, 3.9, CURVES(fung)},
};
enum { N_CASES = sizeof cases / sizeof *cases };

static Material material_of(const Case *law) {
  SceneParameter parameters[MAX_PARAMS];
  for (int k = 0; k < law->n_params; k++) parameters[k] = number(law->name[k], law->value[k]);
  return make_material(scene_law(law->id, parameters, (size_t)law->n_params), NONE);
}

static Material material_with(const char *id, const char *name, double value) {
  SceneParameter parameters[] = {number("G_s", G), number(name, value)};
  return make_material(scene_law(id, parameters, 2), NONE);
}

typedef struct {
  double phi, dphi[2], d2phi[3];
} Energy;

static Energy energy_at(const Material *material, double I1, double I2) {
  Error error;
  Energy e;
  const ElasticBatch batch = {
      .n = 1, .ld = 1, .I1 = &I1, .I2 = &I2, .phi = &e.phi, .dphi = e.dphi, .d2phi = e.d2phi};
  const Status status = material_elastic(material, &batch, NULL, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return e;
}

static Energy stretched(const Material *material, double l1, double l2) {
  return energy_at(material, l1 * l1 + l2 * l2 - 2.0, l1 * l1 * l2 * l2 - 1.0);
}

/* Principal tension along l1. */
static double tension(const Material *material, double l1, double l2) {
  const Energy e = stretched(material, l1, l2);
  return 2.0 * (l1 / l2) * (e.dphi[0] + l2 * l2 * e.dphi[1]);
}

/* ---- Curves ---- */

/* Rounding of I1 and I2 (1e-16 of numbers up to 10) times the slopes of the laws (up to 100). */
static void expect_tension(const Case *law, const char *what, double l, double found, double expected) {
  ck_assert_msg(fabs(found - expected) <= 1e-12 * (1.0 + fabs(expected)),
                "%s, %s at stretch %g: expected tension %.15g, found %.15g", law->id, what, l, expected,
                found);
}

START_TEST(tensions_follow_the_closed_forms) {
  for (int k = 0; k < N_CASES; k++) {
    const Case *law = &cases[k];
    Material material = material_of(law);
    for (int i = 0; i <= 20; i++) {
      const double l = 0.8 + 0.04 * i;
      const Point u = law->uniaxial(l), e = law->equibiaxial(l), s = law->pure_shear(l);
      expect_tension(law, "uniaxial", l, tension(&material, u.l1, u.l2), u.T1);
      expect_tension(law, "uniaxial, across", l, tension(&material, u.l2, u.l1), 0.0);
      expect_tension(law, "equibiaxial", l, tension(&material, e.l1, e.l2), e.T1);
      expect_tension(law, "pure shear", l, tension(&material, s.l1, s.l2), s.T1);
    }
    material_free(&material);
  }
}
END_TEST

START_TEST(moduli_at_rest_are_those_declared) {
  for (int k = 0; k < N_CASES; k++) {
    Material material = material_of(&cases[k]);
    ck_assert_double_eq_tol(material.shear_modulus, G, 1e-14);
    ck_assert_double_eq_tol(material.dilatation_modulus, cases[k].K_s, 1e-13);
    material_free(&material);
  }
}
END_TEST

START_TEST(rest_has_neither_energy_nor_tension) {
  for (int k = 0; k < N_CASES; k++) {
    Material material = material_of(&cases[k]);
    const Energy rest = energy_at(&material, 0.0, 0.0);
    ck_assert_double_eq(rest.phi, 0.0);
    ck_assert_double_eq_tol(rest.dphi[0] + rest.dphi[1], 0.0, 1e-15);
    material_free(&material);
  }
}
END_TEST

START_TEST(energy_is_positive_away_from_rest) {
  for (int k = 0; k < N_CASES; k++) {
    Material material = material_of(&cases[k]);
    for (double l1 = 0.7; l1 < 1.75; l1 += 0.05) {
      for (double l2 = 0.7; l2 < l1 - 0.01; l2 += 0.05)
        ck_assert_double_gt(stretched(&material, l1, l2).phi, 0);
    }
    material_free(&material);
  }
}
END_TEST

/* ---- Derivatives ---- */

/* From values at +-h and +-h/2: error h^4/480 times a fifth derivative of some thousands (1/(1 + I2) at
 * I2 = -0.75), below 1e-12; rounding is 1e-16/h of values up to 100. */
static const double STEP = 1e-3, DIFFERENCE = 1e-8;

static Energy derivative(const Material *material, double I1, double I2, int direction) {
  Energy e[4], d;
  for (int k = 0; k < 4; k++) {
    const double s = STEP * (k % 2 ? -1.0 : 1.0) * (k < 2 ? 1.0 : 0.5);
    e[k] = energy_at(material, I1 + (direction == 0 ? s : 0.0), I2 + (direction == 1 ? s : 0.0));
  }
#define RICHARDSON(x) (4.0 * (e[2].x - e[3].x) / STEP - (e[0].x - e[1].x) / (2.0 * STEP)) / 3.0
  d.phi = RICHARDSON(phi);
  for (int k = 0; k < 2; k++) d.dphi[k] = RICHARDSON(dphi[k]);
  return d;
}

static void expect_derivative(const char *law, const char *what, double found, double difference) {
  ck_assert_msg(fabs(found - difference) <= DIFFERENCE * (1.0 + fabs(difference)),
                "%s: expected %s = %.12g from differences, found %.12g", law, what, difference, found);
}

START_TEST(derivatives_agree_with_differences) {
  uint64_t state = 2026; /* the same numbers in every run */
  for (int k = 0; k < N_CASES; k++) {
    Material material = material_of(&cases[k]);
    for (int i = 0; i < 200; i++) {
      const double l1 = 1.2 + 0.5 * random_uniform(&state), l2 = 1.2 + 0.5 * random_uniform(&state);
      const double I1 = l1 * l1 + l2 * l2 - 2.0, I2 = l1 * l1 * l2 * l2 - 1.0;
      const Energy at = energy_at(&material, I1, I2), d1 = derivative(&material, I1, I2, 0),
                   d2 = derivative(&material, I1, I2, 1);
      expect_derivative(cases[k].id, "phi_1", at.dphi[0], d1.phi);
      expect_derivative(cases[k].id, "phi_2", at.dphi[1], d2.phi);
      expect_derivative(cases[k].id, "phi_11", at.d2phi[0], d1.dphi[0]);
      expect_derivative(cases[k].id, "phi_12", at.d2phi[1], d1.dphi[1]);
      expect_derivative(cases[k].id, "phi_12", at.d2phi[1], d2.dphi[0]);
      expect_derivative(cases[k].id, "phi_22", at.d2phi[2], d2.dphi[1]);
    }
    material_free(&material);
  }
}
END_TEST

/* ---- Limits ---- */

/* Largest difference of phi and its derivatives over stretches 0.5 to 3, relative to their size. */
static double distance(const Material *one, const Material *other) {
  double largest = 0.0;
  for (double l1 = 0.5; l1 < 3.0; l1 += 0.1) {
    for (double l2 = 0.5; l2 < 3.0; l2 += 0.1) {
      const Energy e = stretched(one, l1, l2), f = stretched(other, l1, l2);
      const double a[] = {e.phi, e.dphi[0], e.dphi[1], e.d2phi[0], e.d2phi[1], e.d2phi[2]};
      const double c[] = {f.phi, f.dphi[0], f.dphi[1], f.d2phi[0], f.d2phi[1], f.d2phi[2]};
      for (int k = 0; k < 6; k++) largest = fmax(largest, fabs(a[k] - c[k]) / (1.0 + fabs(c[k])));
    }
  }
  return largest;
}

START_TEST(sheets_of_incompressible_solids_have_the_neo_hookean_limit) {
  SceneParameter modulus[] = {number("G_s", G)};
  Material neo_hookean = make_material(scene_law("neo_hookean", modulus, 1), NONE);
  const struct {
    const char *id, *name;
    double value, tolerance;
  } limits[] = {{"mooney_rivlin", "Psi", 1.0, 1e-14},
                {"yeoh", "c_2", 0.0, 1e-14},
                {"fung", "b", 0.0, 1e-14},
                {"gent", "J_m", 1e12, 1e-9}}; /* x^2/J_m with x below 100 */
  for (int k = 0; k < 4; k++) {
    Material material = material_with(limits[k].id, limits[k].name, limits[k].value);
    ck_assert_double_lt(distance(&material, &neo_hookean), limits[k].tolerance);
    material_free(&material);
  }
  material_free(&neo_hookean);
}
END_TEST

START_TEST(hooke_and_st_venant_kirchhoff_are_one_energy) {
  Material hooke = material_with("hooke", "nu_s", 0.25),
           kirchhoff = material_with("st_venant_kirchhoff", "K_s", G * 1.25 / 0.75);
  ck_assert_double_lt(distance(&hooke, &kirchhoff), 1e-14);
  material_free(&hooke);
  material_free(&kirchhoff);
}
END_TEST

START_TEST(an_auxetic_hooke_membrane_widens_when_pulled) {
  Material material = material_with("hooke", "nu_s", -0.3);
  const double l1 = 1.2, l2 = sqrt(1.0 + 0.3 * (l1 * l1 - 1.0));
  ck_assert_double_eq_tol(tension(&material, l2, l1), 0.0, 1e-15);
  ck_assert_double_gt(l2, 1.0);
  material_free(&material);
}
END_TEST

/* ---- Refusals ---- */

/* A batch of three of which the middle one is at equal stretches l. */
static Status middle_stretched(const Material *material, double l, Energy *middle, ptrdiff_t *point,
                               Error *error) {
  const double I1[] = {0.1, 2.0 * l * l - 2.0, 0.2}, I2[] = {0.1, pow(l, 4.0) - 1.0, 0.2};
  double phi[3], dphi[6], d2phi[9];
  const ElasticBatch batch = {.n = 3, .ld = 3, .I1 = I1, .I2 = I2, .phi = phi, .dphi = dphi, .d2phi = d2phi};
  const Status status = material_elastic(material, &batch, point, error);
  *middle = (Energy){phi[1], {dphi[1], dphi[4]}, {d2phi[1], d2phi[4], d2phi[7]}};
  return status;
}

START_TEST(gent_refuses_a_stretch_at_its_limit_and_takes_one_just_below) {
  Error error;
  Energy e;
  ptrdiff_t point;
  const double limit = sqrt(2.0); /* 2 l^2 + l^-4 - 3 = 1.25 */
  Material material = material_with("gent", "J_m", 1.25);
  ck_assert_int_eq(middle_stretched(&material, limit * (1.0 + 1e-12), &e, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, 1);
  ck_assert_ptr_nonnull(strstr(error.text, "law gent, point 1 of the batch: stretch at the limit"));
  ck_assert_int_eq(middle_stretched(&material, 100.0, &e, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(middle_stretched(&material, limit * (1.0 - 1e-12), &e, &point, &error), STATUS_OK);
  ck_assert_double_gt(e.dphi[0], 1e10 * G);
  material_free(&material);
}
END_TEST

START_TEST(fung_refuses_a_stretch_whose_energy_has_no_value) {
  Error error;
  Energy e;
  ptrdiff_t point;
  Material material = material_with("fung", "b", 20.0);
  ck_assert_int_eq(middle_stretched(&material, 3.0, &e, &point, &error), STATUS_OK); /* exp(300) */
  ck_assert_int_eq(middle_stretched(&material, 1000.0, &e, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, 1);
  ck_assert_ptr_nonnull(strstr(error.text, "law fung, point 1 of the batch"));
  material_free(&material);
}
END_TEST

START_TEST(the_others_take_any_stretch) {
  for (int k = 0; k < N_CASES; k++) {
    if (strcmp(cases[k].id, "gent") == 0 || strcmp(cases[k].id, "fung") == 0) continue;
    Material material = material_of(&cases[k]);
    stretched(&material, 1e3, 1e3); /* fails when refused or not finite */
    stretched(&material, 1e3, 1e-3);
    stretched(&material, 1e-3, 1e-3);
    material_free(&material);
  }
}
END_TEST

START_TEST(yeoh_refuses_coefficients_that_let_the_energy_fall) {
  Error error;
  Material material;
  SceneParameter parameters[] = {number("c_2", -0.3), number("c_3", 0.029)}; /* c_2^2 = 0.09 > 3 c_3 */
  ck_assert_int_eq(try_material(&material, scene_law("yeoh", parameters, 2), NONE, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "c_2 > -sqrt(3 c_3)"));
  parameters[1] = number("c_3", 0.031);
  ck_assert_int_eq(try_material(&material, scene_law("yeoh", parameters, 2), NONE, &error), STATUS_OK);
  material_free(&material);
}
END_TEST

int main(void) {
  return suite_run("constitutive laws",
                   (SuiteTests){tensions_follow_the_closed_forms, moduli_at_rest_are_those_declared,
                                rest_has_neither_energy_nor_tension, energy_is_positive_away_from_rest,
                                derivatives_agree_with_differences,
                                sheets_of_incompressible_solids_have_the_neo_hookean_limit,
                                hooke_and_st_venant_kirchhoff_are_one_energy,
                                an_auxetic_hooke_membrane_widens_when_pulled,
                                gent_refuses_a_stretch_at_its_limit_and_takes_one_just_below,
                                fung_refuses_a_stretch_whose_energy_has_no_value, the_others_take_any_stretch,
                                yeoh_refuses_coefficients_that_let_the_energy_fall, NULL});
}
