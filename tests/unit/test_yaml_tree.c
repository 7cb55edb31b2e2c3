/* The tree: every node knows its place, and all that is not plain YAML is refused with one. */
#include "base/array.h"
#include "base/text.h"
#include "config/yaml_tree.h"
#include "suite.h"
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static YamlNode *parse_good(const char *text) {
  YamlNode *root;
  Error error;
  Status status = yaml_tree_parse(&root, "t.yaml", true, text, strlen(text), &error);
  ck_assert_msg(status == STATUS_OK, "%s", error.text);
  return root;
}

static void expect_place(const SourcePlace *place, int line, int column) {
  ck_assert_str_eq(place->file, "t.yaml");
  ck_assert_int_eq(place->line, line);
  ck_assert_int_eq(place->column, column);
}

START_TEST(nodes_know_their_lines_and_columns) {
  YamlNode *root = parse_good("# comment\n"
                              "a: 1\n"
                              "b:\n"
                              "  c: [x, 'y z', {d: \"e\"}]\n"
                              "  \xc3\xa9t\xc3\xa9: \xce\xbc  # columns count characters\n"
                              "list:\n"
                              "- one\n"
                              "- two words\n");
  ck_assert_int_eq(root->kind, YAML_TREE_MAPPING);
  ck_assert_uint_eq(root->count, 3);
  const YamlNode *a = yaml_tree_find(root, "a"), *b = yaml_tree_find(root, "b");
  ck_assert_str_eq(a->text, "1");
  expect_place(&a->key_place, 2, 1);
  expect_place(&a->place, 2, 4);
  expect_place(&b->place, 4, 3);
  const YamlNode *c = yaml_tree_find(b, "c");
  ck_assert_int_eq(c->kind, YAML_TREE_LIST);
  ck_assert_uint_eq(c->count, 3);
  ck_assert_str_eq(c->items[1]->text, "y z");
  expect_place(&c->items[1]->place, 4, 10);
  const YamlNode *d = yaml_tree_find(c->items[2], "d");
  ck_assert_str_eq(d->text, "e");
  expect_place(&d->key_place, 4, 18);
  expect_place(&d->place, 4, 21);
  expect_place(&yaml_tree_find(b, "\xc3\xa9t\xc3\xa9")->place, 5, 8);
  ck_assert_str_eq(yaml_tree_find(root, "list")->items[1]->text, "two words");
  expect_place(&yaml_tree_find(root, "list")->items[1]->place, 8, 3);
  ck_assert_ptr_null(yaml_tree_find(root, "missing"));
  yaml_tree_free(root);
}
END_TEST

START_TEST(scalars_stay_text) {
  YamlNode *root = parse_good("[no, 1e3, ~, '', null, 0x1, \"\\u00e9\"]");
  static const char *const texts[] = {"no", "1e3", "~", "", "null", "0x1", "\xc3\xa9"};
  for (size_t i = 0; i < 7; i++) ck_assert_str_eq(root->items[i]->text, texts[i]);
  yaml_tree_free(root);
}
END_TEST

START_TEST(a_byte_order_mark_and_windows_line_ends_change_nothing) {
  YamlNode *root = parse_good("\xef\xbb\xbf"
                              "a: 1\r\nb: 2\r\n");
  expect_place(&yaml_tree_find(root, "a")->key_place, 1, 1);
  expect_place(&yaml_tree_find(root, "b")->place, 2, 4);
  ck_assert_str_eq(yaml_tree_find(root, "a")->text, "1");
  yaml_tree_free(root);
}
END_TEST

typedef struct {
  const char *text, *message;
} Bad;

static void expect_refused(const char *text, size_t length, const char *message) {
  YamlNode *root;
  Error error;
  ck_assert_msg(yaml_tree_parse(&root, "t.yaml", true, text, length, &error) == STATUS_INPUT, "taken: %s",
                text);
  ck_assert_ptr_null(root);
  ck_assert_msg(strncmp(error.text, message, strlen(message)) == 0, "%s\nexpected: %s", error.text, message);
}

START_TEST(what_a_scene_does_not_need_is_refused) {
  static const Bad table[] = {
      {"", "t.yaml:1:1: expected a value, found nothing"},
      {"# only a comment\n", "t.yaml:2:1: expected a value, found nothing"},
      {"a: 1\nb: 2\na: 3\n", "t.yaml:3:1: expected each key once, found `a` again (first in line 1)"},
      {"x: {a: 1,\n  b: 2, a: 3}\n", "t.yaml:2:9: expected each key once, found `a` again (first in line 1)"},
      {"a: &x 1\n", "t.yaml:1:4: expected a value without an anchor, found `&x`"},
      {"a: &x [1]\n", "t.yaml:1:4: expected a value without an anchor"},
      {"a: &x {b: 1}\n", "t.yaml:1:4: expected a value without an anchor"},
      {"&x a: 1\n", "t.yaml:1:1: expected a value without an anchor"},
      {"a: 1\nb: *x\n", "t.yaml:2:4: expected a value, found the alias `*x`"},
      {"*x : 1\n", "t.yaml:1:1: expected a value, found the alias `*x`"},
      {"a: !!int 1\n", "t.yaml:1:4: expected a value without a tag, found `tag:yaml.org,2002:int`"},
      {"a: ! 1\n", "t.yaml:1:4: expected a value without a tag, found `!`"},
      {"a: !my {b: 1}\n", "t.yaml:1:4: expected a value without a tag, found `!my`"},
      {"a: !my [1]\n", "t.yaml:1:4: expected a value without a tag, found `!my`"},
      {"a: 1\n---\nb: 2\n", "t.yaml:2:1: expected one document, found a second one"},
      {"? [a, b]\n: 1\n", "t.yaml:1:3: expected a name as key, found a list or a mapping"},
      {"{a: 1}: 2\n", "t.yaml:1:1: expected a name as key, found a list or a mapping"},
      {"a: \"b\\0c\"\n", "t.yaml:1:4: expected printable text, found an escaped control character"},
      {"\"\\e\": 1\n", "t.yaml:1:1: expected printable text, found an escaped control character"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++)
    expect_refused(table[i].text, strlen(table[i].text), table[i].message);
}
END_TEST

START_TEST(bytes_that_are_no_text_are_refused_where_they_stand) {
  static const Bad table[] = {
      {"a: 1\nb: \xff\n", "t.yaml:2:4: expected printable UTF-8 text, found the byte 0xFF"},
      {"a: \xc3\xa9 \x1b\n", "t.yaml:1:6: expected printable UTF-8 text, found the byte 0x1B"},
      {"\xfe\xff", "t.yaml:1:1: expected printable UTF-8 text, found the byte 0xFE"},      /* UTF-16 */
      {"# \xe9t\xe9\n", "t.yaml:1:3: expected printable UTF-8 text, found the byte 0xE9"}, /* Latin-1 */
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++)
    expect_refused(table[i].text, strlen(table[i].text), table[i].message);
  expect_refused("a: 1\n\0: 2\n", 10, "t.yaml:2:1: expected printable UTF-8 text, found the byte 0x00");
}
END_TEST

START_TEST(mistakes_of_syntax_are_named_with_their_line) {
  static const Bad table[] = {
      {"a: b: c\n", "t.yaml:1:5: expected YAML, found a mistake"},
      {"a: [1, 2\nb: 3\n",
       "t.yaml:2:2: expected YAML, found a mistake while parsing a flow sequence (from line 1)"},
      {"a:\n\t- 1\n", "t.yaml:2:1: expected YAML, found a mistake"},
      {"a: 'open\n", "t.yaml:2:1: expected YAML, found a mistake"},
      {"a: 1\n b: 2\n", "t.yaml:2:3: expected YAML, found a mistake"},
      {"a: }\n", "t.yaml:1:4: expected YAML, found a mistake"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++)
    expect_refused(table[i].text, strlen(table[i].text), table[i].message);
}
END_TEST

/* `count` copies of a pattern; a "#" in it becomes the number of the copy. */
static Text repeat(const char *pattern, int count) {
  Text text = {0};
  Error error;
  char line[80];
  for (int i = 0; i < count; i++) {
    const char *number = strchr(pattern, '#');
    if (number) {
      snprintf(line, sizeof line, "%.*s%d%s", (int)(number - pattern), pattern, i, number + 1);
    } else {
      snprintf(line, sizeof line, "%s", pattern);
    }
    ck_assert_int_eq(text_append(&text, &error, "%s", line), STATUS_OK);
  }
  return text;
}

START_TEST(input_that_is_too_deep_or_too_large_is_refused) {
  Error error;
  YamlNode *root;
  Text deep = repeat("[", YAML_TREE_DEPTH + 1);
  expect_refused(deep.data, deep.length, "t.yaml:1:33: expected at most 32 levels, found one more");
  Text deeper = repeat("[", 100000);
  expect_refused(deeper.data, deeper.length, "t.yaml:1:33: expected at most 32 levels, found one more");
  Text keys = repeat("k#: 1\n", YAML_TREE_KEYS + 1);
  expect_refused(keys.data, keys.length,
                 "t.yaml:1001:1: expected at most 1000 keys in one mapping, found more");
  Text large =
      repeat("                                                               \n", YAML_TREE_BYTES / 64);
  expect_refused(large.data, large.length, "t.yaml:16385:1: expected a value, found nothing"); /* just fits */
  ck_assert_int_eq(text_append(&large, &error, "a"), STATUS_OK);
  expect_refused(large.data, large.length, "t.yaml:1:1: expected at most 1048576 bytes, found 1048577");
  Text list = repeat("- [#, 0.5]\n", 20000); /* a long table is fine */
  ck_assert_int_eq(yaml_tree_parse(&root, "t.yaml", true, list.data, list.length, &error), STATUS_OK);
  ck_assert_uint_eq(root->count, 20000);
  ck_assert_str_eq(root->items[19999]->items[0]->text, "19999");
  yaml_tree_free(root);
  text_free(&deep);
  text_free(&deeper);
  text_free(&keys);
  text_free(&large);
  text_free(&list);
}
END_TEST

START_TEST(trees_can_be_changed) {
  YamlNode *root = parse_good("{a: 1, b: 2, c: 3}");
  Error error;
  YamlNode *value = yaml_tree_new(YAML_TREE_MAPPING, root->place, &error);
  ck_assert_int_eq(yaml_tree_insert(root, "d", root->place, value, &error), STATUS_OK);
  yaml_tree_remove(root, "b");
  yaml_tree_remove(root, "missing");
  ck_assert_uint_eq(root->count, 3);
  ck_assert_ptr_null(yaml_tree_find(root, "b"));
  ck_assert_str_eq(yaml_tree_find(root, "c")->text, "3");
  ck_assert_ptr_eq(yaml_tree_find(root, "d"), value);
  yaml_tree_free(root);
}
END_TEST

START_TEST(what_was_found_is_described_briefly) {
  YamlNode *root =
      parse_good("[short, '', [], {}, \"a very long text that would fill the whole message, and more\"]");
  static const char *const words[] = {"`short`", "nothing", "a list", "a mapping",
                                      "`a very long text that would fill the who...`"};
  for (size_t i = 0; i < 5; i++) ck_assert_str_eq(yaml_tree_found(root->items[i]).text, words[i]);
  yaml_tree_free(root);
}
END_TEST

START_TEST(damaged_text_gives_a_tree_or_a_placed_message) {
  static const char SCENE[] = "schema: 1\nmembrane: {law: \"a\", parameters: {G_s: 1.0}}\n"
                              "flow:\n  kind: inflation\n  path:\n  - [0, 0]\n  - [1, 'x']\n# end\n";
  static const char BYTES[] = "[]{}:,-?&*!|>'\"%@` \n\t#\\x\xc3\xff";
  uint64_t state = 20210602;
  printf("seed %llu\n", (unsigned long long)state);
  int good = 0, bad = 0;
  for (int k = 0; k < 5000; k++) {
    char text[sizeof SCENE];
    memcpy(text, SCENE, sizeof SCENE);
    for (int changes = 0; changes < 1 + k % 4; changes++) {
      state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
      text[(state >> 33) % (sizeof SCENE - 1)] = BYTES[(state >> 20) % (sizeof BYTES)];
    }
    YamlNode *root;
    Error error;
    Status status = yaml_tree_parse(&root, "t.yaml", true, text, sizeof SCENE - 1, &error);
    if (status == STATUS_OK)
      good++;
    else {
      bad++;
      int line = 0, column = 0;
      ck_assert_int_eq(status, STATUS_INPUT);
      ck_assert_msg(sscanf(error.text, "t.yaml:%d:%d: expected", &line, &column) == 2, "%s", error.text);
      ck_assert_msg(line >= 1 && line <= 9 + 4 /* inserted */ && column >= 1, "%s", error.text);
    }
    yaml_tree_free(root);
  }
  ck_assert_int_gt(good, 100);
  ck_assert_int_gt(bad, 100);
}
END_TEST

int main(void) {
  return suite_run("yaml_tree", (SuiteTests){nodes_know_their_lines_and_columns, scalars_stay_text,
                                             a_byte_order_mark_and_windows_line_ends_change_nothing,
                                             what_a_scene_does_not_need_is_refused,
                                             bytes_that_are_no_text_are_refused_where_they_stand,
                                             mistakes_of_syntax_are_named_with_their_line,
                                             input_that_is_too_deep_or_too_large_is_refused,
                                             trees_can_be_changed, what_was_found_is_described_briefly,
                                             damaged_text_gives_a_tree_or_a_placed_message, NULL});
}
