/* Printed YAML reads back to the same tree. */
#include "config/yaml_print.h"
#include "suite.h"
#include <string.h>

static YamlNode *parse(const char *yaml) {
  YamlNode *root;
  Error error;
  const Status status = yaml_tree_parse(&root, "test", true, yaml, strlen(yaml), &error);
  ck_assert_msg(status == STATUS_OK, "%s\n%s", status == STATUS_OK ? "" : error.text, yaml);
  return root;
}

static void assert_same(const YamlNode *a, const YamlNode *b) {
  ck_assert_int_eq(a->kind, b->kind);
  ck_assert_uint_eq(a->count, b->count);
  if (a->text) ck_assert_str_eq(a->text, b->text);
  ck_assert(!a->key == !b->key);
  if (a->key) ck_assert_str_eq(a->key, b->key);
  for (size_t i = 0; i < a->count; i++) assert_same(a->items[i], b->items[i]);
}

static const char SCENE[] =
    "schema: 1\n"
    "name: \"a \\\"b\\\" \\\\ c: d #e\"\n"
    "empty:\n"
    "'odd key: 1': {}\n"
    "list: [1, -2.5, [a, {t: 1, u: [x, y]}], '', '- no list', -, 1e+3, \"line\\nbreak\"]\n"
    "law: ./laws/my.so#id\n"
    "deep: {a: {b: {c: 1}, d: []}}\n";

START_TEST(a_printed_file_reads_back_to_the_same_tree) {
  Error error;
  Text yaml = {0};
  YamlNode *before = parse(SCENE);
  ck_assert_int_eq(yaml_print_file(before, &yaml, &error), STATUS_OK);
  YamlNode *after = parse(yaml.data);
  assert_same(before, after);
  yaml_tree_free(after);
  yaml_tree_free(before);
  text_free(&yaml);
}
END_TEST

START_TEST(a_node_printed_on_one_line_reads_back_to_the_same_tree) {
  Error error;
  Text yaml = {0};
  YamlNode *before = parse(SCENE);
  ck_assert_int_eq(yaml_print_inline(before, &yaml, &error), STATUS_OK);
  ck_assert_ptr_null(strchr(yaml.data, '\n'));
  YamlNode *after = parse(yaml.data);
  assert_same(before, after);
  yaml_tree_free(after);
  yaml_tree_free(before);
  text_free(&yaml);
}
END_TEST

START_TEST(a_copy_is_the_same_tree_at_the_same_places) {
  Error error;
  YamlNode *tree = parse(SCENE), *copy;
  ck_assert_int_eq(yaml_tree_copy(&copy, tree, &error), STATUS_OK);
  assert_same(tree, copy);
  ck_assert_int_eq(copy->items[4]->items[2]->place.column, tree->items[4]->items[2]->place.column);
  ck_assert_int_eq(copy->items[4]->key_place.line, 5);
  yaml_tree_free(tree);
  yaml_tree_free(copy);
}
END_TEST

START_TEST(numbers_and_names_need_no_quotes) {
  static const char *const plain[] = {"0.2", "-1e-3", "neo_hookean", "./a.so", "2-d"};
  for (size_t i = 0; i < sizeof plain / sizeof *plain; i++) {
    Error error;
    Text yaml = {0};
    ck_assert_int_eq(yaml_print_text(plain[i], &yaml, &error), STATUS_OK);
    ck_assert_str_eq(yaml.data, plain[i]);
    text_free(&yaml);
  }
}
END_TEST

int main(void) {
  return suite_run("yaml_print", (SuiteTests){a_printed_file_reads_back_to_the_same_tree,
                                              a_node_printed_on_one_line_reads_back_to_the_same_tree,
                                              a_copy_is_the_same_tree_at_the_same_places,
                                              numbers_and_names_need_no_quotes, NULL});
}
