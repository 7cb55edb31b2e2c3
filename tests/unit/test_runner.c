/* Cases of a study: what is run, what is shared, what is taken over from disk, and what their figures are. */
#include "study_file.h"
#include "suite.h"
#include <math.h>
#include <signal.h>

/* A run that ends well: its summary holds the capillary number, and each run leaves a line in `runs`. */
#define GOOD                                                                                                 \
  "echo $Ca >>${0%/*}/runs\n"                                                                                \
  "echo \"{status: steady, t: $Ca, evaluations: 10, list: [5, {deep: 6}], rupture: {X: [1, 2, 3]}}\" "       \
  ">$folder/summary.json"

static Study study;
static Runner *runner;
static volatile sig_atomic_t interrupt;

static void open_runner(const char *body, bool resume) {
  Error error;
  const RunnerOptions options = {
      .jobs = 2, .resume = resume, .program = stand_in(body), .interrupt = &interrupt};
  const Status status = runner_new(&runner, &study, scratch_path("out"), &options, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
}

static void begin(const char *body) {
  Error error;
  file_remove_folder(scratch_path("out"));
  scratch_empty();
  interrupt = 0;
  study = study_that_varies("");
  ck_assert_int_eq(file_make_folder(scratch_path("out"), &error), STATUS_OK);
  open_runner(body, false);
}

static void end(void) {
  runner_free(runner);
  study_free(&study);
}

static Status ask(const char *label, const char *Ca, int *number, Error *error) {
  const Override setting = {.key = "flow.capillary_number", .value = Ca};
  return runner_request(runner, label, &setting, 1, number, error);
}

static int request(const char *label, const char *Ca) {
  Error error;
  int number = -1;
  ck_assert_int_eq(ask(label, Ca, &number, &error), STATUS_OK);
  return number;
}

static void wait_for_all(void) {
  Error error;
  const Status status = runner_wait_all(runner, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
}

static size_t runs(void) {
  Error error;
  Text content = {0};
  size_t lines = 0;
  if (file_read(scratch_path("runs"), 1 << 16, &content, &error) == STATUS_OK)
    for (const char *c = content.data; *c; c++) lines += *c == '\n';
  text_free(&content);
  return lines;
}

START_TEST(every_case_runs_with_its_settings_and_keeps_its_number) {
  begin(GOOD);
  static const char *const Ca[] = {"0.1", "0.2", "0.3", "0.4", "0.5"};
  int number[5];
  for (int i = 0; i < 5; i++) number[i] = request(Ca[i], Ca[i]);
  wait_for_all();
  for (int i = 0; i < 5; i++) {
    const Case *item = runner_case(runner, number[i]);
    ck_assert(item->state == CASE_DONE);
    ck_assert(case_number(item, "t") == strtod(Ca[i], NULL));
    ck_assert_str_eq(case_status(item), "steady");
  }
  const RunnerCount count = runner_count(runner);
  ck_assert(count.cases == 5 && count.failed == 0 && count.taken_over == 0 && count.jobs == 2);
  ck_assert(count.evaluations == 50);
  ck_assert_uint_eq(runs(), 5);
  end();
}
END_TEST

START_TEST(a_request_that_was_made_before_shares_its_case) {
  begin(GOOD);
  const int first = request("a", "0.1");
  ck_assert_int_eq(request("a", "0.1"), first);
  wait_for_all();
  ck_assert_int_eq(request("a", "0.1"), first);
  ck_assert_int_eq(runner_count(runner).shared, 2);
  ck_assert_uint_eq(runs(), 1);
  end();
}
END_TEST

START_TEST(two_cases_of_one_label_are_refused) {
  begin(GOOD);
  int number;
  Error error;
  request("a", "0.1");
  ck_assert_int_eq(ask("a", "0.2", &number, &error), STATUS_FAILED);
  expect_words(&error, "two cases of the study are called a");
  end();
}
END_TEST

START_TEST(figures_are_found_by_keys_with_dots) {
  begin(GOOD);
  const Case *item = runner_case(runner, request("a", "0.1"));
  ck_assert(isnan(case_number(item, "t"))); /* which has not run yet */
  ck_assert_str_eq(case_status(item), "failed");
  wait_for_all();
  ck_assert(case_number(item, "list.0") == 5 && case_number(item, "list.1.deep") == 6);
  ck_assert(case_component(item, "rupture.X", 2) == 3);
  ck_assert(isnan(case_component(item, "rupture.X", 3)) && isnan(case_component(item, "t", 0)));
  static const char *const nothing[] = {"none", "list", "list.7", "list.x", "t.deep", "status", "rupture.Y"};
  for (size_t i = 0; i < sizeof nothing / sizeof *nothing; i++)
    ck_assert_msg(isnan(case_number(item, nothing[i])), "%s", nothing[i]);
  end();
}
END_TEST

START_TEST(a_case_that_fails_gives_its_reason_on_one_line_and_the_others_go_on) {
  begin("[ $Ca = 0.1 ] && { echo no step >&2; echo is small enough >&2; exit 1; }\n"
        "[ $Ca = 0.2 ] && kill -KILL $$\n"
        "[ $Ca = 0.3 ] && exit 1\n" GOOD);
  const Case *said = runner_case(runner, request("said", "0.1")),
             *killed = runner_case(runner, request("killed", "0.2")),
             *silent = runner_case(runner, request("silent", "0.3")),
             *good = runner_case(runner, request("good", "0.4"));
  wait_for_all();
  ck_assert(said->state == CASE_FAILED && killed->state == CASE_FAILED && silent->state == CASE_FAILED);
  ck_assert_str_eq(said->reason, "no step is small enough");
  ck_assert_str_eq(killed->reason, "ended by signal 9");
  ck_assert_str_eq(silent->reason, "no reason given");
  ck_assert_str_eq(case_status(said), "failed");
  ck_assert(good->state == CASE_DONE);
  ck_assert_int_eq(runner_count(runner).failed, 3);
  end();
}
END_TEST

START_TEST(what_has_ended_is_taken_over_and_what_was_killed_runs_again) {
  begin("[ $Ca = 0.1 ] && exit 1\n[ $Ca = 0.2 ] && kill -KILL $$\n" GOOD);
  request("failed", "0.1");
  request("killed", "0.2");
  request("good", "0.3");
  wait_for_all();
  runner_free(runner);
  remove(scratch_path("runs"));
  open_runner(GOOD, true);
  const Case *failed = runner_case(runner, request("failed", "0.1")),
             *killed = runner_case(runner, request("killed", "0.2")),
             *good = runner_case(runner, request("good", "0.3"));
  wait_for_all();
  ck_assert(failed->state == CASE_FAILED && killed->state == CASE_DONE && good->state == CASE_DONE);
  ck_assert(case_number(good, "t") == 0.3);
  ck_assert_int_eq(runner_count(runner).taken_over, 2);
  ck_assert_uint_eq(runs(), 1);
  end();
}
END_TEST

START_TEST(a_case_of_other_settings_under_the_same_label_is_not_taken_over) {
  begin(GOOD);
  request("a", "0.1");
  wait_for_all();
  runner_free(runner);
  open_runner(GOOD, true);
  const Case *item = runner_case(runner, request("a", "0.2"));
  wait_for_all();
  ck_assert(case_number(item, "t") == 0.2);
  ck_assert_int_eq(runner_count(runner).taken_over, 0);
  ck_assert_uint_eq(runs(), 2);
  end();
}
END_TEST

START_TEST(a_study_that_starts_anew_takes_over_nothing) {
  begin(GOOD);
  request("a", "0.1");
  wait_for_all();
  runner_free(runner);
  open_runner(GOOD, false);
  ck_assert(!file_exists(scratch_path("out/cases/a/summary.json")));
  request("a", "0.1");
  wait_for_all();
  ck_assert_uint_eq(runs(), 2);
  end();
}
END_TEST

static void interrupted(int number) {
  interrupt = number;
}

START_TEST(an_interrupt_stops_what_runs_and_a_later_study_goes_on_with_it) {
  struct sigaction action = {.sa_handler = interrupted};
  ck_assert_int_eq(sigaction(SIGUSR1, &action, NULL), 0);
  begin("kill -USR1 $PPID; exec sleep 100"); /* which the runner does not wait for */
  const Case *item = runner_case(runner, request("a", "0.1"));
  wait_for_all();
  ck_assert(runner_interrupted(runner) && item->state == CASE_WAITING);
  runner_free(runner);
  interrupt = 0;
  open_runner("[ \"$8\" = --resume ] || exit 1\n" GOOD, true);
  item = runner_case(runner, request("a", "0.1"));
  wait_for_all();
  ck_assert_str_eq(case_status(item), "steady");
  end();
}
END_TEST

START_TEST(a_file_in_the_way_of_a_result_is_named) {
  begin(GOOD);
  Error error;
  int number;
  ck_assert_int_eq(file_make_folder(scratch_path("out/cases/a/summary.json/full"), &error), STATUS_OK);
  ck_assert_int_eq(ask("a", "0.1", &number, &error), STATUS_IO);
  expect_words(&error, "out/cases/a/summary.json: cannot be removed: ");
  ck_assert_int_eq(file_make_folder(scratch_path("out/cases/b/snapshot_000001.vtkhdf/full"), &error),
                   STATUS_OK);
  ck_assert_int_eq(ask("b", "0.1", &number, &error), STATUS_IO);
  expect_words(&error, "out/cases/b/snapshot_000001.vtkhdf: cannot be removed: ");
  end();
}
END_TEST

int main(void) {
  if (!scratch_make() || setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1) != 0) return 1;
  const int failed = suite_run(
      "runner", (SuiteTests){every_case_runs_with_its_settings_and_keeps_its_number,
                             a_request_that_was_made_before_shares_its_case,
                             two_cases_of_one_label_are_refused, figures_are_found_by_keys_with_dots,
                             a_case_that_fails_gives_its_reason_on_one_line_and_the_others_go_on,
                             what_has_ended_is_taken_over_and_what_was_killed_runs_again,
                             a_case_of_other_settings_under_the_same_label_is_not_taken_over,
                             a_study_that_starts_anew_takes_over_nothing,
                             an_interrupt_stops_what_runs_and_a_later_study_goes_on_with_it,
                             a_file_in_the_way_of_a_result_is_named, NULL});
  file_remove_folder(scratch_folder);
  return failed;
}
