/* The page around the data. */
#include "observe/page.h"

#include "base/file.h"
#include "scratch.h"
#include "suite.h"
#include <string.h>

static Text printed(const char *data) {
  Error error;
  Text html = {0};
  ck_assert_msg(page_print(data, &html, &error) == STATUS_OK, "%s", error.text);
  return html;
}

static size_t occurrences(const char *text, const char *word) {
  size_t count = 0;
  for (const char *at = text; (at = strstr(at, word)); at++) count++;
  return count;
}

START_TEST(the_data_stand_in_their_element) {
  Text html = printed("{\"kind\": \"run\"}\n");
  ck_assert_ptr_nonnull(
      strstr(html.data, "<script type=\"application/json\" id=\"data\">{\"kind\": \"run\"}\n</script>"));
  ck_assert_ptr_null(strstr(html.data, "@CAPSELLA_DATA@"));
  ck_assert_int_eq(strncmp(html.data, "<!DOCTYPE html>", 15), 0);
  ck_assert_str_eq(html.data + html.length - 8, "</html>\n");
  text_free(&html);
}
END_TEST

START_TEST(a_name_cannot_end_the_element) {
  Text harmless = printed("{}"), html = printed("{\"name\": \"</script><!-- <b>\"}");
  ck_assert_ptr_nonnull(strstr(html.data, "{\"name\": \"\\u003c/script>\\u003c!-- \\u003cb>\"}"));
  ck_assert_uint_eq(occurrences(html.data, "</script"), occurrences(harmless.data, "</script"));
  ck_assert_uint_eq(occurrences(html.data, "<!--"), occurrences(harmless.data, "<!--"));
  text_free(&harmless);
  text_free(&html);
}
END_TEST

/* A page that opens offline loads nothing: no element of it names another file, and its policy forbids the
 * rest. */
START_TEST(nothing_is_loaded) {
  static const char *const loading[] = {"<script src", "<link rel=\"stylesheet", "<img", "<iframe",
                                        "@import"};
  Text html = printed("{}");
  for (size_t k = 0; k < sizeof loading / sizeof *loading; k++)
    ck_assert_msg(!strstr(html.data, loading[k]), "%s", loading[k]);
  ck_assert_ptr_nonnull(strstr(html.data, "content=\"default-src 'none'; "));
  text_free(&html);
}
END_TEST

START_TEST(the_licences_of_the_libraries_are_in_the_page) {
  Text html = printed("{}");
  ck_assert_ptr_nonnull(strstr(html.data, "three.js authors"));
  ck_assert_ptr_nonnull(strstr(html.data, "Leon Sorokin"));
  text_free(&html);
}
END_TEST

static void put(const char *name, const char *text) {
  Error error;
  ck_assert_int_eq(file_write(scratch_path(name), text, strlen(text), &error), STATUS_OK);
}

START_TEST(files_of_the_folder_become_members_and_missing_ones_null) {
  Error error;
  Page page;
  Text html = {0};
  put("table.csv", "a,b\n1,\"2\"\n");
  put("summary.json", "{\"cases\": 3}\n");
  page_begin(&page, "study", scratch_folder, &error);
  ck_assert_int_eq(page_put_text(&page, "table", "table.csv"), STATUS_OK);
  ck_assert_int_eq(page_put_json(&page, "summary", "summary.json"), STATUS_OK);
  ck_assert_int_eq(page_put_text(&page, "no text", "missing"), STATUS_OK);
  ck_assert_int_eq(page_put_json(&page, "no json", "missing"), STATUS_OK);
  ck_assert_int_eq(page_end(&page), STATUS_OK);
  page_free(&page);
  ck_assert_int_eq(file_read(scratch_path("report.html"), (size_t)1 << 24, &html, &error), STATUS_OK);
  static const char *const members[] = {
      "\"kind\": \"study\",", "\"table\": \"a,b\\u000a1,\\\"2\\\"\\u000a\",",
      "\"summary\": {\"cases\": 3}\n,", "\"no text\": null,", "\"no json\": null\n}"};
  for (size_t k = 0; k < sizeof members / sizeof *members; k++)
    ck_assert_msg(occurrences(html.data, members[k]) == 1, "%s", members[k]);
  text_free(&html);
}
END_TEST

START_TEST(a_folder_that_cannot_be_written_is_told) {
  Error error;
  Page page;
  page_begin(&page, "run", scratch_path("missing"), &error);
  ck_assert_int_eq(page_end(&page), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "missing/report.html"));
  page_free(&page);
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  const int result =
      suite_run("page", (SuiteTests){the_data_stand_in_their_element, a_name_cannot_end_the_element,
                                     nothing_is_loaded, the_licences_of_the_libraries_are_in_the_page,
                                     files_of_the_folder_become_members_and_missing_ones_null,
                                     a_folder_that_cannot_be_written_is_told, NULL});
  scratch_remove();
  return result;
}
