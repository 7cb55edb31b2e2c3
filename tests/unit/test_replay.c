/* Files of failures: what a sound one gives, and what is said of those that were edited.  Files that a run
 * has written are the business of scene.law_failure. */
#include "law_scene.h"
#include "laws/replay.h"
#include "study_file.h"
#include "suite.h"

#define HEAD                                                                                                 \
  "law_failure: 1\nlaw: neo_hookean\nfile: " PLUGINS "/neo_hookean.so\nhash: \"0\"\nmessage: none\n"
#define TIME  "time: [0, 0.1]\n"
#define MODUL "parameters:\n  - [1, 1]\n"
#define INPUT "inputs:\n  - [0, 0.1]\n  - [0, 0.1]\n"

static Status replay(const char *yaml, Text *report, bool *is_bad, Error *error) {
  scratch_write("law_failure.yaml", yaml);
  return law_replay(scratch_path("law_failure.yaml"), report, is_bad, error);
}

START_TEST(a_law_that_answers_is_found_sound_and_another_file_is_told) {
  Text report = {0};
  Error error;
  bool is_bad = true;
  const Status status = replay(HEAD TIME MODUL INPUT, &report, &is_bad, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  ck_assert(!is_bad);
  ck_assert_ptr_nonnull(
      strstr(report.data, "law neo_hookean of " PLUGINS "/neo_hookean.so, 2 points from t = 0 to 0.1"));
  ck_assert_ptr_nonnull(strstr(report.data, "the plugin has changed since: hash 0000000000000000 then, "));
  ck_assert_ptr_nonnull(strstr(report.data, "the law answers every point, in the batch and alone"));
  text_free(&report);
}
END_TEST

START_TEST(what_is_no_failure_of_this_law_is_named) {
  static const struct {
    const char *yaml, *words;
  } table[] = {
      {"schema: 1\n", "law_failure.yaml: expected the file of a law that failed, found another"},
      {"[1]\n", "expected the file of a law that failed, found another"},
      {HEAD MODUL INPUT, ":1:1: expected a list under `time`, found none"},
      {HEAD "time: 3\n" MODUL INPUT, ":6:7: expected a list under `time`, found `3`"},
      {"law_failure: 1\nlaw: [neo_hookean]\n", ":2:6: expected a text under `law`, found a list"},
      {HEAD "time: [0, soon]\n" MODUL INPUT, ":6:11: expected a number, found `soon`"},
      {HEAD "time: [0]\n" MODUL INPUT, ":6:7: expected a list of 2 numbers, found a list"},
      {HEAD TIME "parameters:\n  - [1]\n" INPUT, "expected a list of 2 numbers, found a list"},
      {HEAD TIME MODUL "inputs: []\n", "points under `inputs`, found 0"},
      {HEAD TIME MODUL "inputs:\n  - [0, 0.1]\n",
       "expected a law with 1 parameters and 1 inputs, found 1 and 2 in " PLUGINS
       "/neo_hookean.so: its tables have "
       "changed since"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Text report = {0};
    Error error = {.text = "nothing"};
    bool is_bad;
    ck_assert_msg(replay(table[i].yaml, &report, &is_bad, &error) == STATUS_INPUT, "%s", table[i].yaml);
    expect_words(&error, table[i].words);
    text_free(&report);
  }
}
END_TEST

START_TEST(a_file_that_is_not_there_is_wrong_input) {
  Text report = {0};
  Error error;
  bool is_bad;
  ck_assert_int_eq(law_replay(scratch_path("none.yaml"), &report, &is_bad, &error), STATUS_INPUT);
  text_free(&report);
}
END_TEST

int main(void) {
  if (!scratch_make()) return 1;
  const int failed =
      suite_run("replay", (SuiteTests){a_law_that_answers_is_found_sound_and_another_file_is_told,
                                       what_is_no_failure_of_this_law_is_named,
                                       a_file_that_is_not_there_is_wrong_input, NULL});
  scratch_remove();
  return failed;
}
