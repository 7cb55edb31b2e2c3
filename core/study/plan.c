#include "study/plan.h"

#include "study/entry.h"
#include <string.h>

static Status read_targets(const YamlNode *find, Plan *plan, Error *error) {
  Status status = STATUS_OK;
  if (find->kind != YAML_TREE_LIST || find->count == 0 || find->count > MOST_TARGETS)
    return place_error(&find->place, error, "expected a list of 1 to %d targets for `find`, found %s",
                       MOST_TARGETS, yaml_tree_found(find).text);
  for (; plan->n_targets < find->count; plan->n_targets++) {
    const YamlNode *node = find->items[plan->n_targets];
    Target *target = &plan->target[plan->n_targets];
    TRY(target_read(node, target, error));
    for (size_t i = 0; i < plan->n_targets; i++)
      if (strcmp(plan->target[i].name, target->name) == 0)
        TRY(place_error(&node->place, error, "expected each target once, found `%s` again", target->name));
  }
cleanup:
  return status;
}

static Status read_bracket(const YamlNode *node, Plan *plan, Error *error) {
  Status status = STATUS_OK;
  if (node->kind != YAML_TREE_LIST || node->count != 2)
    return place_error(&node->place, error, "expected [low, high] for `bracket`, found %s",
                       yaml_tree_found(node).text);
  TRY(entry_number(node->items[0], "bracket", &plan->low, error));
  TRY(entry_number(node->items[1], "bracket", &plan->high, error));
  if (!(plan->low > 0 && plan->low < plan->high))
    TRY(place_error(&node->place, error, "expected 0 < low < high for `bracket`, found [%g, %g]", plan->low,
                    plan->high));
cleanup:
  return status;
}

Status plan_read(const Study *study, Plan *plan, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *find, *bracket, *tolerance;
  *plan = (Plan){0};
  TRY(entry_find(study->root, "find", "a list such as [Ca_c, Ca_l]", &find, error));
  TRY(entry_find(study->root, "bracket", "[low, high]", &bracket, error));
  TRY(entry_find(study->root, "tolerance", "a number above 0", &tolerance, error));
  TRY(read_targets(find, plan, error));
  TRY(read_bracket(bracket, plan, error));
  TRY(entry_number(tolerance, "tolerance", &plan->tolerance, error));
  if (!(plan->tolerance > 0 && plan->tolerance < plan->high - plan->low))
    TRY(place_error(&tolerance->place, error,
                    "expected a number above 0 and below the length of the bracket for `tolerance`, found %g",
                    plan->tolerance));
cleanup:
  return status;
}
