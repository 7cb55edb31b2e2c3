/* From what a scene asks for to a law, or to a report of all that was tried. */
#include "base/array.h"
#include "base/file.h"
#include "law_scene.h"
#include "laws/loader.h"
#include "suite.h"
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static LoadedLaw load(LawKind kind, const char *request) {
  const LawSearch search = test_search();
  LoadedLaw law;
  Error error;
  const Status status = law_load(&law, kind, request, &search, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return law;
}

static void expect_in(const Error *error, const char *words) {
  ck_assert_msg(strstr(error->text, words) != NULL, "expected `%s` in `%s`", words, error->text);
}

/* The message of a request that cannot be served. */
static Error refusal(LawKind kind, const char *request) {
  const LawSearch search = test_search();
  LoadedLaw law;
  Error error;
  ck_assert_int_eq(law_load(&law, kind, request, &search, &error), STATUS_INPUT);
  ck_assert_ptr_null(law.file);
  return error;
}

START_TEST(a_law_is_found_by_its_id) {
  LoadedLaw energy = load(LAW_ENERGY, "skalak"), damage = load(LAW_DAMAGE, "marigo");
  ck_assert_str_eq(energy.energy->id, "skalak");
  ck_assert_ptr_null(energy.damage);
  ck_assert_str_eq(energy.file, PLUGINS "/skalak.so");
  ck_assert_str_eq(damage.damage->id, "marigo");
  ck_assert_ptr_null(damage.energy);
  law_release(&energy);
  law_release(&damage);
}
END_TEST

START_TEST(the_hash_is_that_of_the_file) {
  uint64_t hash;
  Error error;
  LoadedLaw law = load(LAW_ENERGY, "skalak");
  ck_assert_int_eq(file_hash(PLUGINS "/skalak.so", &hash, &error), STATUS_OK);
  ck_assert_uint_eq(law.hash, hash);
  law_release(&law);
}
END_TEST

START_TEST(a_law_is_found_by_a_path_absolute_or_from_a_folder_of_the_search) {
  static const char *const requests[] = {PLUGINS "/skalak.so", "skalak.so", "./skalak.so",
                                         "../plugins/skalak.so", "skalak.so#skalak"};
  for (size_t i = 0; i < sizeof requests / sizeof *requests; i++) {
    LoadedLaw law = load(LAW_ENERGY, requests[i]);
    ck_assert_str_eq(law.file, PLUGINS "/skalak.so");
    law_release(&law);
  }
}
END_TEST

START_TEST(one_law_of_several_is_chosen_by_id) {
  static const char *const requests[] = {"several.second", "several.so#several.second"};
  for (int i = 0; i < 2; i++) {
    LoadedLaw law = load(LAW_ENERGY, requests[i]);
    ck_assert_str_eq(law.energy->id, "several.second");
    law_release(&law);
  }
  LoadedLaw only = load(LAW_DAMAGE, "./several.so"); /* it holds one damage law */
  ck_assert_str_eq(only.damage->id, "several.damage");
  law_release(&only);
}
END_TEST

START_TEST(several_laws_in_a_file_ask_for_a_choice) {
  Error error = refusal(LAW_ENERGY, "./several.so");
  expect_in(&error, "several.first (energy) several.second (energy) several.damage (damage)");
  expect_in(&error, "choose one with FILE.so#ID");
}
END_TEST

START_TEST(a_misspelt_name_is_answered_with_the_nearest_and_all_that_was_tried) {
  Error error = refusal(LAW_ENERGY, "skalek");
  expect_in(&error, "expected the energy law `skalek`");
  expect_in(&error, "did you mean `skalak`?");
  expect_in(&error, "\n  " PLUGINS "/skalek.so: no such file");
  expect_in(&error, "\n  " BROKEN "/skalek.so: no such file");
  expect_in(&error, "MLAW_PLUGIN_PATH");
}
END_TEST

START_TEST(a_law_of_the_other_kind_is_no_answer) {
  Error error = refusal(LAW_DAMAGE, "skalak");
  expect_in(&error, "expected the damage law `skalak`");
  expect_in(&error, PLUGINS "/skalak.so: has no law that fits; it holds skalak (energy)");
  ck_assert_ptr_null(strstr(error.text, "did you mean"));
}
END_TEST

START_TEST(a_file_that_is_there_but_cannot_serve_is_not_passed_over) {
  Error error;
  LoadedLaw law;
  char folder[] = "/tmp/capsella-test-XXXXXX", path[128];
  static char plugins[] = PLUGINS;
  ck_assert_ptr_nonnull(mkdtemp(folder));
  snprintf(path, sizeof path, "%s/skalak.so", folder);
  ck_assert_int_eq(file_write(path, "not a shared object", 19, &error), STATUS_OK);
  char *folders[] = {folder, plugins};
  const LawSearch search = {.folder = folders, .n = 2};
  ck_assert_int_eq(law_load(&law, LAW_ENERGY, "skalak", &search, &error), STATUS_INPUT);
  expect_in(&error, path);
  expect_in(&error, "cannot be opened: ");
  ck_assert_ptr_null(strstr(error.text, PLUGINS));
  unlink(path);
  rmdir(folder);
}
END_TEST

START_TEST(a_folder_in_place_of_a_file_is_said_to_be_one) {
  Error error = refusal(LAW_ENERGY, BUILD_DIR "/plugins/");
  expect_in(&error, "not a file that can be read");
}
END_TEST

START_TEST(reasons_of_the_plugin_reach_the_report) {
  Error error = refusal(LAW_ENERGY, "wrong_major");
  expect_in(&error, BROKEN "/wrong_major.so: the plugin speaks ABI 2");
  error = refusal(LAW_ENERGY, "newer_minor");
  expect_in(&error, "1.700");
}
END_TEST

static Status admit_none(const char *file, Error *error) {
  return error_set(error, STATUS_INPUT, "%s is not wanted", file);
}

START_TEST(the_host_may_refuse_a_file_that_is_not_its_own_before_it_is_opened) {
  Error error;
  LoadedLaw law;
  LawSearch search = test_search(); /* of two folders, of which the second is the program's */
  search.n_foreign = 1;
  search.admit = admit_none;
  ck_assert_int_eq(law_load(&law, LAW_ENERGY, "hole", &search, &error), STATUS_OK);
  law_release(&law);
  ck_assert_int_eq(law_load(&law, LAW_ENERGY, "skalak", &search, &error), STATUS_INPUT);
  expect_in(&error, PLUGINS "/skalak.so: " PLUGINS "/skalak.so is not wanted");
}
END_TEST

static Status admit_without_memory(const char *file, Error *error) {
  return error_set(error, STATUS_MEMORY, "out of memory: the test of %s", file);
}

START_TEST(a_want_of_memory_is_no_fault_of_the_file) {
  Error error;
  LoadedLaw law;
  LawSearch search = test_search();
  search.n_foreign = 1;
  search.admit = admit_without_memory;
  ck_assert_int_eq(law_load(&law, LAW_ENERGY, "skalak", &search, &error), STATUS_MEMORY);
  expect_in(&error, PLUGINS "/skalak.so: out of memory: the test of " PLUGINS "/skalak.so");
  ck_assert(!strstr(error.text, "found none that can be used"));
}
END_TEST

START_TEST(an_empty_search_says_so) {
  Error error;
  LoadedLaw law;
  const LawSearch nowhere = {0};
  ck_assert_int_eq(law_load(&law, LAW_ENERGY, "skalak", &nowhere, &error), STATUS_INPUT);
  expect_in(&error, "for lack of folders");
}
END_TEST

START_TEST(the_failure_of_any_allocation_is_reported) {
  const LawSearch search = test_search();
  static const char *const requests[] = {"several.second", "skalek"};
  for (int i = 0; i < 2; i++) {
    const Status end = i == 0 ? STATUS_OK : STATUS_INPUT;
    Status status;
    Error error;
    long n = 0;
    do {
      LoadedLaw law;
      array_fail_nth(++n);
      status = law_load(&law, LAW_ENERGY, requests[i], &search, &error);
      array_fail_nth(0);
      ck_assert(status == end || status == STATUS_MEMORY);
      law_release(&law);
    } while (status != end && n < 1000);
    ck_assert_int_gt(n, 3);
    ck_assert_int_eq(status, end);
  }
}
END_TEST

int main(void) {
  return suite_run("loader",
                   (SuiteTests){a_law_is_found_by_its_id, the_hash_is_that_of_the_file,
                                a_law_is_found_by_a_path_absolute_or_from_a_folder_of_the_search,
                                one_law_of_several_is_chosen_by_id, several_laws_in_a_file_ask_for_a_choice,
                                a_misspelt_name_is_answered_with_the_nearest_and_all_that_was_tried,
                                a_law_of_the_other_kind_is_no_answer,
                                a_file_that_is_there_but_cannot_serve_is_not_passed_over,
                                a_folder_in_place_of_a_file_is_said_to_be_one,
                                reasons_of_the_plugin_reach_the_report,
                                the_host_may_refuse_a_file_that_is_not_its_own_before_it_is_opened,
                                a_want_of_memory_is_no_fault_of_the_file, an_empty_search_says_so,
                                the_failure_of_any_allocation_is_reported, NULL});
}
