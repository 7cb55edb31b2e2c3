/* What can be opened, and what is said of what cannot. */
#include "law_scene.h"
#include "laws/plugin.h"
#include "suite.h"
#include <string.h>

static const mlaw_plugin *open_plugin(const char *file) {
  const mlaw_plugin *plugin;
  Error error;
  const Status status = plugin_open(file, &plugin, &error);
  ck_assert_msg(status == STATUS_OK, "%s: %s", file, status == STATUS_OK ? "" : error.text);
  return plugin;
}

static void expect_refusal(const char *file, const char *words) {
  const mlaw_plugin *plugin;
  Error error;
  ck_assert_int_eq(plugin_open(file, &plugin, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, words) != NULL, "expected `%s` in `%s`", words, error.text);
  ck_assert_ptr_null(strstr(error.text, "(null)"));
}

START_TEST(a_shipped_plugin_opens_and_describes_its_law) {
  const mlaw_plugin *plugin = open_plugin(PLUGINS "/skalak.so");
  ck_assert_str_eq(plugin->id, "skalak");
  ck_assert_uint_eq(plugin->n_energy, 1);
  LawDescription law = law_describe_energy(plugin->energy[0]);
  ck_assert_uint_eq(law.n_params, 2);
  ck_assert_str_eq(law_param(&law, 1)->name, "C");
}
END_TEST

START_TEST(a_plugin_built_with_an_older_header_opens_and_lacks_what_came_later) {
  const mlaw_plugin *plugin = open_plugin(BUILD_DIR "/tests/abi/older.so");
  ck_assert_uint_eq(plugin->abi_minor, 0);
  ck_assert_uint_lt(plugin->energy[0]->size, sizeof(mlaw_energy));
  ck_assert_uint_lt(plugin->damage[0]->size, sizeof(mlaw_damage));
  ck_assert_ptr_null(law_describe_energy(plugin->energy[0]).about);
  ck_assert_ptr_null(law_describe_damage(plugin->damage[0]).about);
}
END_TEST

START_TEST(a_plugin_built_with_a_newer_header_opens_and_its_tail_is_not_read) {
  const mlaw_plugin *plugin = open_plugin(BROKEN "/from_the_future.so");
  ck_assert_uint_gt(plugin->abi_minor, MLAW_ABI_MINOR);
  ck_assert_uint_gt(plugin->energy[0]->size, sizeof(mlaw_energy));
  ck_assert_uint_gt(plugin->damage[0]->size, sizeof(mlaw_damage));
  ck_assert_uint_gt(plugin->size, sizeof(mlaw_plugin));
}
END_TEST

START_TEST(opening_twice_gives_the_same_plugin) {
  ck_assert_ptr_eq(open_plugin(PLUGINS "/marigo.so"), open_plugin(PLUGINS "/marigo.so"));
}
END_TEST

START_TEST(a_foreign_major_is_named) {
  expect_refusal(BROKEN "/wrong_major.so",
                 "speaks ABI 2 (it exports mlaw_plugin_v2), this host speaks ABI 1");
}
END_TEST

START_TEST(a_plugin_that_needs_a_newer_host_is_refused_with_both_numbers) {
  expect_refusal(BROKEN "/newer_minor.so", "needs a host of ABI 1.700 or newer; this host has 1.1");
}
END_TEST

START_TEST(a_plugin_that_declines_is_reported) {
  expect_refusal(BROKEN "/null_descriptor.so", "declines to serve a host of ABI 1.1");
}
END_TEST

START_TEST(a_descriptor_shorter_than_the_first_abi_is_not_read) {
  expect_refusal(BROKEN "/short_descriptor.so", "fewer than that of ABI 1.0");
}
END_TEST

START_TEST(a_shared_object_without_the_entry_is_no_plugin) {
  expect_refusal(BROKEN "/no_entry.so", "not a law plugin: it does not export mlaw_plugin_v1");
}
END_TEST

START_TEST(a_missing_symbol_is_found_at_once_and_named) {
  expect_refusal(BROKEN "/undefined.so", "undefined symbol: missing_from_every_library");
}
END_TEST

START_TEST(a_damage_law_of_both_kinds_is_refused) {
  expect_refusal(BROKEN "/both_kinds.so", "`both_kinds` is of both kinds");
}
END_TEST

START_TEST(a_file_that_is_no_shared_object_is_refused_with_the_linkers_words) {
  expect_refusal(SOURCE_DIR "/CMakeLists.txt", "cannot be opened: invalid ELF header");
}
END_TEST

START_TEST(a_plugin_written_in_cxx_opens_where_there_is_a_compiler) {
#ifdef HAVE_CXX_PLUGIN
  ck_assert_str_eq(open_plugin(BUILD_DIR "/tests/cxx/law_in_cxx.so")->energy[0]->id, "cxx.sheet");
#endif
}
END_TEST

/* A plugin of a later minor: its parameter rows are longer than ours. */
typedef struct {
  mlaw_param now;
  double later;
} LongerParam;

START_TEST(longer_rows_of_a_newer_plugin_are_walked_with_their_own_size) {
  static const LongerParam rows[] = {{{.name = "first"}, 1.0}, {{.name = "second"}, 2.0}};
  const LawDescription law = {.params = &rows[0].now, .n_params = 2, .param_size = sizeof(LongerParam)};
  ck_assert_str_eq(law_param(&law, 0)->name, "first");
  ck_assert_str_eq(law_param(&law, 1)->name, "second");
}
END_TEST

int main(void) {
  return suite_run(
      "plugin",
      (SuiteTests){a_shipped_plugin_opens_and_describes_its_law,
                   a_plugin_built_with_an_older_header_opens_and_lacks_what_came_later,
                   a_plugin_built_with_a_newer_header_opens_and_its_tail_is_not_read,
                   opening_twice_gives_the_same_plugin, a_foreign_major_is_named,
                   a_plugin_that_needs_a_newer_host_is_refused_with_both_numbers,
                   a_plugin_that_declines_is_reported, a_descriptor_shorter_than_the_first_abi_is_not_read,
                   a_shared_object_without_the_entry_is_no_plugin,
                   a_missing_symbol_is_found_at_once_and_named, a_damage_law_of_both_kinds_is_refused,
                   a_file_that_is_no_shared_object_is_refused_with_the_linkers_words,
                   a_plugin_written_in_cxx_opens_where_there_is_a_compiler,
                   longer_rows_of_a_newer_plugin_are_walked_with_their_own_size, NULL});
}
