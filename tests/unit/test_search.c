/* Where plugins are looked for. */
#include "base/array.h"
#include "laws/search.h"
#include "suite.h"
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static LawSearch search_with(const char *scene_folder, const char *environment) {
  LawSearch search;
  Error error;
  if (environment) {
    setenv("MLAW_PLUGIN_PATH", environment, 1);
  } else {
    unsetenv("MLAW_PLUGIN_PATH");
  }
  ck_assert_int_eq(law_search_default(&search, scene_folder, &error), STATUS_OK);
  return search;
}

START_TEST(the_order_is_scene_environment_program) {
  LawSearch search = search_with("/scene", "/first:/second");
  ck_assert_uint_ge(search.n, 4);
  ck_assert_str_eq(search.folder[0], "/scene");
  ck_assert_str_eq(search.folder[1], "/first");
  ck_assert_str_eq(search.folder[2], "/second");
  ck_assert_str_eq(search.folder[3], BUILD_DIR "/tests/plugins"); /* beside this program */
  law_search_free(&search);
}
END_TEST

START_TEST(empty_entries_and_duplicates_are_dropped) {
  LawSearch search = search_with("/a", ":/b::/a:/b:");
  ck_assert_str_eq(search.folder[0], "/a");
  ck_assert_str_eq(search.folder[1], "/b");
  ck_assert_str_eq(search.folder[2], BUILD_DIR "/tests/plugins");
  law_search_free(&search);
}
END_TEST

START_TEST(without_scene_and_environment_the_programs_own_folder_comes_first) {
  LawSearch search = search_with(NULL, NULL);
  ck_assert_str_eq(search.folder[0], BUILD_DIR "/tests/plugins");
  law_search_free(&search);
}
END_TEST

START_TEST(files_come_in_search_order_then_by_name_and_have_their_stem) {
  Error error;
  LawFiles files;
  char folders[2][32] = {"/tmp/capsella-test-XXXXXX", "/tmp/capsella-[*]-XXXXXX"}, path[128];
  static const char *const names[] = {"b.so", "a.so", "not_a_plugin.txt"};
  for (int i = 0; i < 2; i++) {
    ck_assert_ptr_nonnull(mkdtemp(folders[i]));
    for (int k = 0; k < 3; k++) {
      snprintf(path, sizeof path, "%s/%s", folders[i], names[k]);
      fclose(fopen(path, "w"));
    }
  }
  char *in_order[] = {folders[1], folders[0]};
  const LawSearch search = {.folder = in_order, .n = 2};
  ck_assert_int_eq(law_search_files(&search, &files, &error), STATUS_OK);
  ck_assert_uint_eq(files.n, 4);
  static const char *const expected[] = {"a", "b", "a", "b"};
  for (size_t i = 0; i < 4; i++) {
    ck_assert_str_eq(files.name[i], expected[i]);
    ck_assert_int_eq(strncmp(files.path[i], folders[i < 2], strlen(folders[i < 2])), 0);
  }
  law_files_free(&files);
  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < 3; k++) {
      snprintf(path, sizeof path, "%s/%s", folders[i], names[k]);
      unlink(path);
    }
    rmdir(folders[i]);
  }
}
END_TEST

START_TEST(a_folder_that_does_not_exist_holds_no_files) {
  Error error;
  LawFiles files;
  static char nowhere[] = "/nowhere/at/all";
  char *folders[] = {nowhere};
  const LawSearch search = {.folder = folders, .n = 1};
  ck_assert_int_eq(law_search_files(&search, &files, &error), STATUS_OK);
  ck_assert_uint_eq(files.n, 0);
  law_files_free(&files);
}
END_TEST

START_TEST(the_failure_of_any_allocation_is_reported) {
  Error error;
  Status status;
  long n = 0;
  setenv("MLAW_PLUGIN_PATH", "/a:/b:/c:/d:/e", 1);
  do {
    LawSearch search;
    array_fail_nth(++n);
    status = law_search_default(&search, "/scene", &error);
    array_fail_nth(0);
    ck_assert(status == STATUS_OK || status == STATUS_MEMORY);
    law_search_free(&search);
  } while (status != STATUS_OK && n < 100);
  ck_assert_int_gt(n, 5);
  ck_assert_int_eq(status, STATUS_OK);
}
END_TEST

int main(void) {
  return suite_run("search", (SuiteTests){the_order_is_scene_environment_program,
                                          empty_entries_and_duplicates_are_dropped,
                                          without_scene_and_environment_the_programs_own_folder_comes_first,
                                          files_come_in_search_order_then_by_name_and_have_their_stem,
                                          a_folder_that_does_not_exist_holds_no_files,
                                          the_failure_of_any_allocation_is_reported, NULL});
}
