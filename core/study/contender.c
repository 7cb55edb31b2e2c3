#include "study/contender.h"

#include "base/array.h"
#include "config/yaml_print.h"
#include "study/entry.h"
#include <string.h>

/* The strength is a list of parameters that are given as numbers. */
static Status check_strength(const Contender *contender, Error *error) {
  const YamlNode *list = contender->strength;
  Status status = STATUS_OK;
  if (!list) return STATUS_OK;
  if (list->kind != YAML_TREE_LIST || list->count == 0)
    return place_error(&list->place, error, "expected a list of parameters for `strength`, found %s",
                       yaml_tree_found(list).text);
  for (size_t i = 0; i < list->count; i++) {
    const char *name;
    TRY(entry_text(list->items[i], "strength", &name, error));
    const YamlNode *value = contender->parameters ? yaml_tree_find(contender->parameters, name) : NULL;
    Quantity quantity;
    Error why;
    if (!value || value->kind != YAML_TREE_TEXT || units_parse(value->text, &quantity, &why) != STATUS_OK)
      TRY(place_error(&list->items[i]->place, error,
                      "expected a parameter that `parameters` gives as a number, found `%.60s`", name));
  }
cleanup:
  return status;
}

static Status read_contender(const YamlNode *node, Contender *contender, Error *error) {
  static const char *const keys[] = {"name", "law", "parameters", "strength", NULL};
  Status status = STATUS_OK;
  if (node->kind != YAML_TREE_MAPPING)
    return place_error(&node->place, error,
                       "expected a mapping `{name: , law: , parameters: , strength: }`, found %s",
                       yaml_tree_found(node).text);
  TRY(entry_check_keys(node, keys, NULL, error));
  TRY(entry_find(node, "law", "a damage law", &contender->law, error));
  TRY(entry_text(contender->law, "law", &contender->name, error));
  const YamlNode *name = yaml_tree_find(node, "name");
  if (name) TRY(entry_text(name, "name", &contender->name, error));
  contender->parameters = yaml_tree_find(node, "parameters");
  if (contender->parameters && contender->parameters->kind != YAML_TREE_MAPPING)
    TRY(place_error(&contender->parameters->place, error, "expected a mapping for `parameters`, found %s",
                    yaml_tree_found(contender->parameters).text));
  contender->strength = yaml_tree_find(node, "strength");
  TRY(check_strength(contender, error));
cleanup:
  return status;
}

Status contenders_read(const Study *study, Contender **contenders, size_t *n, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *list;
  *contenders = NULL;
  TRY(entry_find(study->root, "criteria", "a list of damage laws", &list, error));
  if (list->kind != YAML_TREE_LIST || list->count == 0)
    return place_error(&list->place, error, "expected a list of damage laws for `criteria`, found %s",
                       yaml_tree_found(list).text);
  TRY(ARRAY_NEW(contenders, list->count, error));
  for (*n = 0; *n < list->count; ++*n) TRY(read_contender(list->items[*n], &(*contenders)[*n], error));
cleanup:
  if (status != STATUS_OK) {
    array_free(*contenders);
    *contenders = NULL;
  }
  return status;
}

Status contender_find(const Contender *contenders, size_t n, const YamlNode *node, size_t *found,
                      Error *error) {
  const char *name;
  const Status status = entry_text(node, node->key ? node->key : "a criterion", &name, error);
  if (status != STATUS_OK) return status;
  for (*found = 0; *found < n; ++*found)
    if (strcmp(contenders[*found].name, name) == 0) return STATUS_OK;
  return place_error(&node->place, error, "expected the name of one of the criteria, found `%.60s`", name);
}

static bool is_strength(const Contender *contender, const char *parameter) {
  for (size_t i = 0; contender->strength && i < contender->strength->count; i++)
    if (strcmp(contender->strength->items[i]->text, parameter) == 0) return true;
  return false;
}

static Status print_value(const Contender *contender, const YamlNode *value, double scale, Text *yaml,
                          Error *error) {
  Quantity quantity;
  if (scale == 1 || !is_strength(contender, value->key)) return yaml_print_inline(value, yaml, error);
  const Status status = units_parse(value->text, &quantity, error);
  if (status != STATUS_OK) return status;
  quantity.value *= scale;
  return units_print(yaml, &quantity, error);
}

Status contender_print(const Contender *contender, const char *name, double scale, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *parameters = contender->parameters;
  TRY(text_append(yaml, error, "{"));
  if (name) {
    TRY(text_append(yaml, error, "name: "));
    TRY(yaml_print_text(name, yaml, error));
    TRY(text_append(yaml, error, ", "));
  }
  TRY(text_append(yaml, error, "law: "));
  TRY(yaml_print_inline(contender->law, yaml, error));
  TRY(text_append(yaml, error, ", parameters: {"));
  for (size_t i = 0; parameters && i < parameters->count; i++) {
    TRY(text_append(yaml, error, "%s%s: ", i ? ", " : "", parameters->items[i]->key));
    TRY(print_value(contender, parameters->items[i], scale, yaml, error));
  }
  TRY(text_append(yaml, error, "}}"));
cleanup:
  return status;
}
