/* What a threshold study looks for: entries of `find`, and whether they hold in a case. */
#include "study/target.h"
#include "study_file.h"
#include "suite.h"

static Status read(const char *yaml, YamlNode **root, Target *target, Error *error) {
  *root = tree_of(yaml);
  return target_read(*root, target, error);
}

START_TEST(the_limits_of_the_literature_have_names) {
  YamlNode *root;
  Target target;
  Error error;
  ck_assert_int_eq(read("Ca_c", &root, &target, &error), STATUS_OK);
  ck_assert_str_eq(target.name, "Ca_c");
  ck_assert_str_eq(target.key, "flow.capillary_number");
  ck_assert_int_eq(target.condition, WHEN_DAMAGED);
  yaml_tree_free(root);
  ck_assert_int_eq(read("Ca_l", &root, &target, &error), STATUS_OK);
  ck_assert_int_eq(target.condition, WHEN_RUPTURED);
  yaml_tree_free(root);
}
END_TEST

START_TEST(a_target_of_ones_own_has_a_key_and_a_condition) {
  YamlNode *root;
  Target target;
  Error error;
  ck_assert_int_eq(read("{name: half, when: d_max, above: 0.5}", &root, &target, &error), STATUS_OK);
  ck_assert_str_eq(target.key, "flow.capillary_number");
  ck_assert_int_eq(target.condition, WHEN_ABOVE);
  ck_assert_str_eq(target.figure, "d_max");
  ck_assert(target.above == 0.5);
  yaml_tree_free(root);
  ck_assert_int_eq(read("{name: G, key: membrane.parameters.G_s, when: ruptured}", &root, &target, &error),
                   STATUS_OK);
  ck_assert_str_eq(target.key, "membrane.parameters.G_s");
  ck_assert_int_eq(target.condition, WHEN_RUPTURED);
  yaml_tree_free(root);
}
END_TEST

START_TEST(mistakes_are_named_with_their_place) {
  static const struct {
    const char *yaml, *words;
  } table[] = {
      {"Ca_x", "1:1: expected `Ca_c` or `Ca_l` for `find`, found `Ca_x` (did you mean `Ca_c`?)"},
      {"[Ca_c]", "1:1: expected `Ca_c`, `Ca_l` or {name, key, when} in `find`, found a list"},
      {"{name: a}", "expected the key `when`"},
      {"{when: damaged}", "expected the key `name`"},
      {"{name: a, when: d_max}", "expected the key `above` (a number), found none"},
      {"{name: a, when: d_max, above: much}", "1:31: expected a number for `above`, found `much`"},
      {"{name: a, when: damaged, above: 1}",
       "1:26: expected `above` only with a figure of summary.json, found it"},
      {"{name: a, when: damaged, kye: b}", "found `kye` (did you mean `key`?)"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    YamlNode *root;
    Target target;
    Error error = {.text = "nothing"};
    ck_assert_msg(read(table[i].yaml, &root, &target, &error) == STATUS_INPUT, "%s", table[i].yaml);
    expect_words(&error, table[i].words);
    yaml_tree_free(root);
  }
}
END_TEST

START_TEST(a_condition_holds_by_the_figures_of_the_case) {
  const Target damaged = {.condition = WHEN_DAMAGED}, ruptured = {.condition = WHEN_RUPTURED};
  const Target above = {.condition = WHEN_ABOVE, .figure = "d_max", .above = 0.2},
               not_above = {.condition = WHEN_ABOVE, .figure = "d_max", .above = 0.3},
               nowhere = {.condition = WHEN_ABOVE, .figure = "none", .above = -1};
  Case item = {.state = CASE_DONE,
               .summary = tree_of("{t_c: 0.4, t_l: null, d_max: 0.3, criteria: [{t_c: null, t_l: 2}]}")};
  ck_assert(target_holds(&damaged, &item, NULL));
  ck_assert(!target_holds(&ruptured, &item, NULL));
  ck_assert(target_holds(&above, &item, NULL));
  ck_assert(!target_holds(&not_above, &item, NULL));
  ck_assert(!target_holds(&nowhere, &item, NULL));
  ck_assert(!target_holds(&damaged, &item, "criteria.0."));
  ck_assert(target_holds(&ruptured, &item, "criteria.0."));
  yaml_tree_free(item.summary);
}
END_TEST

int main(void) {
  return suite_run("target", (SuiteTests){the_limits_of_the_literature_have_names,
                                          a_target_of_ones_own_has_a_key_and_a_condition,
                                          mistakes_are_named_with_their_place,
                                          a_condition_holds_by_the_figures_of_the_case, NULL});
}
