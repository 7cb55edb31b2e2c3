/* Criteria of a study: how they are read, scaled and handed to scenes. */
#include "study/contender.h"

#include "base/array.h"
#include "suite.h"
#include <string.h>

/* The list of criteria as a study of nothing else. */
static Status read(const char *text, YamlNode **root, Contender **contenders, size_t *n, Error *error) {
  const Status status = yaml_tree_parse(root, "study.yaml", true, text, strlen(text), error);
  if (status != STATUS_OK) return status;
  return contenders_read(&(Study){.root = *root}, contenders, n, error);
}

START_TEST(only_the_strength_is_scaled_and_units_are_kept) {
  YamlNode *root;
  Contender *contenders;
  size_t n;
  Error error;
  Text text = {0};
  ck_assert_int_eq(read("criteria: [{law: power, parameters: {Y_D: 0.2, Y_C: 2 mN/m, m: 1.5}, "
                        "strength: [Y_D, Y_C]}, {name: b, law: ./x.so}]",
                        &root, &contenders, &n, &error),
                   STATUS_OK);
  ck_assert_uint_eq(n, 2);
  ck_assert_str_eq(contenders[0].name, "power");
  ck_assert_int_eq(contender_print(&contenders[0], "one", 0.5, &text, &error), STATUS_OK);
  ck_assert_str_eq(text.data, "{name: one, law: power, parameters: {Y_D: 0.1, Y_C: 0.001 kg.s^-2, m: 1.5}}");
  text.length = 0;
  ck_assert_int_eq(contender_print(&contenders[0], NULL, 1, &text, &error), STATUS_OK);
  ck_assert_str_eq(text.data, "{law: power, parameters: {Y_D: 0.2, Y_C: \"2 mN/m\", m: 1.5}}");
  text.length = 0;
  ck_assert_int_eq(contender_print(&contenders[1], "b", 2, &text, &error), STATUS_OK);
  ck_assert_str_eq(text.data, "{name: b, law: ./x.so, parameters: {}}");
  text_free(&text);
  array_free(contenders);
  yaml_tree_free(root);
}
END_TEST

START_TEST(what_makes_no_sense_is_refused_at_its_place) {
  static const struct {
    const char *text, *place, *words;
  } table[] = {
      {"a: 1", "study.yaml:1:1:", "expected the key `criteria`"},
      {"criteria: []", "study.yaml:1:11:", "a list of damage laws"},
      {"criteria: [a]", "study.yaml:1:12:", "found `a`"},
      {"criteria: [{name: a}]", "study.yaml:1:12:", "expected the key `law`"},
      {"criteria: [{law: a, strenght: [b]}]", "study.yaml:1:21:", "did you mean `strength`"},
      {"criteria: [{law: a, parameters: 1}]", "study.yaml:1:33:", "a mapping for `parameters`"},
      {"criteria: [{law: a, strength: b}]", "study.yaml:1:31:", "a list of parameters"},
      {"criteria: [{law: a, strength: [b]}]", "study.yaml:1:32:", "found `b`"},
      {"criteria: [{law: a, parameters: {b: {c: 1}}, strength: [b]}]", "study.yaml:1:57:", "found `b`"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    YamlNode *root = NULL;
    Contender *contenders;
    size_t n;
    Error error;
    ck_assert_int_eq(read(table[i].text, &root, &contenders, &n, &error), STATUS_INPUT);
    ck_assert_msg(strncmp(error.text, table[i].place, strlen(table[i].place)) == 0, "%s: %s", table[i].place,
                  error.text);
    ck_assert_msg(strstr(error.text, table[i].words) != NULL, "%s: %s", table[i].words, error.text);
    ck_assert_ptr_null(contenders);
    yaml_tree_free(root);
  }
}
END_TEST

int main(void) {
  return suite_run("contender", (SuiteTests){only_the_strength_is_scaled_and_units_are_kept,
                                             what_makes_no_sense_is_refused_at_its_place, NULL});
}
