/* The damage laws of plugins/damage through their shared objects and the host: those of one drive with linear
 * hardening (onset, evolution, irreversibility, unloading and reloading, steps cut into parts); and, for all
 * damage laws, what holds on any path. */
#include "damage_point.h"
#include "random.h"
#include "suite.h"

/* ---- Laws of one drive with linear hardening ---- */

typedef struct {
  const char *law, *onset, *range;
  double start; /* the drive at rest */
  void (*set)(double drive, double chan[MLAW_N_CHANNELS]);
} Drive;

static void set_tension(double T, double chan[MLAW_N_CHANNELS]) {
  chan[MLAW_T1] = T;
}
static void set_stretch(double l, double chan[MLAW_N_CHANNELS]) {
  chan[MLAW_L1] = l;
}
static void set_area_strain(double alpha, double chan[MLAW_N_CHANNELS]) {
  chan[MLAW_I2] = (1.0 + alpha) * (1.0 + alpha) - 1.0;
}
static void set_thickness_lost(double eta, double chan[MLAW_N_CHANNELS]) {
  chan[MLAW_I2] = 1.0 / ((1.0 - eta) * (1.0 - eta)) - 1.0;
}
static void set_shear(double S, double chan[MLAW_N_CHANNELS]) {
  chan[MLAW_T1] = 0.7 + S;
  chan[MLAW_T2] = 0.7 - S;
}

static const Drive drives[] = {{"rankine", "T_D", "T_C", 0.0, set_tension},
                               {"max_stretch", "L_D", "L_C", 1.0, set_stretch},
                               {"area_dilation", "alpha_D", "alpha_C", 0.0, set_area_strain},
                               {"thinning", "eta_D", "eta_C", 0.0, set_thickness_lost},
                               {"max_shear", "S_D", "S_C", 0.0, set_shear}};
enum { N_DRIVES = sizeof drives / sizeof *drives };

/* Damage from `start` + 0.1 on, full at `start` + 0.1 + range. */
static DamagePoint driven(const Drive *drive, double range) {
  SceneParameter parameters[] = {number(drive->onset, drive->start + 0.1), number(drive->range, range)};
  return damage_point(drive->law, parameters, 2);
}

static double drive_to(DamagePoint *point, const Drive *drive, double value) {
  double chan[MLAW_N_CHANNELS];
  memcpy(chan, point->chan, sizeof chan);
  drive->set(drive->start + value, chan);
  return damage_step(point, chan, 0.1);
}

/* Rounding of the channels, 1e-16 of numbers up to 10, over a range of 0.4. */
static const double ROUNDING = 1e-14;

START_TEST(damage_starts_at_the_onset_and_is_linear_in_the_drive) {
  for (int k = 0; k < N_DRIVES; k++) {
    DamagePoint point = driven(&drives[k], 0.4);
    ck_assert_double_eq(drive_to(&point, &drives[k], 0.0), 0.0);
    ck_assert_double_eq(drive_to(&point, &drives[k], 0.1 - 1e-12), 0.0);
    ck_assert_double_gt(drive_to(&point, &drives[k], 0.1 + 1e-12), 0.0);
    for (int i = 1; i <= 40; i++)
      ck_assert_double_eq_tol(drive_to(&point, &drives[k], 0.1 + 0.01 * i), 0.01 * i / 0.4, ROUNDING);
    ck_assert_double_eq(drive_to(&point, &drives[k], 0.6), 1.0);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(unloading_keeps_damage_and_reloading_resumes_it_where_it_stopped) {
  for (int k = 0; k < N_DRIVES; k++) {
    DamagePoint point = driven(&drives[k], 0.4);
    const double d = drive_to(&point, &drives[k], 0.3);
    ck_assert_double_eq_tol(d, 0.5, ROUNDING);
    ck_assert_double_eq(drive_to(&point, &drives[k], 0.0), d);
    ck_assert_double_eq(drive_to(&point, &drives[k], -0.2), d);
    ck_assert_double_eq(drive_to(&point, &drives[k], 0.3 - 1e-12), d);
    ck_assert_double_eq_tol(point.state[0], drives[k].start + 0.3, ROUNDING); /* the largest drive so far */
    ck_assert_double_eq_tol(drive_to(&point, &drives[k], 0.34), 0.6, ROUNDING);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(a_path_cut_into_steps_gives_the_same_bits) {
  for (int k = 0; k < N_DRIVES; k++) {
    DamagePoint whole = driven(&drives[k], 0.4), cut = whole;
    for (int i = 1; i <= 100; i++) drive_to(&cut, &drives[k], 0.37 * i / 100.0);
    drive_to(&whole, &drives[k], 0.37);
    ck_assert_double_eq(cut.d, whole.d);
    ck_assert_double_eq(cut.state[0], whole.state[0]);
    material_free(&whole.material);
  }
}
END_TEST

START_TEST(without_hardening_the_first_drive_beyond_the_onset_breaks) {
  for (int k = 0; k < N_DRIVES; k++) {
    DamagePoint point = driven(&drives[k], 0.0);
    ck_assert_double_eq(drive_to(&point, &drives[k], 0.1 - 1e-12), 0.0);
    ck_assert_double_eq(drive_to(&point, &drives[k], 0.1 + 1e-12), 1.0);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(thinning_and_area_dilation_start_at_the_same_stretch) {
  SceneParameter area[] = {number("alpha_D", 0.25), number("alpha_C", 1.0)},
                 thickness[] = {number("eta_D", 0.2), number("eta_C", 1.0)}; /* 1 - 1/1.25 = 0.2 */
  DamagePoint dilated = damage_point("area_dilation", area, 2), thin = damage_point("thinning", thickness, 2);
  const double below = 1.25 * 1.25 * (1.0 - 1e-12) - 1.0, beyond = 1.25 * 1.25 * (1.0 + 1e-12) - 1.0;
  ck_assert_double_eq(damage_drive(&dilated, MLAW_I2, below, 0.1), 0.0);
  ck_assert_double_eq(damage_drive(&thin, MLAW_I2, below, 0.1), 0.0);
  ck_assert_double_gt(damage_drive(&dilated, MLAW_I2, beyond, 0.1), 0.0);
  ck_assert_double_gt(damage_drive(&thin, MLAW_I2, beyond, 0.1), 0.0);
  material_free(&dilated.material);
  material_free(&thin.material);
}
END_TEST

START_TEST(inflation_has_no_shear_to_break_by) {
  SceneParameter parameters[] = {number("S_D", 0.01), number("S_C", 0.1)};
  DamagePoint point = damage_point("max_shear", parameters, 2);
  const double inflated[MLAW_N_CHANNELS] = {[MLAW_T1] = 5.0, [MLAW_T2] = 5.0};
  ck_assert_double_eq(damage_step(&point, inflated, 0.1), 0.0);
  material_free(&point.material);
}
END_TEST

/* ---- All laws, on any path ---- */

static DamagePoint each_law(int k) {
  SceneParameter energy[] = {number("Y_D", 0.2), number("Y_C", 2.0)};
  SceneParameter weibull[] = {number("Y_0", 1.0), number("m", 3.0)};
  SceneParameter log_normal[] = {number("Y_50", 1.0), number("s", 0.5)};
  SceneParameter delay[] = {number("Y_D", 0.2), number("Y_C", 2.0), number("tau_c", 0.7)};
  SceneParameter creep[] = {number("T_R", 1.0), number("tau", 30.0)};
  SceneParameter fatigue[] = {number("T_E", 0.2), number("T_F", 4.0)};
  SceneParameter quartiles[] = {number("Y_0", 0.1), number("Y_25", 0.3), number("Y_50", 0.4),
                                number("Y_75", 0.8), number("Y_100", 2.0)};
  if (k < N_DRIVES) return driven(&drives[k], 0.6);
  switch (k - N_DRIVES) {
  case 0:
    return damage_point("power", energy, 2);
  case 1:
    return damage_point("exponential", energy, 2);
  case 2:
    return damage_point("fibre_bundle", energy, 2);
  case 3:
    return damage_point("fibre_weibull", weibull, 2);
  case 4:
    return damage_point("fibre_log_normal", log_normal, 2);
  case 5:
    return damage_point("fibre_quartiles", quartiles, 5);
  case 6:
    return damage_point("delay", delay, 3);
  case 7:
    return damage_point("creep", creep, 2);
  default:
    return damage_point("fatigue", fatigue, 2);
  }
}
enum { N_LAWS = N_DRIVES + 9 };

/* Of a neo-Hookean membrane. */
static void set_channels(double l1, double l2, double chan[MLAW_N_CHANNELS]) {
  const double most = fmax(l1, l2), least = fmin(l1, l2), J3 = pow(l1 * l2, 3.0);
  chan[MLAW_I1] = l1 * l1 + l2 * l2 - 2.0;
  chan[MLAW_I2] = l1 * l1 * l2 * l2 - 1.0;
  chan[MLAW_Y] = 0.5 * (chan[MLAW_I1] - chan[MLAW_I2] / (1.0 + chan[MLAW_I2]));
  chan[MLAW_L1] = most;
  chan[MLAW_L2] = least;
  chan[MLAW_T1] = most / least - 1.0 / J3;
  chan[MLAW_T2] = least / most - 1.0 / J3;
}

START_TEST(on_a_random_path_damage_never_falls_and_dissipation_is_not_negative) {
  for (int k = 0; k < N_LAWS; k++) {
    uint64_t state = 1981;
    DamagePoint point = each_law(k);
    double l1 = 1.0, l2 = 1.0, dissipated = 0.0;
    for (int i = 0; i < 400; i++) {
      double chan[MLAW_N_CHANNELS];
      const double before = point.d;
      l1 = fmin(1.5, fmax(0.8, l1 + 0.05 * random_uniform(&state)));
      l2 = fmin(1.5, fmax(0.8, l2 + 0.05 * random_uniform(&state)));
      set_channels(l1, l2, chan);
      const double d = damage_step(&point, chan, 0.05), power = chan[MLAW_Y] * (d - before);
      ck_assert_double_ge(d, before);
      ck_assert_double_le(d, 1.0);
      ck_assert_double_ge(power, 0.0);
      dissipated += power;
    }
    ck_assert_msg(dissipated > 0.0, "law %d: the path does no damage", k);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(a_step_of_no_length_to_the_same_state_changes_nothing) {
  for (int k = 0; k < N_LAWS; k++) {
    DamagePoint point = each_law(k);
    double chan[MLAW_N_CHANNELS];
    set_channels(1.4, 1.2, chan);
    for (int i = 0; i < 10; i++) damage_step(&point, chan, 0.1);
    const DamagePoint before = point;
    damage_step(&point, chan, 0.0);
    ck_assert_double_eq(point.d, before.d);
    ck_assert_mem_eq(point.state, before.state, sizeof point.state);
    material_free(&point.material);
  }
}
END_TEST

START_TEST(huge_stretches_and_steps_give_finite_damage) {
  for (int k = 0; k < N_LAWS; k++) {
    DamagePoint point = each_law(k);
    double chan[MLAW_N_CHANNELS];
    for (double stretch = 1e-3; stretch < 1e16; stretch *= 1e3) {
      set_channels(stretch, stretch, chan);
      damage_step(&point, chan, 0.0); /* material_damage refuses what is not finite */
      damage_step(&point, chan, 1e12);
      set_channels(stretch, 1.0, chan);
      damage_step(&point, chan, 1e-12);
    }
    ck_assert_double_ge(point.d, 0.0);
    material_free(&point.material);
  }
}
END_TEST

int main(void) {
  return suite_run("damage laws",
                   (SuiteTests){damage_starts_at_the_onset_and_is_linear_in_the_drive,
                                unloading_keeps_damage_and_reloading_resumes_it_where_it_stopped,
                                a_path_cut_into_steps_gives_the_same_bits,
                                without_hardening_the_first_drive_beyond_the_onset_breaks,
                                thinning_and_area_dilation_start_at_the_same_stretch,
                                inflation_has_no_shear_to_break_by,
                                on_a_random_path_damage_never_falls_and_dissipation_is_not_negative,
                                a_step_of_no_length_to_the_same_state_changes_nothing,
                                huge_stretches_and_steps_give_finite_damage, NULL});
}
