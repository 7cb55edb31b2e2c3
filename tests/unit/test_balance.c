/* The energy balance of a step, on one integration point whose energies are known as functions of time. */
#include "run/balance.h"

#include "suite.h"
#include <math.h>

/* phi(t) = t^2 at a point with area 1; what d(phi) is, and how much of the power is not of the energy. */
typedef struct {
  double (*damage)(double phi);
  double excess;
  double Y, d;
  int looks;
  int failing; /* the look of this number fails */
} Point;

static Status look(void *context, double t, Instant *instant, Error *error) {
  Point *point = context;
  if (++point->looks == point->failing) return error_set(error, STATUS_FAILED, "look %d", point->looks);
  point->Y = t * t;
  point->d = point->damage ? point->damage(point->Y) : 0;
  *instant = (Instant){.t = t,
                       .power = (1 + point->excess) * (1 - point->d) * 2 * t,
                       .stored = (1 - point->d) * point->Y,
                       .Y = &point->Y,
                       .d = &point->d};
  return STATUS_OK;
}

static const double AREA = 1;

static Status take(Balance *balance, Point *point, double t0, double t1, double tolerance, Error *error) {
  Point first = {.damage = point->damage, .excess = point->excess};
  Instant start;
  ck_assert_int_eq(balance_new(balance, 1, error), STATUS_OK);
  balance->look = look;
  balance->context = point;
  balance->area = &AREA;
  ck_assert_int_eq(look(&first, t0, &start, error), STATUS_OK);
  return balance_step(balance, &start, t1, tolerance, 0, error);
}

static void must_take(Balance *balance, Point *point, double t0, double t1, double tolerance) {
  Error error;
  ck_assert_int_eq(take(balance, point, t0, t1, tolerance, &error), STATUS_OK);
  ck_assert_int_eq(balance->looks, point->looks);
}

/* ---- motions that are smooth ---- */

static double sixth_power(double t) {
  return t * t * t * t * t * t;
}

static Status look_smooth(void *context, double t, Instant *instant, Error *error) {
  (void)context;
  (void)error;
  *instant = (Instant){.t = t, .power = 6 * t * t * t * t * t, .stored = sixth_power(t)};
  return STATUS_OK;
}

/* Energy that is quadratic in positions that are cubic in time is of degree 6. */
START_TEST(quadratic_energy_on_a_cubic_motion_is_exact_in_one_part) {
  Balance balance;
  Error error;
  const double t0 = 0.3, t1 = 1.4, exact = sixth_power(t1) - sixth_power(t0);
  Instant start;
  ck_assert_int_eq(balance_new(&balance, 0, &error), STATUS_OK);
  balance.look = look_smooth;
  ck_assert_int_eq(look_smooth(NULL, t0, &start, &error), STATUS_OK);
  ck_assert_int_eq(balance_step(&balance, &start, t1, 1e-13, 0, &error), STATUS_OK);
  ck_assert_double_eq_tol(balance.work, exact, 1e-14 * exact);
  ck_assert_double_eq(balance.dissipated, 0);
  ck_assert_double_eq(balance.stored, sixth_power(t1));
  ck_assert_int_eq(balance.looks, BALANCE_NODES - 1);
  balance_free(&balance);
}
END_TEST

START_TEST(work_inside_the_step_is_the_integral_of_a_power_up_to_degree_three) {
  Balance balance;
  Point point = {0};
  must_take(&balance, &point, 0.5, 2, 1e-12);
  for (double t = 0.5; t < 2; t += 0.1)
    ck_assert_double_eq_tol(balance_work(&balance, t), t * t - 0.25, 1e-14); /* round-off */
  ck_assert_double_eq(balance_work(&balance, 2), balance.work);
  balance_free(&balance);
}
END_TEST

/* ---- damage that begins, ends or jumps inside the step ---- */

static const double Y_D = 0.2, Y_C = 0.5, D_MAX = 0.9;

static double capped(double phi) {
  return fmin(fmax((phi - Y_D) / Y_C, 0), D_MAX);
}
static double brittle(double phi) {
  return phi >= Y_D;
}

/* What it spends is known: int Y dd. */
static void check_spent(double (*damage)(double), double exact, double tolerance) {
  Balance balance;
  Point point = {.damage = damage};
  must_take(&balance, &point, 0.1, 1.5, tolerance);
  const double largest = fmax(exact, balance.stored + exact);
  const double left_over = balance.stored - 0.01 + balance.dissipated - balance.work;
  /* The bound is that of ten parts. */
  ck_assert_double_eq_tol(balance.dissipated, exact, 10 * tolerance * largest);
  ck_assert_double_eq_tol(left_over, 0, 10 * tolerance * largest);
  ck_assert_int_gt(balance.looks, BALANCE_NODES - 1);
  balance_free(&balance);
}

START_TEST(damage_that_begins_and_ends_inside_the_step_spends_what_it_should) {
  const double last = Y_D + D_MAX * Y_C, exact = (last * last - Y_D * Y_D) / (2 * Y_C);
  for (double tolerance = 1e-2; tolerance > 1e-6; tolerance /= 10) check_spent(capped, exact, tolerance);
}
END_TEST

START_TEST(damage_that_jumps_spends_all_the_energy_it_finds) {
  /* To a thousandth of the step. */
  for (double tolerance = 1e-2; tolerance > 1e-4; tolerance /= 10) check_spent(brittle, Y_D, tolerance);
}
END_TEST

/* ---- what is wrong stays ---- */

START_TEST(a_force_that_does_not_belong_to_the_energy_is_left_over_whatever_the_parts) {
  Balance balance;
  Point point = {.excess = 0.01};
  must_take(&balance, &point, 0, 1, 1e-6);
  ck_assert_double_eq_tol(balance.work - balance.stored, 0.01, 1e-12);
  ck_assert_int_le(balance.looks, 64 * (BALANCE_NODES - 1));
  balance_free(&balance);
}
END_TEST

START_TEST(a_look_that_fails_ends_the_step) {
  Balance balance;
  Error error;
  Point point = {.failing = 2};
  ck_assert_int_eq(take(&balance, &point, 0, 1, 1e-6, &error), STATUS_FAILED);
  ck_assert_str_eq(error.text, "look 2");
  balance_free(&balance);
}
END_TEST

int main(void) {
  return suite_run("balance",
                   (SuiteTests){quadratic_energy_on_a_cubic_motion_is_exact_in_one_part,
                                work_inside_the_step_is_the_integral_of_a_power_up_to_degree_three,
                                damage_that_begins_and_ends_inside_the_step_spends_what_it_should,
                                damage_that_jumps_spends_all_the_energy_it_finds,
                                a_force_that_does_not_belong_to_the_energy_is_left_over_whatever_the_parts,
                                a_look_that_fails_ends_the_step, NULL});
}
