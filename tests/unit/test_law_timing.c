/* The cost of laws: that it is measured and told for every law that ships; what it is, is no test. */
#include "benchmark/law_timing.h"

#include "law_scene.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static void expect_cost(const char *id) {
  const LawSearch search = test_search();
  LoadedLaw law;
  LawTiming timing;
  Error error;
  ck_assert_int_eq(law_load(&law, LAW_ANY, id, &search, &error), STATUS_OK);
  const Status status = law_timing(&law, &timing, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  for (int k = 0; k < LAW_BATCHES; k++)
    ck_assert_msg(isfinite(timing.nanoseconds[k]) && timing.nanoseconds[k] > 0, "%s", id);
  law_release(&law);
}

START_TEST(a_law_of_every_kind_has_a_cost) {
  expect_cost("skalak");  /* energy */
  expect_cost("marigo");  /* explicit damage */
  expect_cost("fatigue"); /* general damage with history */
}
END_TEST

START_TEST(the_table_has_a_row_for_every_law_that_ships) {
  static const char *const ids[] = {"| `skalak` | energy | ", "| `marigo` | damage | ",
                                    "| `creep` | damage | "};
  Text table = {0};
  Error error;
  ck_assert_int_eq(setenv("MLAW_PLUGIN_PATH", PLUGINS, 1), 0);
  const Status status = law_timing_print(10, 7680, &table, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  for (size_t i = 0; i < sizeof ids / sizeof *ids; i++) ck_assert_ptr_nonnull(strstr(table.data, ids[i]));
  text_free(&table);
}
END_TEST

/* ---- Laws that cannot be timed ---- */

static int refuse_all(const mlaw_energy_args *a) {
  return mlaw_fail(a->err, MLAW_DOMAIN, 0, "never");
}

/* Answers single points, of which the sample is drawn, and no batch. */
static int refuse_batches(const mlaw_energy_args *a) {
  if (a->n > 1) return mlaw_fail(a->err, MLAW_BADARG, 1, "more than one point");
  for (ptrdiff_t row = 0; row < 2; row++)
    if (a->dphi) a->dphi[row * a->ld] = 0;
  if (a->phi) a->phi[0] = 0;
  return MLAW_OK;
}

static void expect_refused(int (*eval)(const mlaw_energy_args *), const char *words) {
  const mlaw_energy energy = {.size = sizeof energy, .id = "stub", .title = "", .source = "", .eval = eval};
  const LoadedLaw law = {.energy = &energy};
  LawTiming timing;
  Error error = {.text = "nothing"};
  ck_assert_int_eq(law_timing(&law, &timing, &error), STATUS_FAILED);
  ck_assert_msg(strstr(error.text, words) != NULL, "expected `%s` in `%s`", words, error.text);
}

START_TEST(a_law_that_refuses_what_it_is_timed_with_is_named) {
  expect_refused(refuse_all, "law stub: expected the law to take some strains near rest");
  expect_refused(refuse_batches, "law stub refuses the points of the conformance suite");
}
END_TEST

int main(void) {
  return suite_run("law_timing",
                   (SuiteTests){a_law_of_every_kind_has_a_cost, the_table_has_a_row_for_every_law_that_ships,
                                a_law_that_refuses_what_it_is_timed_with_is_named, NULL});
}
