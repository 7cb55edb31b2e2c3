/* What a search is to find: how it is read, and when the condition holds. */
#include "study/plan.h"

#include "suite.h"
#include <string.h>

static Status read(const char *text, YamlNode **root, Plan *plan, Error *error) {
  const Status status = yaml_tree_parse(root, "study.yaml", true, text, strlen(text), error);
  if (status != STATUS_OK) return status;
  return plan_read(&(Study){.root = *root}, plan, error);
}

START_TEST(targets_are_read_with_their_bracket) {
  YamlNode *root;
  Plan plan;
  Error error;
  ck_assert_int_eq(read("find: [Ca_l, {name: G, key: membrane.parameters.G_s, when: D12, above: 0.5}]\n"
                        "bracket: [0.1, 1.2]\ntolerance: 0.005\n",
                        &root, &plan, &error),
                   STATUS_OK);
  ck_assert_uint_eq(plan.n_targets, 2);
  ck_assert_str_eq(plan.target[0].key, "flow.capillary_number");
  ck_assert_int_eq(plan.target[0].condition, WHEN_RUPTURED);
  ck_assert_str_eq(plan.target[1].figure, "D12");
  ck_assert(plan.low == 0.1 && plan.high == 1.2 && plan.tolerance == 0.005 && plan.target[1].above == 0.5);
  yaml_tree_free(root);
}
END_TEST

START_TEST(what_makes_no_sense_is_refused_at_its_place) {
  static const struct {
    const char *text, *words;
  } table[] = {
      {"bracket: [1, 2]\ntolerance: 0.1", "expected the key `find`"},
      {"find: [Ca_l]\ntolerance: 0.1", "expected the key `bracket`"},
      {"find: [Ca_l]\nbracket: [1, 2]", "expected the key `tolerance`"},
      {"find: []\nbracket: [1, 2]\ntolerance: 0.1", "study.yaml:1:7: expected a list of 1 to 8 targets"},
      {"find: [Ca_l, Ca_l]\nbracket: [1, 2]\ntolerance: 0.1", "study.yaml:1:14: expected each target once"},
      {"find: [Ca_l]\nbracket: [0, 2]\ntolerance: 0.1", "study.yaml:2:10: expected 0 < low < high"},
      {"find: [Ca_l]\nbracket: 2\ntolerance: 0.1", "study.yaml:2:10: expected [low, high]"},
      {"find: [Ca_l]\nbracket: [1, 2]\ntolerance: 0", "study.yaml:3:12: expected a number above 0"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    YamlNode *root = NULL;
    Plan plan;
    Error error;
    ck_assert_int_eq(read(table[i].text, &root, &plan, &error), STATUS_INPUT);
    ck_assert_msg(strstr(error.text, table[i].words) != NULL, "%s: %s", table[i].words, error.text);
    yaml_tree_free(root);
  }
}
END_TEST

START_TEST(a_condition_is_looked_up_for_the_membrane_or_for_one_that_looks_on) {
  static const char summary[] =
      "{\"t_c\": 1, \"t_l\": null, \"D12\": 0.4, \"criteria\": [{\"t_c\": null, \"t_l\": null}, "
      "{\"t_c\": 0.5, \"t_l\": 2}]}";
  Error error;
  Case item = {.state = CASE_DONE};
  ck_assert_int_eq(yaml_tree_parse(&item.summary, "summary.json", true, summary, strlen(summary), &error),
                   STATUS_OK);
  const Target onset = {.condition = WHEN_DAMAGED}, rupture = {.condition = WHEN_RUPTURED};
  ck_assert(target_holds(&onset, &item, NULL) && !target_holds(&rupture, &item, NULL));
  ck_assert(!target_holds(&onset, &item, "criteria.0.") && !target_holds(&rupture, &item, "criteria.0."));
  ck_assert(target_holds(&onset, &item, "criteria.1.") && target_holds(&rupture, &item, "criteria.1."));
  ck_assert(!target_holds(&rupture, &item, "criteria.2."));
  const Target level = {.condition = WHEN_ABOVE, .figure = "D12", .above = 0.3};
  ck_assert(target_holds(&level, &item, NULL));
  yaml_tree_free(item.summary);
}
END_TEST

int main(void) {
  return suite_run(
      "plan", (SuiteTests){targets_are_read_with_their_bracket, what_makes_no_sense_is_refused_at_its_place,
                           a_condition_is_looked_up_for_the_membrane_or_for_one_that_looks_on, NULL});
}
