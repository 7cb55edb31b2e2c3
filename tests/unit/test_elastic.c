/* Where the largest Y of elastic runs passes given levels, with a stand-in for the runs whose Y is known. */
#include "study/elastic.h"
#include "study_file.h"
#include "suite.h"
#include <math.h>

/* Y = Ca^2 (1 + Ca), which is no power of Ca. */
#define RUN                                                                                                  \
  "awk -v Ca=$Ca 'BEGIN { printf \"{status: steady, Y_max: %.17g}\", Ca * Ca * (1 + Ca) }' "                 \
  ">$folder/summary.json\n"
static const double LOW = 0.05, HIGH = 2, TOLERANCE = 1e-3;

static double Y(double Ca) {
  return Ca * Ca * (1 + Ca);
}

static Override setting(const char *key, const char *value) {
  return (Override){.key = key, .value = value};
}

static Elastic made(const Override *settings, size_t n) {
  Elastic elastic;
  Error error;
  ck_assert_int_eq(elastic_new(&elastic, "flow.capillary_number", settings, n, LOW, HIGH, TOLERANCE, &error),
                   STATUS_OK);
  return elastic;
}

START_TEST(points_that_differ_in_their_damage_law_alone_share_the_runs) {
  const Override settings[] = {setting("membrane.damage.parameters.Y_D", "0.2"), setting("time.end", "5"),
                               setting("membrane.damage", "{}")};
  const Override other_damage[] = {setting("time.end", "5"), setting("membrane.damage.law", "marigo")};
  const Override other_time[] = {setting("time.end", "6")}, other_key[] = {setting("membrane.damaged", "5")};
  Elastic elastic = made(settings, 3);
  const char *key = "flow.capillary_number";
  ck_assert(elastic_is_of(&elastic, key, settings, 3));
  ck_assert(elastic_is_of(&elastic, key, other_damage, 2));
  ck_assert(!elastic_is_of(&elastic, key, other_time, 1));
  ck_assert(!elastic_is_of(&elastic, key, other_key, 1));
  ck_assert(!elastic_is_of(&elastic, key, NULL, 0));
  ck_assert(!elastic_is_of(&elastic, "time.end", settings, 3));
  elastic_free(&elastic);
}
END_TEST

/* Rounds until the search is over. */
static void search(Elastic *elastic, const char *body) {
  Error error;
  Study study = study_that_varies("");
  Runner *runner;
  file_remove_folder(scratch_path("out"));
  ck_assert_int_eq(file_make_folder(scratch_path("out"), &error), STATUS_OK);
  const RunnerOptions options = {.jobs = 2, .program = stand_in(body)};
  ck_assert_int_eq(runner_new(&runner, &study, scratch_path("out"), &options, &error), STATUS_OK);
  while (!elastic->over) {
    bool moved = false;
    ck_assert_int_eq(elastic_advance(elastic, runner, &moved, &error), STATUS_OK);
    ck_assert(moved);
    ck_assert_int_eq(runner_wait_all(runner, &error), STATUS_OK);
  }
  runner_free(runner);
  study_free(&study);
}

START_TEST(every_level_is_found_within_the_tolerance_by_few_runs) {
  static const double Ca[] = {0.1234, 0.4321, 0.4331, 1.9};
  enum { N = sizeof Ca / sizeof *Ca };
  Error error;
  Elastic elastic = made(NULL, 0);
  for (int i = 0; i < N; i++) ck_assert_int_eq(elastic_add_level(&elastic, Y(Ca[i]), &error), STATUS_OK);
  search(&elastic, RUN);
  for (int i = 0; i < N; i++) ck_assert_double_eq_tol(elastic_cross(&elastic, Y(Ca[i])).x, Ca[i], TOLERANCE);
  ck_assert_ptr_null(elastic.reason);
  ck_assert_int_le(elastic.runs, 6 + 2 * N); /* halving the bracket would take 11 for each */
  elastic_free(&elastic);
}
END_TEST

/* At Ca = 1 the curve goes from 2 to 8: the level lies in the jump, where no interpolation is worth anything.
 */
START_TEST(a_jump_is_found_within_the_tolerance) {
  Error error;
  Elastic elastic = made(NULL, 0);
  ck_assert_int_eq(elastic_add_level(&elastic, 2.5, &error), STATUS_OK);
  search(&elastic, "awk -v Ca=$Ca 'BEGIN { Y = Ca * Ca * (1 + Ca); if (Ca >= 1) Y *= 4;"
                   " printf \"{status: steady, Y_max: %.17g}\", Y }' >$folder/summary.json\n");
  const LevelCrossing crossing = elastic_cross(&elastic, 2.5);
  ck_assert(crossing.low < 1 && crossing.high >= 1);
  ck_assert_double_le(crossing.high - crossing.low, TOLERANCE * (1 + 1e-9));
  ck_assert(crossing.low <= crossing.x && crossing.x <= crossing.high);
  elastic_free(&elastic);
}
END_TEST

START_TEST(a_level_beyond_the_bracket_is_passed_nowhere) {
  Error error;
  Elastic elastic = made(NULL, 0);
  ck_assert_int_eq(elastic_add_level(&elastic, Y(3), &error), STATUS_OK);
  search(&elastic, RUN);
  const LevelCrossing crossing = elastic_cross(&elastic, Y(3));
  ck_assert(isnan(crossing.x) && crossing.low == HIGH && isnan(crossing.high));
  elastic_free(&elastic);
}
END_TEST

START_TEST(runs_that_fail_give_a_reason_and_end_the_search) {
  Error error;
  Elastic elastic = made(NULL, 0);
  ck_assert_int_eq(elastic_add_level(&elastic, 1, &error), STATUS_OK);
  search(&elastic, "echo no step is small enough >&2\nexit 1\n");
  ck_assert_str_eq(elastic.reason, "no step is small enough");
  elastic_free(&elastic);
  elastic = made(NULL, 0);
  ck_assert_int_eq(elastic_add_level(&elastic, 1, &error), STATUS_OK);
  search(&elastic, "echo '{status: steady}' >$folder/summary.json\n");
  ck_assert_str_eq(elastic.reason, "no Y_max");
  elastic_free(&elastic);
}
END_TEST

int main(void) {
  if (!scratch_make() || setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1) != 0) return 1;
  const int failed =
      suite_run("elastic", (SuiteTests){points_that_differ_in_their_damage_law_alone_share_the_runs,
                                        every_level_is_found_within_the_tolerance_by_few_runs,
                                        a_jump_is_found_within_the_tolerance,
                                        a_level_beyond_the_bracket_is_passed_nowhere,
                                        runs_that_fail_give_a_reason_and_end_the_search, NULL});
  file_remove_folder(scratch_folder);
  return failed;
}
