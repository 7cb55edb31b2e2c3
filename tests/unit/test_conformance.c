/* The checker passes every law of the tree and names the fault of every fixture. */
#include "law_scene.h"
#include "laws/conformance.h"
#include "suite.h"
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>

#define TEMPLATES BUILD_DIR "/template"

static ConformanceReport check_file(const char *file, const char *only, double time_limit) {
  ConformanceReport report;
  Error error;
  const ConformanceOptions options = {.file = file, .only = only, .time_limit = time_limit};
  const Status status = conformance_run(&options, &report, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return report;
}

static void expect_all_passed(const char *file) {
  ConformanceReport report = check_file(file, NULL, 30.0);
  ck_assert_uint_ge(report.n, 30);
  for (size_t i = 0; i < report.n; i++) {
    const ConformanceResult *result = &report.result[i];
    ck_assert_msg(!conformance_is_bad(result->outcome), "%s: %s/%s of %s: %s", file, result->group,
                  result->name, result->law, result->text);
  }
  conformance_free(&report);
}

START_TEST(every_law_that_ships_passes_every_test) {
  Error error;
  LawFiles files;
  static char plugins[] = PLUGINS;
  char *folders[] = {plugins};
  const LawSearch search = {.folder = folders, .n = 1};
  ck_assert_int_eq(law_search_files(&search, &files, &error), STATUS_OK);
  ck_assert_uint_ge(files.n, 3);
  for (size_t i = 0; i < files.n; i++) expect_all_passed(files.path[i]);
  law_files_free(&files);
}
END_TEST

START_TEST(every_template_passes_every_test) {
  expect_all_passed(TEMPLATES "/energy_law.so");
  expect_all_passed(TEMPLATES "/explicit_damage_law.so");
  expect_all_passed(TEMPLATES "/general_damage_law.so");
}
END_TEST

START_TEST(a_law_that_leaves_the_cap_to_the_host_passes_every_test) {
  expect_all_passed(BROKEN "/uncapped.so");
}
END_TEST

/* The fault of a fixture, the test made for it, and words of its message. */
typedef struct {
  const char *file, *test;
  ConformanceOutcome outcome;
  const char *words;
} Fault;

static const Fault faults[] = {
    {"wrong_major", "load/opens-now-local", CONFORMANCE_FAILED, "speaks ABI 2"},
    {"newer_minor", "load/opens-now-local", CONFORMANCE_FAILED, "needs a host of ABI 1.700"},
    {"null_descriptor", "load/opens-now-local", CONFORMANCE_FAILED, "declines"},
    {"undefined", "load/opens-now-local", CONFORMANCE_FAILED, "missing_from_every_library"},
    {"both_kinds", "load/opens-now-local", CONFORMANCE_FAILED, "both kinds"},
    {"crashes_at_load", "load/opens-now-local", CONFORMANCE_CRASHED, "ended by signal 11"},
    {"leaves", "load/opens-now-local", CONFORMANCE_CRASHED, "ended with exit code 3 before it answered"},
    {"extra_symbols", "load/only-entry-exported", CONFORMANCE_FAILED, "inner_function"},
    {"allocates", "load/no-forbidden-import", CONFORMANCE_FAILED, "malloc"},
#if defined(__SSE2__)
    {"flushes_subnormals", "load/fp-mode-unchanged", CONFORMANCE_FAILED, "flushed to zero"},
#endif
    {"rounds", "load/fp-mode-unchanged", CONFORMANCE_FAILED, "expected the rounding direction to stay"},
    {"alternates", "load/entry-idempotent", CONFORMANCE_FAILED, "found another at a later call"},
    {"old_hosts_only", "load/unknown-host-minor", CONFORMANCE_FAILED, "declines ABI 1."},
    {"bad_tables", "description/id-well-formed", CONFORMANCE_FAILED, "Bad Tables"},
    {"bad_tables", "description/default-inside-hard", CONFORMANCE_FAILED, "found -1"},
    {"bad_tables", "description/calibrated-inside-hard", CONFORMANCE_FAILED, "found -5"},
    {"bad_tables", "description/unit-agrees-with-exponents", CONFORMANCE_FAILED, "found {1, -1, -2, 0}"},
    {"too_many", "description/sizes-sane", CONFORMANCE_FAILED, "found 65 and 0"},
    {"hole", "contract/no-hole", CONFORMANCE_FAILED, "found point 36 left out"},
    {"overrun", "contract/no-overrun", CONFORMANCE_FAILED, "found n+0 written"},
    {"spoils_input", "contract/inputs-untouched", CONFORMANCE_FAILED, "found one changed"},
    {"keeps_state", "contract/keeps-nothing", CONFORMANCE_FAILED, "the same call again, after others"},
    {"shares_scratch", "contract/threads-agree", CONFORMANCE_FAILED, "beside other threads"},
    {"whole_vectors", "contract/batch-equals-single", CONFORMANCE_FAILED, "good alone, found status -2"},
    {"nameless_refusal", "contract/domain-error-names-point", CONFORMANCE_FAILED, "refusal of point 23"},
    {"nan_damage", "contract/no-hole", CONFORMANCE_FAILED, "finite zeta"},
    {"crashes", "contract/no-hole", CONFORMANCE_CRASHED, "ended by signal 11"},
    {"endless", "contract/no-hole", CONFORMANCE_TIMED_OUT, "no answer within 0.5 s"},
    {"nan_energy", "energy/finite-on-range", CONFORMANCE_FAILED, "finite phi_2"},
    {"prestressed", "energy/no-tension-at-rest", CONFORMANCE_FAILED, "found 0.01"},
    {"wrong_gradient", "energy/gradient-matches-differences", CONFORMANCE_FAILED, "expected phi_1"},
    {"wrong_hessian", "energy/hessian-matches-differences", CONFORMANCE_FAILED, "expected phi_22"},
    {"negative_modulus", "energy/positive-moduli", CONFORMANCE_FAILED, "expected positive moduli at rest"},
    {"softens", "damage/monotone-in-Ymax", CONFORMANCE_FAILED, "never falls with Y"},
    {"softens", "damage/consistency", CONFORMANCE_FAILED, "expected f(Y; zeta(Y)) = 0"},
    {"wrong_slope", "damage/slope-matches-differences", CONFORMANCE_FAILED, "found 0.9"},
    {"healing", "damage/never-falls", CONFORMANCE_FAILED, "dissipation"},
    {"per_call", "damage/dt-zero-changes-nothing", CONFORMANCE_FAILED, "a step of no length"},
    {"per_call", "damage/step-split", CONFORMANCE_FAILED, "converges"},
};

START_TEST(every_fault_is_caught_by_the_test_made_for_it) {
  char file[512];
  const Fault *fault = &faults[_i];
  const bool sanitized = getenv("CK_FORK") != NULL; /* sanitizers end a process in their own way */
  snprintf(file, sizeof file, BROKEN "/%s.so", fault->file);
  if (sanitized && fault->outcome == CONFORMANCE_CRASHED) return;
  const double time_limit = fault->outcome == CONFORMANCE_TIMED_OUT ? 0.5 : 30.0;
  ConformanceReport report = check_file(file, fault->test, time_limit);
  ck_assert_uint_ge(report.n, 1);
  const ConformanceResult *last = &report.result[report.n - 1];
  ck_assert_msg(last->outcome == fault->outcome, "%s, %s: %s: %s", fault->file, fault->test,
                conformance_outcome_name(last->outcome), last->text);
  ck_assert_msg(strstr(last->text, fault->words) != NULL, "expected `%s` in `%s`", fault->words, last->text);
  conformance_free(&report);
}
END_TEST

START_TEST(a_law_that_ran_out_of_time_is_named_and_not_asked_again) {
  ConformanceReport report = check_file(BROKEN "/endless.so", "contract|energy", 0.3);
  ck_assert_uint_eq(report.n, 2); /* it opens, and then the first test of the law */
  ck_assert_uint_eq(report.n_bad, 1);
  ck_assert_str_eq(report.result[1].law, "endless");
  conformance_free(&report);
}
END_TEST

START_TEST(a_run_admits_only_a_plugin_that_passes) {
  Error error;
  if (getenv("CK_FORK")) return; /* as above */
  ck_assert_int_eq(conformance_admit(PLUGINS "/skalak.so", &error), STATUS_OK);
  ck_assert_int_eq(conformance_admit(BUILD_DIR "/tests/abi/older.so", &error), STATUS_OK);
  ck_assert_int_eq(conformance_admit(BROKEN "/from_the_future.so", &error), STATUS_OK);
  ck_assert_int_eq(conformance_admit(BROKEN "/overrun.so", &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(
      strstr(error.text, "overrun: contract/no-overrun failed: expected entries n .. ld-1"));
  ck_assert_ptr_nonnull(strstr(error.text, "laws check " BROKEN "/overrun.so"));
  ck_assert_int_eq(conformance_admit(BROKEN "/crashes_at_load.so", &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "load/opens-now-local crashed: ended by signal 11"));
}
END_TEST

START_TEST(only_runs_the_tests_that_match) {
  ConformanceReport report = check_file(PLUGINS "/skalak.so", "^energy/(zero|positive)", 10.0);
  ck_assert_uint_eq(report.n, 3); /* with opens-now-local, without which nothing can be said */
  ck_assert_str_eq(report.result[1].name, "zero-at-rest");
  ck_assert_str_eq(report.result[2].name, "positive-moduli");
  ck_assert_str_eq(report.result[2].text, "G_s = 1, K_s = 3");
  conformance_free(&report);
}
END_TEST

typedef struct {
  size_t calls, total;
} Told;

static void count_call(void *context, size_t done, size_t total, const char *test) {
  Told *told = context;
  ck_assert_uint_eq(done, told->calls++);
  ck_assert_ptr_nonnull(strchr(test, '/'));
  told->total = total;
}

START_TEST(progress_is_told_before_each_test_and_ends_with_the_last) {
  Told told = {0};
  ConformanceReport report;
  Error error;
  const ConformanceOptions options = {.file = BUILD_DIR "/plugins/skalak.so",
                                      .time_limit = CONFORMANCE_TIME_LIMIT,
                                      .progress = count_call,
                                      .context = &told};
  ck_assert_int_eq(conformance_run(&options, &report, &error), STATUS_OK);
  ck_assert_uint_gt(told.calls, 20);
  ck_assert_uint_eq(told.calls, told.total);
  conformance_free(&report);
}
END_TEST

START_TEST(a_wrong_call_is_an_input_error) {
  ConformanceReport report;
  Error error;
  ConformanceOptions options = {.file = PLUGINS "/nothing.so", .time_limit = 1.0};
  ck_assert_int_eq(conformance_run(&options, &report, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "nothing.so: not a file that can be read"));
  options = (ConformanceOptions){.file = PLUGINS "/skalak.so", .only = "no-such-test", .time_limit = 1.0};
  ck_assert_int_eq(conformance_run(&options, &report, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "no test is named like `no-such-test`"));
  options.only = "(";
  ck_assert_int_eq(conformance_run(&options, &report, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "expected a regular expression, found `(`"));
}
END_TEST

START_TEST(a_process_without_descriptors_cannot_check_and_says_so) {
  ConformanceReport report;
  Error error;
  struct rlimit before, none;
  const ConformanceOptions options = {.file = PLUGINS "/skalak.so", .time_limit = 1.0};
  ck_assert_int_eq(getrlimit(RLIMIT_NOFILE, &before), 0);
  none = (struct rlimit){0, before.rlim_max};
  ck_assert_int_eq(setrlimit(RLIMIT_NOFILE, &none), 0);
  const Status status = conformance_run(&options, &report, &error);
  ck_assert_int_eq(setrlimit(RLIMIT_NOFILE, &before), 0);
  ck_assert_int_eq(status, STATUS_IO);
  ck_assert_msg(strstr(error.text, "a pipe cannot be had: ") != NULL, "%s", error.text);
}
END_TEST

int main(void) {
  TCase *group = tcase_create("conformance");
  tcase_add_test(group, every_law_that_ships_passes_every_test);
  tcase_add_test(group, every_template_passes_every_test);
  tcase_add_test(group, a_law_that_leaves_the_cap_to_the_host_passes_every_test);
  tcase_add_loop_test(group, every_fault_is_caught_by_the_test_made_for_it, 0,
                      sizeof faults / sizeof *faults);
  tcase_add_test(group, a_law_that_ran_out_of_time_is_named_and_not_asked_again);
  tcase_add_test(group, a_run_admits_only_a_plugin_that_passes);
  tcase_add_test(group, only_runs_the_tests_that_match);
  tcase_add_test(group, progress_is_told_before_each_test_and_ends_with_the_last);
  tcase_add_test(group, a_wrong_call_is_an_input_error);
  tcase_add_test(group, a_process_without_descriptors_cannot_check_and_says_so);
  Suite *suite = suite_create("conformance");
  suite_add_tcase(suite, group);
  SRunner *runner = srunner_create(suite);
  srunner_run_all(runner, CK_ENV);
  const int failed = srunner_ntests_failed(runner);
  srunner_free(runner);
  return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
