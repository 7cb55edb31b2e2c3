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

int main(void) {
  return suite_run("law_timing", (SuiteTests){a_law_of_every_kind_has_a_cost,
                                              the_table_has_a_row_for_every_law_that_ships, NULL});
}
