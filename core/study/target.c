#include "study/target.h"

#include "study/entry.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char CAPILLARY_NUMBER[] = "flow.capillary_number";

static const Target NAMED[] = {
    {.name = "Ca_c", .key = CAPILLARY_NUMBER, .condition = WHEN_DAMAGED},
    {.name = "Ca_l", .key = CAPILLARY_NUMBER, .condition = WHEN_RUPTURED},
};

static Status read_named(const YamlNode *node, Target *target, Error *error) {
  static const char *const names[] = {"Ca_c", "Ca_l", NULL};
  int choice;
  const Status status = entry_choice(node, "find", names, &choice, error);
  if (status == STATUS_OK) *target = NAMED[choice];
  return status;
}

static Status read_condition(const YamlNode *node, Target *target, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *when, *above = yaml_tree_find(node, "above");
  const char *word;
  TRY(entry_find(node, "when", "`damaged`, `ruptured` or a figure of summary.json", &when, error));
  TRY(entry_text(when, "when", &word, error));
  target->condition = strcmp(word, "damaged") == 0    ? WHEN_DAMAGED
                      : strcmp(word, "ruptured") == 0 ? WHEN_RUPTURED
                                                      : WHEN_ABOVE;
  if (target->condition == WHEN_ABOVE) {
    target->figure = word;
    TRY(entry_find(node, "above", "a number", &above, error));
    TRY(entry_number(above, "above", &target->above, error));
  } else if (above) {
    TRY(place_error(&above->key_place, error,
                    "expected `above` only with a figure of summary.json, found it "
                    "with `%s`",
                    word));
  }
cleanup:
  return status;
}

Status target_read(const YamlNode *node, Target *target, Error *error) {
  static const char *const keys[] = {"name", "key", "when", "above", NULL};
  Status status = STATUS_OK;
  if (node->kind == YAML_TREE_TEXT) return read_named(node, target, error);
  if (node->kind != YAML_TREE_MAPPING)
    return place_error(&node->place, error,
                       "expected `Ca_c`, `Ca_l` or {name, key, when} in `find`, found %s",
                       yaml_tree_found(node).text);
  const YamlNode *name, *key = yaml_tree_find(node, "key");
  *target = (Target){.key = CAPILLARY_NUMBER};
  TRY(entry_check_keys(node, keys, NULL, error));
  TRY(entry_find(node, "name", "a name for the column", &name, error));
  TRY(entry_text(name, "name", &target->name, error));
  if (key) TRY(entry_text(key, "key", &target->key, error));
  TRY(read_condition(node, target, error));
cleanup:
  return status;
}

static bool has_time(const Case *item, const char *where, const char *event) {
  char key[48];
  snprintf(key, sizeof key, "%s%s", where ? where : "", event);
  return isfinite(case_number(item, key));
}

bool target_holds(const Target *target, const Case *item, const char *where) {
  switch (target->condition) {
  case WHEN_DAMAGED:
    return has_time(item, where, "t_c");
  case WHEN_RUPTURED:
    return has_time(item, where, "t_l");
  case WHEN_ABOVE:
    return case_number(item, target->figure) > target->above;
  }
  return false;
}
