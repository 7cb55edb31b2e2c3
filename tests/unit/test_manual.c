/* The manual of scene files: complete, and the delivered copy is what the program prints. */
#include "base/file.h"
#include "config/schema.h"
#include "suite.h"
#include <string.h>

START_TEST(the_delivered_manual_is_what_the_schema_prints) {
  Text printed = {0}, delivered = {0};
  Error error;
  ck_assert_int_eq(scene_print_manual(&printed, &error), STATUS_OK);
  Status status = file_read(SOURCE_DIR "/docs/configuration.md", 1 << 20, &delivered, &error);
  ck_assert_msg(status == STATUS_OK, "%s", error.text);
  ck_assert_msg(strcmp(delivered.data, printed.data) == 0,
                "docs/configuration.md is out of date: run `capsella manual > docs/configuration.md`");
  text_free(&printed);
  text_free(&delivered);
}
END_TEST

START_TEST(every_key_has_one_line_with_its_meaning) {
  Text printed = {0};
  Error error;
  ck_assert_int_eq(scene_print_manual(&printed, &error), STATUS_OK);
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    Text start = {0};
    ck_assert_int_eq(text_append(&start, &error, "\n| `%s` | ", SCHEMA[i].key), STATUS_OK);
    const char *line = strstr(printed.data, start.data);
    ck_assert_msg(line != NULL, "%s", SCHEMA[i].key);
    const char *meaning = strstr(line, SCHEMA[i].meaning);
    ck_assert_ptr_nonnull(meaning);
    ck_assert(strchr(line + 1, '\n') > meaning); /* in the same line */
    text_free(&start);
  }
  text_free(&printed);
}
END_TEST

int main(void) {
  return suite_run("manual", (SuiteTests){the_delivered_manual_is_what_the_schema_prints,
                                          every_key_has_one_line_with_its_meaning, NULL});
}
