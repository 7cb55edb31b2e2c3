/* What the checker says of laws with faults that are too small for a plugin of their own: each is a sound law
 * with one function spoiled, handed to one test. */
#include "broken/fixture.h"
#include "laws/conformance_test.h"
#include "suite.h"
#include <stdio.h>
#include <string.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

ONE_PARAMETER("G_s");
enum { BATCH = 8 }; /* the checker's own batches are longer, and its trials have one point */

static const ConformanceTest *find(const char *group, const char *name) {
  const ConformanceGroup *const groups[] = {&conformance_load, &conformance_contract, &conformance_energy,
                                            &conformance_damage};
  for (int g = 0; g < 4; g++)
    for (size_t i = 0; i < groups[g]->n; i++)
      if (strcmp(groups[g]->name, group) == 0 && strcmp(groups[g]->test[i].name, name) == 0)
        return &groups[g]->test[i];
  ck_abort_msg("no test is called %s/%s", group, name);
  return NULL;
}

static void expect_verdict(const Subject *subject, const char *group, const char *name,
                           ConformanceOutcome outcome, const char *words) {
  const Verdict found = find(group, name)->run(subject);
  ck_assert_msg(found.outcome == outcome, "%s: %s: %s", name, conformance_outcome_name(found.outcome),
                found.text);
  ck_assert_msg(strstr(found.text, words) != NULL, "%s: expected `%s` in `%s`", name, words, found.text);
}

static Subject energy_subject(const mlaw_energy *law) {
  return (Subject){.energy = law, .table = law_describe_energy(law)};
}

static Subject damage_subject(const mlaw_damage *law) {
  return (Subject){.damage = law, .table = law_describe_damage(law)};
}

/* The test GROUP/NAME fails on the neo-Hookean law with this in place of its eval. */
static void expect_failed(int (*eval)(const mlaw_energy_args *), const char *group, const char *name,
                          const char *words) {
  const mlaw_energy law = {ALIKE(mlaw_energy, "stub"), .eval = eval};
  const Subject subject = energy_subject(&law);
  expect_verdict(&subject, group, name, CONFORMANCE_FAILED, words);
}

/* ---- Where a law writes ---- */

static int before_the_first_row(const mlaw_energy_args *a) {
  double *row = a->phi;
  if (a->n > BATCH) row[-1] = 0;
  return sound_eval(a);
}

static int beyond_the_last_row(const mlaw_energy_args *a) {
  if (a->n > BATCH) a->dphi[2 * a->ld] = 0;
  return sound_eval(a);
}

static int first_point_always(const mlaw_energy_args *a) {
  a->phi[0] = 0;
  return sound_eval(a);
}

static int never_without_slope(const mlaw_energy_args *a) {
  if (!a->dphi) return mlaw_fail(a->err, MLAW_BADARG, -1, "phi comes with its slopes");
  return sound_eval(a);
}

START_TEST(a_law_writes_what_is_asked_for_and_nothing_else) {
  expect_failed(before_the_first_row, "contract", "no-overrun",
                "expected writes within the arrays, found one outside");
  expect_failed(beyond_the_last_row, "contract", "no-overrun",
                "expected writes within the arrays, found one beyond the last row");
  expect_failed(first_point_always, "contract", "n-zero", "expected nothing written for n = 0");
  expect_failed(never_without_slope, "contract", "null-outputs",
                "expected status 0 without phi_1, found -2: phi comes with its slopes");
}
END_TEST

/* ---- What a law takes ---- */

static int uniform_only(const mlaw_energy_args *a) {
  if (a->param[0].inc) return mlaw_fail(a->err, MLAW_BADARG, -1, "parameters that vary");
  return sound_eval(a);
}

static int one_by_one(const mlaw_energy_args *a) {
  if (a->n > 1) return mlaw_fail(a->err, MLAW_BADARG, 1, "more than one point");
  return sound_eval(a);
}

static int nothing(const mlaw_energy_args *a) {
  return mlaw_fail(a->err, MLAW_DOMAIN, 0, "never");
}

static int not_at_rest(const mlaw_energy_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++)
    if (a->I1[i] == 0.0 && a->I2[i] == 0.0) return mlaw_fail(a->err, MLAW_DOMAIN, i, "at rest");
  return sound_eval(a);
}

static int not_next_to_rest(const mlaw_energy_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++)
    if (a->I1[i] != 0.0 && fabs(a->I1[i]) < 0.01) return mlaw_fail(a->err, MLAW_DOMAIN, i, "next to rest");
  return sound_eval(a);
}

START_TEST(a_law_takes_what_a_run_may_hand_it) {
  expect_failed(uniform_only, "contract", "uniform-equals-per-point",
                "expected status 0 with a parameter for each point, found -2");
  expect_failed(uniform_only, "contract", "own-parameter-per-point",
                "expected status 0 with parameters that vary, found -2");
  expect_failed(one_by_one, "contract", "no-hole",
                "expected status 0 on points that it takes one by one, found -2 at point 1: more than one");
  expect_failed(nothing, "contract", "no-hole", "some strains near rest, found that it refuses all");
  expect_failed(not_at_rest, "energy", "zero-at-rest", "the state at rest, found that it refuses");
  expect_failed(not_next_to_rest, "energy", "positive-moduli",
                "expected the law to take strains of 0.001 about rest, found a refusal");
}
END_TEST

/* 1 is the strength that laws of this file have by default. */
static int default_only(const mlaw_damage_args *a) {
  if (mlaw_at(a->param[0], 0) != 1.0) return mlaw_fail(a->err, MLAW_BADPARAM, -1, "another strength");
  return sound_threshold(a);
}

START_TEST(points_that_other_parameters_do_not_allow_are_left_out) {
  const mlaw_damage law = {ALIKE(mlaw_damage, "stub"), .needs = 1u << MLAW_Y, .threshold = default_only,
                           .evolution = sound_evolution};
  const Subject subject = damage_subject(&law);
  expect_verdict(&subject, "contract", "own-parameter-per-point", CONFORMANCE_SKIPPED,
                 "does not take the same points with other parameters");
}
END_TEST

START_TEST(tests_that_a_law_gives_no_occasion_for_are_left_out) {
  const mlaw_energy law = {ALIKE(mlaw_energy, "stub"), .eval = sound_eval};
  const Subject subject = energy_subject(&law);
  expect_verdict(&subject, "contract", "domain-error-names-point", CONFORMANCE_SKIPPED,
                 "the law refuses no stretch up to 10000");
  expect_verdict(&subject, "energy", "hessian-matches-differences", CONFORMANCE_SKIPPED,
                 "the law gives no second derivatives");
}
END_TEST

/* ---- Rest ---- */

static int with_energy_at_rest(const mlaw_energy_args *a) {
  const int status = sound_eval(a);
  for (ptrdiff_t i = 0; i < a->n; i++)
    if (a->phi) a->phi[i] += 1.0;
  return status;
}

static int beyond_threshold_at_rest(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) a->f[i] = a->chan[MLAW_Y][i] + 1.0 - a->d0[i];
  return MLAW_OK;
}

static int damaged_at_rest(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    a->zeta[i] = a->chan[MLAW_Y][i] + 1.0;
    if (a->dzeta) a->dzeta[i] = 1.0;
  }
  return MLAW_OK;
}

static int age(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) a->d1[i] = a->d0[i] + 0.25 * a->dt;
  return MLAW_OK;
}

START_TEST(a_membrane_at_rest_has_no_energy_and_no_damage) {
  expect_failed(with_energy_at_rest, "energy", "zero-at-rest", "expected phi = 0 at rest, found 1");
  const mlaw_damage weak = {ALIKE(mlaw_damage, "stub"), .needs = 1u << MLAW_Y,
                            .threshold = beyond_threshold_at_rest, .evolution = damaged_at_rest};
  Subject subject = damage_subject(&weak);
  expect_verdict(&subject, "damage", "zero-at-start", CONFORMANCE_FAILED,
                 "expected no damage at Y = 0 (zeta <= 0, f <= 0), found zeta = 1, f = 1");
  const mlaw_damage mortal = {ALIKE(mlaw_damage, "stub"), .needs = 1u << MLAW_Y, .update = age};
  subject = damage_subject(&mortal);
  expect_verdict(&subject, "damage", "rest-stays-sound", CONFORMANCE_FAILED,
                 "expected a sound membrane at rest to stay sound, found d = 0.25");
}
END_TEST

/* ---- Parameters ---- */

static int refuse_all(const double *param, mlaw_error *err) {
  (void)param;
  return mlaw_fail(err, MLAW_BADPARAM, -1, "never");
}

static int over_the_modulus(const mlaw_energy_args *a) {
  const int status = sound_eval(a);
  for (ptrdiff_t i = 0; i < a->n; i++)
    if (a->phi) a->phi[i] = a->I1[i] / mlaw_at(a->param[0], i);
  return status;
}

START_TEST(a_law_has_parameters_that_can_be_used) {
  mlaw_energy law = {ALIKE(mlaw_energy, "stub"), .eval = sound_eval};
  law.check = refuse_all;
  Subject subject = energy_subject(&law);
  expect_verdict(&subject, "contract", "no-hole", CONFORMANCE_FAILED,
                 "expected check() to accept some parameters of the calibrated range, found none");

  mlaw_param closed = params[0];
  closed.flags = 0; /* a modulus of 0 is allowed, and divided by */
  law = (mlaw_energy){ALIKE(mlaw_energy, "stub"), .eval = over_the_modulus};
  law.params = &closed;
  subject = energy_subject(&law);
  expect_verdict(&subject, "contract", "finite-at-bounds", CONFORMANCE_FAILED,
                 "expected a finite phi with G_s = 0, which its range allows, found ");

  law = (mlaw_energy){ALIKE(mlaw_energy, "stub"), .eval = sound_eval};
  law.n_params = 65;
  subject = energy_subject(&law);
  expect_verdict(&subject, "contract", "no-hole", CONFORMANCE_FAILED,
                 "expected at most 64 parameters and 16 variables, found more");
}
END_TEST

/* ---- The process ---- */

#if defined(__SSE2__)
static int flush(const mlaw_energy_args *a) {
  _mm_setcsr(_mm_getcsr() | 0x8000u);
  return sound_eval(a);
}

START_TEST(a_kernel_leaves_subnormal_numbers_alone) {
  const unsigned before = _mm_getcsr();
  expect_failed(flush, "contract", "fp-mode-kept", "found subnormal numbers flushed");
  _mm_setcsr(before);
}
END_TEST
#endif

START_TEST(a_file_that_cannot_be_read_as_a_plugin_is_told_by_each_test_of_files) {
  const Subject subject = {.file = "/dev/null"};
  expect_verdict(&subject, "load", "only-entry-exported", CONFORMANCE_SKIPPED, "/dev/null: ");
  expect_verdict(&subject, "load", "no-forbidden-import", CONFORMANCE_SKIPPED, "/dev/null: ");
  expect_verdict(&subject, "load", "fp-mode-unchanged", CONFORMANCE_FAILED, "cannot be opened: ");
}
END_TEST

int main(void) {
  return suite_run(
      "conformance_verdicts", (SuiteTests) {
        a_law_writes_what_is_asked_for_and_nothing_else, a_law_takes_what_a_run_may_hand_it,
            points_that_other_parameters_do_not_allow_are_left_out,
            tests_that_a_law_gives_no_occasion_for_are_left_out,
            a_membrane_at_rest_has_no_energy_and_no_damage, a_law_has_parameters_that_can_be_used,
#if defined(__SSE2__)
            a_kernel_leaves_subnormal_numbers_alone,
#endif
            a_file_that_cannot_be_read_as_a_plugin_is_told_by_each_test_of_files, NULL
      });
}
