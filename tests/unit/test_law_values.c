/* A value that is not finite is refused in every output of every kind of law, at the first and at the last
 * point, and named. */
#include "laws/material.h"
#include "study_file.h"
#include "suite.h"
#include <math.h>
#include <string.h>

enum { N = 9, VARS = 2 };

/* Where the laws of this file put a value that is not finite; NULL: nowhere. */
static struct {
  const char *what;
  int row, point;
  double value;
} bad;

static void answer(double *out, const char *what, int rows, double sound, int64_t n, int64_t ld) {
  for (int row = 0; row < rows; row++)
    for (int64_t i = 0; i < n; i++)
      out[row * ld + i] =
          bad.what && strcmp(bad.what, what) == 0 && row == bad.row && i == bad.point ? bad.value : sound;
}

static int stub_energy(const mlaw_energy_args *a) {
  answer(a->phi, "phi", 1, 1, a->n, a->ld);
  answer(a->dphi, "dphi", 2, 1, a->n, a->ld);
  answer(a->d2phi, "d2phi", 3, 1, a->n, a->ld);
  answer(a->state1, "state1", VARS, 1, a->n, a->ld);
  return MLAW_OK;
}

static int stub_evolution(const mlaw_damage_args *a) {
  answer(a->zeta, "zeta", 1, 0.5, a->n, a->ld);
  return MLAW_OK;
}

static int stub_update(const mlaw_damage_args *a) {
  answer(a->d1, "damage", 1, 0.5, a->n, a->ld);
  answer(a->state1, "state1", VARS, 1, a->n, a->ld);
  return MLAW_OK;
}

static const mlaw_energy ENERGY = {.id = "stub", .flags = MLAW_HESSIAN, .n_vars = VARS, .eval = stub_energy};
static const mlaw_damage EXPLICIT = {.id = "stub", .needs = 1u << MLAW_Y, .evolution = stub_evolution};
static const mlaw_damage GENERAL = {
    .id = "stub", .n_vars = VARS, .needs = 1u << MLAW_Y, .update = stub_update};

static Status ask_energy(ptrdiff_t *point, Error *error) {
  static double I1[N], I2[N], phi[N], dphi[2 * N], d2phi[3 * N], state0[VARS * N], state1[VARS * N];
  const Material material = {.elastic.energy = &ENERGY};
  const ElasticBatch batch = {.n = N,
                              .ld = N,
                              .I1 = I1,
                              .I2 = I2,
                              .state0 = state0,
                              .state1 = state1,
                              .phi = phi,
                              .dphi = dphi,
                              .d2phi = d2phi};
  return material_elastic(&material, &batch, point, error);
}

static Status ask_damage(const mlaw_damage *law, ptrdiff_t *point, Error *error) {
  static double Y0[N], Y[N], Ymax0[N], Ymax1[N], d0[N], d1[N], state0[VARS * N], state1[VARS * N];
  const Material material = {.damage.damage = law, .d_max = 1};
  for (int i = 0; i < N; i++) Y[i] = 1;
  const DamageBatch batch = {.n = N,
                             .ld = N,
                             .chan0 = {[MLAW_Y] = Y0},
                             .chan = {[MLAW_Y] = Y},
                             .Ymax0 = Ymax0,
                             .d0 = d0,
                             .state0 = state0,
                             .Ymax1 = Ymax1,
                             .d1 = d1,
                             .state1 = state1};
  return material_damage(&material, &batch, point, error);
}

static Status ask_explicit(ptrdiff_t *point, Error *error) {
  return ask_damage(&EXPLICIT, point, error);
}

static Status ask_general(ptrdiff_t *point, Error *error) {
  return ask_damage(&GENERAL, point, error);
}

typedef Status Ask(ptrdiff_t *point, Error *error);

static void expect_refused(Ask *ask, const char *what, int rows) {
  static const double values[] = {NAN, INFINITY, -INFINITY};
  for (int row = 0; row < rows; row++)
    for (int point = 0; point < N; point += N - 1)
      for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
        Error error = {.text = "nothing"};
        ptrdiff_t found;
        char words[64];
        bad.what = what;
        bad.row = row;
        bad.point = point;
        bad.value = values[k];
        ck_assert_msg(ask(&found, &error) == STATUS_REJECT, "%s %d %d: %s", what, row, point, error.text);
        ck_assert_int_eq(found, point);
        snprintf(words, sizeof words, "law stub: expected a finite %s, found", what);
        expect_words(&error, words);
      }
}

START_TEST(sound_answers_are_taken) {
  Ask *const asks[] = {ask_energy, ask_explicit, ask_general};
  bad.what = NULL;
  for (size_t k = 0; k < sizeof asks / sizeof *asks; k++) {
    Error error;
    ptrdiff_t point;
    ck_assert_int_eq(asks[k](&point, &error), STATUS_OK);
    ck_assert_int_eq(point, -1);
  }
}
END_TEST

START_TEST(an_energy_law_is_watched_in_all_it_returns) {
  expect_refused(ask_energy, "phi", 1);
  expect_refused(ask_energy, "dphi", 2);
  expect_refused(ask_energy, "d2phi", 3);
  expect_refused(ask_energy, "state1", VARS);
}
END_TEST

START_TEST(damage_laws_of_both_kinds_are_watched_in_all_they_return) {
  expect_refused(ask_explicit, "zeta", 1);
  expect_refused(ask_general, "damage", 1);
  expect_refused(ask_general, "state1", VARS);
}
END_TEST

static int names_a_point_beyond(const mlaw_energy_args *a) {
  a->err->point = a->n;
  return 1;
}

START_TEST(a_point_that_is_not_of_the_batch_is_not_passed_on) {
  static const mlaw_energy law = {.id = "stub", .eval = names_a_point_beyond};
  const double I1[N] = {0}, I2[N] = {0};
  double phi[N], dphi[2 * N];
  const Material material = {.elastic.energy = &law};
  const ElasticBatch batch = {.n = N, .ld = N, .I1 = I1, .I2 = I2, .phi = phi, .dphi = dphi};
  Error error = {.text = "nothing"};
  ptrdiff_t point;
  ck_assert_int_eq(material_elastic(&material, &batch, &point, &error), STATUS_REJECT);
  ck_assert_int_eq(point, -1);
  ck_assert_str_eq(error.text, "law stub: the law gives no reason (status 1)");
}
END_TEST

int main(void) {
  return suite_run("law_values",
                   (SuiteTests){sound_answers_are_taken, an_energy_law_is_watched_in_all_it_returns,
                                damage_laws_of_both_kinds_are_watched_in_all_they_return,
                                a_point_that_is_not_of_the_batch_is_not_passed_on, NULL});
}
