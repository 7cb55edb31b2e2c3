/* What a study file may not say, and the message that names the place; what each kind of study asks for
 * beyond the parts that all share. */
#include "study_file.h"
#include "suite.h"

#define SCENE                                                                                                \
  "scene:\n"                                                                                                 \
  "  schema: 1\n"                                                                                            \
  "  membrane: {law: neo_hookean, parameters: {G_s: 1}, damage: {law: marigo, parameters: {Y_D: 1, Y_C: "    \
  "1}}}\n"                                                                                                   \
  "  flow: {kind: simple_shear, capillary_number: 0.7}\n"                                                    \
  "  time: {end: 10}\n"
#define SWEEP     "schema: 1\nstudy: sweep\n" SCENE
#define THRESHOLD "schema: 1\nstudy: threshold\n" SCENE
#define COMPARE   "schema: 1\nstudy: compare\n" SCENE

typedef struct {
  const char *text, *words;
} Mistake;

static void expect_refusals(const Mistake *table, size_t n) {
  for (size_t i = 0; i < n; i++) {
    Study study;
    Error error = {.text = "nothing"};
    scratch_write("study.yaml", table[i].text);
    ck_assert_msg(study_read(&study, scratch_path("study.yaml"), NULL, 0, &error) == STATUS_INPUT, "%s",
                  table[i].text);
    expect_words(&error, table[i].words);
  }
}
#define EXPECT_REFUSALS(table) expect_refusals(table, sizeof(table) / sizeof *(table))

START_TEST(what_is_no_study_is_named) {
  scratch_write("list.yaml", "[1]\n");
  static const Mistake table[] = {
      {"- schema: 1\n", "study.yaml:1:1: expected a mapping with the keys of a study, found a list"},
      {"schema: 1\nstudy: sweep\nscene: list.yaml\n",
       "list.yaml:1:1: expected a mapping with the keys of a scene, found a list"},
  };
  EXPECT_REFUSALS(table);
}
END_TEST

START_TEST(a_study_of_too_many_cases_is_refused_before_any_is_made) {
  static const Mistake table[] = {
      {SWEEP "vary: {flow.capillary_number: {from: 1, to: 2, count: 10001}}\n",
       ":8:55: expected at most 10000 values, found 10001"},
      {SWEEP "vary: {flow.capillary_number: {from: 1, to: 2, count: 10000},\n"
             "       membrane.damage.parameters.Y_D: {from: 1, to: 2, count: 1000}}\n",
       ":8:7: expected at most "},
  };
  EXPECT_REFUSALS(table);
}
END_TEST

START_TEST(a_threshold_study_says_what_to_find_where_and_how_well) {
  static const Mistake table[] = {
      {THRESHOLD "bracket: [0.1, 1]\ntolerance: 0.01\n", "expected the key `find`"},
      {THRESHOLD "find: Ca_c\nbracket: [0.1, 1]\ntolerance: 0.01\n", ":8:7: expected a list of 1 to "},
      {THRESHOLD "find: []\nbracket: [0.1, 1]\ntolerance: 0.01\n", "targets for `find`, found a list"},
      {THRESHOLD "find: [Ca_c, Ca_l, Ca_c]\nbracket: [0.1, 1]\ntolerance: 0.01\n",
       ":8:20: expected each target once, found `Ca_c` again"},
      {THRESHOLD "find: [Ca_c]\nbracket: 0.1\ntolerance: 0.01\n",
       ":9:10: expected [low, high] for `bracket`, found `0.1`"},
      {THRESHOLD "find: [Ca_c]\nbracket: [1, 0.1]\ntolerance: 0.01\n",
       ":9:10: expected 0 < low < high for `bracket`, found [1, 0.1]"},
      {THRESHOLD "find: [Ca_c]\nbracket: [0.1, much]\ntolerance: 0.01\n", "expected a number for `bracket`"},
      {THRESHOLD "find: [Ca_c]\nbracket: [0.1, 1]\ntolerance: 2\n",
       ":10:12: expected a number above 0 and below the length of the bracket for `tolerance`, found 2"},
      {THRESHOLD "find: [{name: a, key: flow.kin, when: ruptured}]\nbracket: [0.1, 1]\ntolerance: 0.1\n",
       "expected a known key, found `flow.kin`"},
  };
  EXPECT_REFUSALS(table);
}
END_TEST

START_TEST(a_comparison_says_how_to_calibrate_and_what_to_confirm) {
#define CRITERIA "criteria: [{law: marigo, parameters: {Y_D: 1, Y_C: 1}}]\n"
  static const Mistake table[] = {
      {COMPARE CRITERIA "calibrate: 0.3\n",
       ":9:12: expected `{Ca_c: }` or `{Ca_l: }` for `calibrate`, found `0.3`"},
      {COMPARE CRITERIA "calibrate: {Ca_c: 0.3, Ca_l: 0.7}\n", "for `calibrate`, found a mapping"},
      {COMPARE CRITERIA "calibrate: {Ca_x: 0.3}\n", "expected a known key, found `Ca_x`"},
      {COMPARE CRITERIA "calibrate: {Ca_c: low}\n", "expected a number for `Ca_c`, found `low`"},
      {COMPARE CRITERIA "confirm: all\n", "expected a list of criteria for `confirm`, in the mode `passive`"},
  };
  EXPECT_REFUSALS(table);
}
END_TEST

int main(void) {
  if (!scratch_make() || setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1) != 0) return 1;
  const int failed =
      suite_run("study_refusals", (SuiteTests){what_is_no_study_is_named,
                                               a_study_of_too_many_cases_is_refused_before_any_is_made,
                                               a_threshold_study_says_what_to_find_where_and_how_well,
                                               a_comparison_says_how_to_calibrate_and_what_to_confirm, NULL});
  scratch_remove();
  return failed;
}
