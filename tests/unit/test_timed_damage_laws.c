/* The damage laws of plugins/damage that know time or cycles (delay, creep, fatigue), through their shared
 * objects and the host: exact solutions, order in the step, limits, counts of cycles. */
#include "damage_point.h"
#include "suite.h"

/* ---- Delay ---- */

static const double Y_D = 0.2, Y_C = 2.0, TAU_C = 0.7, SHARPNESS = 3.0;

static DamagePoint delayed(double tau_c) {
  SceneParameter parameters[] = {number("Y_D", Y_D), number("Y_C", Y_C), number("tau_c", tau_c),
                                 number("a", SHARPNESS)};
  return damage_point("delay", parameters, 4);
}

/* dd/dt of the law as it is published. */
static double delay_rate(double Y, double d) {
  const double behind = fmax(Y - Y_D, 0.0) / Y_C - d;
  return behind > 0.0 ? (1.0 - exp(-SHARPNESS * behind)) / TAU_C : 0.0;
}

static double constant_Y(double t) {
  (void)t;
  return 1.6;
}
static double rising_Y(double t) {
  return 0.3 + t * t;
}
static double falling_Y(double t) {
  return 2.0 * exp(-t);
}

/* The classical Runge-Kutta method with 2000 steps: error below 1e-13. */
static double delay_reference(double (*Y)(double), double end) {
  const int n = 2000;
  const double h = end / n;
  double d = 0.0;
  for (int i = 0; i < n; i++) {
    const double t = i * h;
    const double k1 = delay_rate(Y(t), d), k2 = delay_rate(Y(t + 0.5 * h), d + 0.5 * h * k1),
                 k3 = delay_rate(Y(t + 0.5 * h), d + 0.5 * h * k2), k4 = delay_rate(Y(t + h), d + h * k3);
    d += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return d;
}

static double delay_along(double (*Y)(double), double end, int n) {
  DamagePoint point = delayed(TAU_C);
  damage_drive(&point, MLAW_Y, Y(0.0), 0.0);
  for (int i = 1; i <= n; i++) damage_drive(&point, MLAW_Y, Y(end * i / n), end / n);
  material_free(&point.material);
  return point.d;
}

START_TEST(under_constant_energy_the_delay_is_exact_in_steps_of_any_length) {
  for (double end = 0.01; end < 10.0; end *= 3.0) {
    const double exact = delay_reference(constant_Y, end);
    ck_assert_double_eq_tol(delay_along(constant_Y, end, 1), exact, 1e-12);
    ck_assert_double_eq_tol(delay_along(constant_Y, end, 7), exact, 1e-12);
  }
}
END_TEST

START_TEST(along_a_path_the_delay_converges_at_second_order) {
  double (*const paths[])(double) = {rising_Y, falling_Y};
  const double end = 0.5; /* before the falling one meets d, where the order is two with a wobble */
  for (int k = 0; k < 2; k++) {
    const double exact = delay_reference(paths[k], end);
    const double coarse = fabs(delay_along(paths[k], end, 16) - exact),
                 fine = fabs(delay_along(paths[k], end, 32) - exact);
    ck_assert_double_gt(fine, 1e-7); /* not rounding */
    ck_assert_double_eq_tol(coarse / fine, 4.0, 0.1);
  }
}
END_TEST

START_TEST(the_delay_bounds_the_rate_of_damage) {
  DamagePoint point = delayed(TAU_C);
  damage_drive(&point, MLAW_Y, 1e6, 0.0);
  for (int i = 1; i <= 6; i++) /* full speed: w/a is 1e5 */
    ck_assert_double_eq_tol(damage_drive(&point, MLAW_Y, 1e6, 0.1), 0.1 * i / TAU_C, 1e-12);
  ck_assert_double_eq(damage_drive(&point, MLAW_Y, 1e6, 0.2), 1.0);
  material_free(&point.material);
}
END_TEST

START_TEST(without_delay_damage_is_that_of_marigo) {
  DamagePoint point = delayed(1e-9);
  damage_drive(&point, MLAW_Y, 1.2, 0.0);
  ck_assert_double_eq_tol(damage_drive(&point, MLAW_Y, 1.2, 0.1), 0.5, 1e-14);
  material_free(&point.material);
}
END_TEST

START_TEST(below_its_threshold_the_delayed_law_does_nothing_for_ever) {
  DamagePoint point = delayed(TAU_C);
  for (int i = 0; i < 100; i++) ck_assert_double_eq(damage_drive(&point, MLAW_Y, Y_D, 1e6), 0.0);
  material_free(&point.material);
}
END_TEST

/* ---- Creep ---- */

static const double T_R = 1.5, TAU = 2.0;

static DamagePoint creeping(double r, double k, double T_D) {
  SceneParameter parameters[] = {number("T_R", T_R), number("tau", TAU), number("r", r), number("k", k),
                                 number("T_D", T_D)};
  return damage_point("creep", parameters, 5);
}

/* Under a constant tension T of the undamaged membrane, (1 - d)^m falls at the rate m (T/T_R)^r/tau. */
static double creep_solution(double r, double k, double T, double t) {
  const double m = k - r + 1.0, growth = pow(T / T_R, r) * t / TAU;
  if (m == 0.0) return 1.0 - exp(-growth);
  return 1.0 - pow(fmax(1.0 - m * growth, 0.0), 1.0 / m);
}

START_TEST(under_constant_effective_tension_creep_is_exact_in_steps_of_any_length) {
  const double r = 3.0, T = 1.2;
  for (double k = 0.0; k <= 6.0; k += 0.5) { /* m from -2 to 4 */
    for (int n = 1; n <= 64; n *= 8) {
      DamagePoint point = creeping(r, k, 0.0);
      damage_drive(&point, MLAW_T1, T, 0.0);
      for (int i = 1; i <= n; i++) {
        const double d = damage_drive(&point, MLAW_T1, T, 1.0 / n);
        const double exact = creep_solution(r, k, T, (double)i / n);
        ck_assert_double_eq_tol(d, exact, 1e-13);
      }
      material_free(&point.material);
    }
  }
}
END_TEST

START_TEST(creep_ruptures_in_finite_time_or_never_as_its_exponents_say) {
  DamagePoint kachanov = creeping(3.0, 3.0, 0.0), slow = creeping(3.0, 1.0, 0.0);
  damage_drive(&kachanov, MLAW_T1, T_R, 0.0);
  ck_assert_double_lt(damage_drive(&kachanov, MLAW_T1, T_R, TAU * (1.0 - 1e-9)), 1.0);
  ck_assert_double_eq(damage_drive(&kachanov, MLAW_T1, T_R, TAU * 2e-9), 1.0);
  damage_drive(&slow, MLAW_T1, T_R, 0.0);
  const double d = damage_drive(&slow, MLAW_T1, T_R, 100.0 * TAU); /* m = -1: 1 - d = 1/(1 + t/tau) */
  ck_assert_double_eq_tol(d, 100.0 / 101.0, 1e-13);
  material_free(&kachanov.material);
  material_free(&slow.material);
}
END_TEST

/* The rate factor t^4 of a tension that grows in time, for Kachanov's exponents: d = t^5/(5 tau). */
static double creep_ramp(int n) {
  DamagePoint point = creeping(4.0, 4.0, 0.0);
  for (int i = 1; i <= n; i++) damage_drive(&point, MLAW_T1, T_R * i / n, 1.0 / n);
  material_free(&point.material);
  return point.d;
}

START_TEST(along_a_rising_tension_creep_converges_at_second_order) {
  const double exact = 1.0 / (5.0 * TAU), coarse = fabs(creep_ramp(32) - exact),
               fine = fabs(creep_ramp(64) - exact);
  ck_assert_double_eq_tol(coarse / fine, 4.0, 0.05);
}
END_TEST

/* Kachanov's experiment: the carried tension is kept, hence that of the undamaged membrane is sigma/(1 - d).
 */
static double kachanov_experiment(double sigma, double r, double end, int n) {
  DamagePoint point = creeping(r, r, 0.0);
  damage_drive(&point, MLAW_T1, sigma, 0.0);
  for (int i = 1; i <= n; i++) {
    DamagePoint trial = point; /* the tension at the end of the step from a trial step */
    const double d = damage_drive(&trial, MLAW_T1, sigma / (1.0 - point.d), end / n);
    damage_drive(&point, MLAW_T1, sigma / (1.0 - d), end / n);
  }
  material_free(&point.material);
  return point.d;
}

START_TEST(under_constant_carried_tension_creep_accelerates_as_kachanov_found) {
  const double sigma = 1.1, r = 3.0, t_rupture = TAU / (r + 1.0) * pow(T_R / sigma, r), end = 0.9 * t_rupture;
  const double exact = 1.0 - pow(1.0 - end / t_rupture, 1.0 / (r + 1.0));
  const double coarse = fabs(kachanov_experiment(sigma, r, end, 200) - exact),
               fine = fabs(kachanov_experiment(sigma, r, end, 400) - exact);
  ck_assert_double_lt(fine, 1e-4);
  ck_assert_double_gt(coarse / fine, 3.5); /* second order */
}
END_TEST

START_TEST(below_its_threshold_tension_does_no_harm_for_ever) {
  DamagePoint point = creeping(4.0, 4.0, 0.5);
  for (int i = 0; i < 100; i++) ck_assert_double_eq(damage_drive(&point, MLAW_T1, 0.5, 1e6), 0.0);
  for (int i = 0; i < 100; i++) ck_assert_double_eq(damage_drive(&point, MLAW_T1, -5.0, 1e6), 0.0);
  damage_drive(&point, MLAW_T1, 0.5 + T_R, 0.0);
  ck_assert_double_eq_tol(damage_drive(&point, MLAW_T1, 0.5 + T_R, 0.1), 0.1 / TAU, 1e-15);
  material_free(&point.material);
}
END_TEST

/* ---- Fatigue ---- */

static const double T_E = 0.2, T_F = 2.0, M = 3.0;
enum { LOW, HIGH, CYCLES };

static DamagePoint fatigued(void) {
  SceneParameter parameters[] = {number("T_E", T_E), number("T_F", T_F), number("m", M)};
  return damage_point("fatigue", parameters, 3);
}

/* Damage of one cycle: Basquin's line beyond the endurance limit. */
static double basquin(double range) {
  return range > T_E ? pow((range - T_E) / T_F, M) : 0.0;
}

static void cycle(DamagePoint *point, double low, double high, int steps) {
  for (int i = 1; i <= steps; i++) damage_drive(point, MLAW_T1, low + (high - low) * i / steps, 0.1);
  for (int i = 1; i <= steps; i++) damage_drive(point, MLAW_T1, high + (low - high) * i / steps, 0.1);
}

START_TEST(cycles_of_constant_range_add_up_however_they_are_cut_into_steps) {
  for (int steps = 1; steps <= 64; steps *= 4) {
    DamagePoint point = fatigued();
    for (int i = 1; i <= 20; i++) {
      cycle(&point, 0.0, 0.9, steps);
      ck_assert_double_eq_tol(point.d, i * basquin(0.9), 1e-14 * i);
      ck_assert_double_eq(point.state[CYCLES], i);
    }
    material_free(&point.material);
  }
}
END_TEST

START_TEST(the_membrane_breaks_after_as_many_cycles_as_basquin_says) {
  DamagePoint point = fatigued();
  const double range = T_E + 0.5 * T_F * (1.0 + 1e-12); /* 2^3 = 8 cycles */
  int cycles = 0;
  while (point.d < 1.0 && cycles < 100) {
    cycle(&point, 0.0, range, 16);
    cycles++;
  }
  ck_assert_int_eq(cycles, 8);
  material_free(&point.material);
}
END_TEST

START_TEST(cycles_below_the_endurance_limit_do_no_harm) {
  DamagePoint point = fatigued();
  cycle(&point, 0.0, T_E, 4);
  for (int i = 0; i < 1000; i++) cycle(&point, -0.1, T_E - 0.1 - 1e-12, 4);
  ck_assert_double_eq(point.d, 0.0);
  ck_assert_double_eq(point.state[CYCLES], 0.0);
  material_free(&point.material);
}
END_TEST

START_TEST(a_mean_tension_alone_does_no_harm_after_the_first_loading) {
  DamagePoint point = fatigued();
  const double first = damage_drive(&point, MLAW_T1, 1.0, 0.1);
  ck_assert_double_eq_tol(first, basquin(1.0), 1e-15);
  for (int i = 0; i < 100; i++) ck_assert_double_eq(damage_drive(&point, MLAW_T1, 1.0, 1e3), first);
  for (int i = 0; i < 100; i++) cycle(&point, 1.0, 1.0 - T_E, 3);
  ck_assert_double_eq(point.d, first);
  material_free(&point.material);
}
END_TEST

START_TEST(a_small_fall_does_not_cut_a_rise_in_two) {
  DamagePoint point = fatigued(), straight = fatigued();
  const double path[] = {0.5, 0.35, 0.7, 0.55, 1.0};
  for (int i = 0; i < 5; i++) damage_drive(&point, MLAW_T1, path[i], 0.1);
  damage_drive(&straight, MLAW_T1, 1.0, 0.1);
  ck_assert_double_eq_tol(point.d, straight.d, 1e-15);
  ck_assert_double_eq(point.state[CYCLES], 1.0);
  material_free(&point.material);
  material_free(&straight.material);
}
END_TEST

START_TEST(a_fall_beyond_the_endurance_limit_starts_a_new_cycle_at_its_lowest_value) {
  DamagePoint point = fatigued();
  const double path[] = {1.0, 0.6, 0.4, 0.45, 0.3, 1.2};
  for (int i = 0; i < 6; i++) damage_drive(&point, MLAW_T1, path[i], 0.1);
  ck_assert_double_eq_tol(point.d, basquin(1.0) + basquin(0.9), 1e-15);
  ck_assert_double_eq(point.state[LOW], 0.3);
  ck_assert_double_eq(point.state[HIGH], 1.2);
  ck_assert_double_eq(point.state[CYCLES], 2.0);
  material_free(&point.material);
}
END_TEST

START_TEST(blocks_of_cycles_add_up_by_the_rule_of_miner) {
  DamagePoint point = fatigued();
  for (int i = 0; i < 5; i++) cycle(&point, 0.0, 0.8, 8);
  for (int i = 0; i < 3; i++) cycle(&point, 0.0, 1.1, 8);
  ck_assert_double_eq_tol(point.d, 5.0 * basquin(0.8) + 3.0 * basquin(1.1), 1e-14);
  material_free(&point.material);
}
END_TEST

START_TEST(damage_grows_along_a_rise_without_a_jump_at_the_peak) {
  DamagePoint point = fatigued();
  cycle(&point, 0.0, 1.0, 1);
  for (int i = 1; i <= 100; i++) {
    const double T = 0.01 * i;
    ck_assert_double_eq_tol(damage_drive(&point, MLAW_T1, T, 0.1), basquin(1.0) + basquin(T), 1e-14);
  }
  material_free(&point.material);
}
END_TEST

int main(void) {
  return suite_run("timed damage laws",
                   (SuiteTests){under_constant_energy_the_delay_is_exact_in_steps_of_any_length,
                                along_a_path_the_delay_converges_at_second_order,
                                the_delay_bounds_the_rate_of_damage, without_delay_damage_is_that_of_marigo,
                                below_its_threshold_the_delayed_law_does_nothing_for_ever,
                                under_constant_effective_tension_creep_is_exact_in_steps_of_any_length,
                                creep_ruptures_in_finite_time_or_never_as_its_exponents_say,
                                along_a_rising_tension_creep_converges_at_second_order,
                                under_constant_carried_tension_creep_accelerates_as_kachanov_found,
                                below_its_threshold_tension_does_no_harm_for_ever,
                                cycles_of_constant_range_add_up_however_they_are_cut_into_steps,
                                the_membrane_breaks_after_as_many_cycles_as_basquin_says,
                                cycles_below_the_endurance_limit_do_no_harm,
                                a_mean_tension_alone_does_no_harm_after_the_first_loading,
                                a_small_fall_does_not_cut_a_rise_in_two,
                                a_fall_beyond_the_endurance_limit_starts_a_new_cycle_at_its_lowest_value,
                                blocks_of_cycles_add_up_by_the_rule_of_miner,
                                damage_grows_along_a_rise_without_a_jump_at_the_peak, NULL});
}
