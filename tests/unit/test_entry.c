/* Entries of a study file, and messages that say where another was expected. */
#include "study/entry.h"
#include "study_file.h"
#include "suite.h"

static YamlNode *root;

static const YamlNode *entry(const char *key) {
  return yaml_tree_find(root, key);
}

static void open_tree(void) {
  root = tree_of("word: abc\nempty:\nnumber: 2.5e-1\ncount: 12\nhalf: 2.5\nunit: 3 N/m\nlist: [1]\n");
}

START_TEST(what_is_there_is_read) {
  open_tree();
  Error error;
  const YamlNode *node;
  const char *text;
  double number;
  int count, choice;
  ck_assert_int_eq(entry_find(root, "word", "a word", &node, &error), STATUS_OK);
  ck_assert_ptr_eq(node, entry("word"));
  ck_assert_int_eq(entry_text(node, "word", &text, &error), STATUS_OK);
  ck_assert_str_eq(text, "abc");
  ck_assert_int_eq(entry_number(entry("number"), "number", &number, &error), STATUS_OK);
  ck_assert(number == 0.25);
  ck_assert_int_eq(entry_count(entry("count"), "count", 12, &count, &error), STATUS_OK);
  ck_assert_int_eq(count, 12);
  ck_assert_int_eq(
      entry_choice(entry("word"), "word", (const char *const[]){"x", "abc", NULL}, &choice, &error),
      STATUS_OK);
  ck_assert_int_eq(choice, 1);
  yaml_tree_free(root);
}
END_TEST

START_TEST(what_is_not_there_is_named_with_the_place) {
  open_tree();
  Error error;
  const YamlNode *node;
  ck_assert_int_eq(entry_find(root, "kind", "`a` or `b`", &node, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "test.yaml:1:1: expected the key `kind` (`a` or `b`), found none");
  yaml_tree_free(root);
}
END_TEST

START_TEST(what_is_no_text_is_refused) {
  open_tree();
  Error error;
  const char *text;
  ck_assert_int_eq(entry_text(entry("empty"), "empty", &text, &error), STATUS_INPUT);
  expect_words(&error, "expected text for `empty`, found nothing");
  ck_assert_int_eq(entry_text(entry("list"), "list", &text, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "test.yaml:7:7: expected text for `list`, found a list");
  yaml_tree_free(root);
}
END_TEST

START_TEST(what_is_no_number_is_refused) {
  open_tree();
  static const char *const wrong[] = {"word", "unit", "list", "empty"};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    Error error = {.text = "nothing"};
    double number;
    ck_assert_int_eq(entry_number(entry(wrong[i]), "x", &number, &error), STATUS_INPUT);
    expect_words(&error, "expected a number for `x`, found ");
  }
  yaml_tree_free(root);
}
END_TEST

START_TEST(a_count_is_a_whole_number_from_the_least_one_on) {
  open_tree();
  Error error;
  int count;
  ck_assert_int_eq(entry_count(entry("half"), "n", 1, &count, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "test.yaml:5:7: expected a whole number of at least 1 for `n`, found `2.5`");
  ck_assert_int_eq(entry_count(entry("count"), "n", 13, &count, &error), STATUS_INPUT);
  expect_words(&error, "expected a whole number of at least 13 for `n`, found `12`");
  ck_assert_int_eq(entry_count(entry("word"), "n", 1, &count, &error), STATUS_INPUT);
  expect_words(&error, "expected a number for `n`");
  yaml_tree_free(root);
}
END_TEST

START_TEST(a_choice_lists_the_words_and_the_nearest_one) {
  open_tree();
  Error error;
  int choice;
  ck_assert_int_eq(
      entry_choice(entry("word"), "x", (const char *const[]){"abd", "or", "other", NULL}, &choice, &error),
      STATUS_INPUT);
  ck_assert_str_eq(
      error.text,
      "test.yaml:1:7: expected `abd`, `or` or `other` for `x`, found `abc` (did you mean `abd`?)");
  yaml_tree_free(root);
}
END_TEST

START_TEST(a_key_in_neither_list_is_refused) {
  static const char *const all[] = {"word", "empty", "number", "count", NULL}, *const more[] = {"half",
                                                                                                "unit",
                                                                                                "list", NULL};
  open_tree();
  Error error;
  ck_assert_int_eq(entry_check_keys(root, all, more, &error), STATUS_OK);
  ck_assert_int_eq(entry_check_keys(root, all, more + 1, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "test.yaml:5:1: expected a known key, found `half`");
  ck_assert_int_eq(entry_check_keys(root, more, all + 1, &error), STATUS_INPUT);
  expect_words(&error, "test.yaml:1:1: expected a known key, found `word`");
  ck_assert_int_eq(entry_check_keys(root, all, NULL, &error), STATUS_INPUT);
  yaml_tree_free(root);
}
END_TEST

int main(void) {
  return suite_run("entry", (SuiteTests){what_is_there_is_read, what_is_not_there_is_named_with_the_place,
                                         what_is_no_text_is_refused, what_is_no_number_is_refused,
                                         a_count_is_a_whole_number_from_the_least_one_on,
                                         a_choice_lists_the_words_and_the_nearest_one,
                                         a_key_in_neither_list_is_refused, NULL});
}
