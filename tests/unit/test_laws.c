/* The laws that ship and the templates, called through the ABI as a host does: derivatives against
 * differences, inverses against each other, uniform parameters against parameters of each point. */
#include "law_scene.h"
#include "laws/plugin.h"
#include "random.h"
#include "suite.h"
#include <math.h>

#define TEMPLATES BUILD_DIR "/template"

enum { N = 64, MAX_PARAMS = 4 };

static const char *const energy_files[] = {PLUGINS "/neo_hookean.so", PLUGINS "/skalak.so",
                                           TEMPLATES "/energy_law.so"};
static const char *const damage_files[] = {PLUGINS "/marigo.so", TEMPLATES "/explicit_damage_law.so"};
enum {
  N_ENERGY = sizeof energy_files / sizeof *energy_files,
  N_DAMAGE = sizeof damage_files / sizeof *damage_files
};

static const mlaw_plugin *open_plugin(const char *file) {
  const mlaw_plugin *plugin;
  Error error;
  const Status status = plugin_open(file, &plugin, &error);
  ck_assert_msg(status == STATUS_OK, "%s: %s", file, status == STATUS_OK ? "" : error.text);
  return plugin;
}

static const uint64_t SEED = 2021; /* the same numbers in every run */

static double random_between(uint64_t *state, double lo, double hi) {
  return lo + (hi - lo) * 0.5 * (1.0 + random_uniform(state));
}

/* Parameters that lie inside every range of the laws above. */
static const double VALUE[MAX_PARAMS] = {0.7, 1.9, 1.0, 1.0};
static const mlaw_field UNIFORM[MAX_PARAMS] = {
    {&VALUE[0], 0}, {&VALUE[1], 0}, {&VALUE[2], 0}, {&VALUE[3], 0}};

typedef struct {
  double I1[N], I2[N], phi[N], dphi[2 * N], d2phi[3 * N];
} EnergyBatch;

static void evaluate_energy(const mlaw_energy *law, const mlaw_field *param, EnergyBatch *b) {
  mlaw_error err;
  const mlaw_energy_args args = {.size = sizeof args,
                                 .n = N,
                                 .ld = N,
                                 .param = param,
                                 .I1 = b->I1,
                                 .I2 = b->I2,
                                 .phi = b->phi,
                                 .dphi = b->dphi,
                                 .d2phi = b->d2phi,
                                 .err = &err};
  ck_assert_int_eq(law->eval(&args), MLAW_OK);
}

/* Principal stretches between 0.6 and 2: always admissible. */
static void sample_strains(EnergyBatch *b) {
  uint64_t state = SEED;
  for (int i = 0; i < N; i++) {
    const double l1 = random_between(&state, 0.6, 2.0), l2 = random_between(&state, 0.6, 2.0);
    b->I1[i] = l1 * l1 + l2 * l2 - 2.0;
    b->I2[i] = l1 * l1 * l2 * l2 - 1.0;
  }
}

static EnergyBatch shifted(const mlaw_energy *law, const EnergyBatch *at, double s1, double s2) {
  EnergyBatch b = *at;
  for (int i = 0; i < N; i++) {
    b.I1[i] += s1;
    b.I2[i] += s2;
  }
  evaluate_energy(law, UNIFORM, &b);
  return b;
}

/* Derivative from values at +-h and +-h/2: error of fourth order in h. */
static double richardson(double plus, double minus, double half_plus, double half_minus, double h) {
  return (4.0 * (half_plus - half_minus) / h - (plus - minus) / (2.0 * h)) / 3.0;
}

/* h^4 times a fifth derivative of some hundreds (1/(1 + I2) at I2 = -0.87) times 1e-2 is 1e-9; rounding is
 * 1e-16/h = 2e-13 of values near 10. */
static const double STEP = 5e-4, DIFFERENCE = 1e-8;

static void compare_direction(const mlaw_energy *law, const EnergyBatch *at, int direction) {
  const double s1 = direction == 0, s2 = direction == 1, h = STEP;
  const EnergyBatch plus = shifted(law, at, h * s1, h * s2), minus = shifted(law, at, -h * s1, -h * s2),
                    half_plus = shifted(law, at, 0.5 * h * s1, 0.5 * h * s2),
                    half_minus = shifted(law, at, -0.5 * h * s1, -0.5 * h * s2);
  for (int i = 0; i < N; i++) {
    const double d = richardson(plus.phi[i], minus.phi[i], half_plus.phi[i], half_minus.phi[i], h);
    ck_assert_double_eq_tol(at->dphi[direction * N + i], d, DIFFERENCE * (1.0 + fabs(d)));
    for (int k = 0; k < 2; k++) { /* d2phi is 11, 12, 22 */
      const int j = k * N + i;
      const double d2 = richardson(plus.dphi[j], minus.dphi[j], half_plus.dphi[j], half_minus.dphi[j], h);
      ck_assert_double_eq_tol(at->d2phi[(direction + k) * N + i], d2, DIFFERENCE * (1.0 + fabs(d2)));
    }
  }
}

START_TEST(derivatives_of_energy_agree_with_differences) {
  for (int k = 0; k < N_ENERGY; k++) {
    const mlaw_energy *law = open_plugin(energy_files[k])->energy[0];
    EnergyBatch batch;
    ck_assert(law->flags & MLAW_HESSIAN);
    sample_strains(&batch);
    evaluate_energy(law, UNIFORM, &batch);
    for (int direction = 0; direction < 2; direction++) compare_direction(law, &batch, direction);
  }
}
END_TEST

START_TEST(a_uniform_parameter_and_the_same_value_at_each_point_give_the_same_bits) {
  double each[MAX_PARAMS][N];
  mlaw_field fields[MAX_PARAMS];
  for (int p = 0; p < MAX_PARAMS; p++) {
    for (int i = 0; i < N; i++) each[p][i] = VALUE[p];
    fields[p] = (mlaw_field){each[p], 1};
  }
  for (int k = 0; k < N_ENERGY; k++) {
    const mlaw_energy *law = open_plugin(energy_files[k])->energy[0];
    EnergyBatch uniform, varied;
    sample_strains(&uniform);
    varied = uniform;
    evaluate_energy(law, UNIFORM, &uniform);
    evaluate_energy(law, fields, &varied);
    ck_assert_mem_eq(&uniform, &varied, sizeof uniform);
  }
}
END_TEST

START_TEST(a_parameter_of_each_point_reaches_its_own_point) {
  double G[N], C[N];
  const mlaw_field fields[2] = {{G, 1}, {C, 1}};
  const mlaw_energy *law = open_plugin(PLUGINS "/skalak.so")->energy[0];
  EnergyBatch batch;
  sample_strains(&batch);
  for (int i = 0; i < N; i++) {
    G[i] = 1.0 + i;
    C[i] = 0.1 * i;
  }
  evaluate_energy(law, fields, &batch);
  for (int i = 0; i < N; i++) {
    const double I1 = batch.I1[i], I2 = batch.I2[i];
    const double phi = G[i] / 4.0 * (I1 * I1 + 2.0 * I1 - 2.0 * I2 + C[i] * I2 * I2);
    ck_assert_double_eq_tol(batch.phi[i], phi, 1e-13 * G[i] * 100.0);
  }
}
END_TEST

typedef struct {
  double Y[N], d[N], f[N], zeta[N], dzeta[N];
} DamageValues;

static mlaw_damage_args damage_args(DamageValues *b, const double **chan, mlaw_error *err) {
  chan[MLAW_Y] = b->Y;
  return (mlaw_damage_args){.size = sizeof(mlaw_damage_args),
                            .n_channels = MLAW_N_CHANNELS,
                            .n = N,
                            .ld = N,
                            .param = UNIFORM,
                            .chan = chan,
                            .d0 = b->d,
                            .f = b->f,
                            .zeta = b->zeta,
                            .dzeta = b->dzeta,
                            .err = err};
}

START_TEST(threshold_vanishes_at_the_damage_that_evolution_gives) {
  for (int k = 0; k < N_DAMAGE; k++) {
    const mlaw_damage *law = open_plugin(damage_files[k])->damage[0];
    const double *chan[MLAW_N_CHANNELS] = {0};
    DamageValues b;
    mlaw_error err;
    const mlaw_damage_args args = damage_args(&b, chan, &err);
    for (int i = 0; i < N; i++) b.Y[i] = VALUE[0] + (VALUE[1] * i) / (N - 1); /* from Y_D to Y_D + Y_C */
    ck_assert_int_eq(law->evolution(&args), MLAW_OK);
    for (int i = 0; i < N; i++) b.d[i] = b.zeta[i];
    ck_assert_int_eq(law->threshold(&args), MLAW_OK);
    for (int i = 0; i < N; i++) ck_assert_double_eq_tol(b.f[i], 0.0, 1e-14);
    ck_assert_double_eq_tol(b.zeta[0], 0.0, 1e-14);
    ck_assert_double_eq_tol(b.zeta[N - 1], 1.0, 1e-14);
  }
}
END_TEST

START_TEST(the_slope_of_evolution_agrees_with_differences) {
  const double h = 1e-4;
  uint64_t state = SEED;
  for (int k = 0; k < N_DAMAGE; k++) {
    const mlaw_damage *law = open_plugin(damage_files[k])->damage[0];
    const double *chan[MLAW_N_CHANNELS] = {0};
    DamageValues at, plus, minus;
    mlaw_error err;
    for (int i = 0; i < N; i++) { /* away from the kink at Y_D */
      at.Y[i] = random_between(&state, VALUE[0] + 0.01, 4.0);
      plus.Y[i] = at.Y[i] + h;
      minus.Y[i] = at.Y[i] - h;
    }
    DamageValues *all[] = {&at, &plus, &minus};
    for (int j = 0; j < 3; j++) {
      const mlaw_damage_args args = damage_args(all[j], chan, &err);
      ck_assert_int_eq(law->evolution(&args), MLAW_OK);
    }
    for (int i = 0; i < N; i++) { /* second order: h^2 times a third derivative of order 30 */
      ck_assert_double_eq_tol(at.dzeta[i], (plus.zeta[i] - minus.zeta[i]) / (2.0 * h), 1e-6);
    }
  }
}
END_TEST

START_TEST(the_general_template_steps_damage_by_the_trapezoidal_rule) {
  const mlaw_damage *law = open_plugin(TEMPLATES "/general_damage_law.so")->damage[0];
  const double before[2] = {0.7, 1.4}, now[2] = {1.4, 0.2}, d0[2] = {0.1, 0.2}, state0[2] = {3.0, 4.0};
  const double *chan0[MLAW_N_CHANNELS] = {[MLAW_T1] = before}, *chan[MLAW_N_CHANNELS] = {[MLAW_T1] = now};
  double d1[2], state1[2];
  mlaw_error err;
  const mlaw_damage_args args = {.size = sizeof args,
                                 .n_channels = MLAW_N_CHANNELS,
                                 .n = 2,
                                 .ld = 2,
                                 .dt = 0.5,
                                 .param = UNIFORM,
                                 .chan0 = chan0,
                                 .chan = chan,
                                 .d0 = d0,
                                 .state0 = state0,
                                 .state1 = state1,
                                 .d1 = d1,
                                 .err = &err};
  ck_assert_int_eq(law->update(&args), MLAW_OK);
  /* strength 0.7: excess 0 then 1, and 1 then 0; tau 1.9 */
  ck_assert_double_eq_tol(d1[0], 0.1 + 0.5 * 0.5 / 1.9, 1e-15);
  ck_assert_double_eq_tol(d1[1], 0.2 + 0.5 * 0.5 / 1.9, 1e-15);
  ck_assert_double_eq(state1[0], 3.5);
  ck_assert_double_eq(state1[1], 4.0);
}
END_TEST

int main(void) {
  return suite_run("laws",
                   (SuiteTests){derivatives_of_energy_agree_with_differences,
                                a_uniform_parameter_and_the_same_value_at_each_point_give_the_same_bits,
                                a_parameter_of_each_point_reaches_its_own_point,
                                threshold_vanishes_at_the_damage_that_evolution_gives,
                                the_slope_of_evolution_agrees_with_differences,
                                the_general_template_steps_damage_by_the_trapezoidal_rule, NULL});
}
