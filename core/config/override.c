/* One setting is split at its first "=" and its dots; whether the key is known is the schema's business. */
#include "config/override.h"

#include "base/array.h"
#include "base/text.h"
#include <string.h>

/* The mapping under `name` in `parent`; made when it is missing. */
static Status descend(YamlNode **parent, const char *name, const SourcePlace *place, Error *error) {
  YamlNode *child = yaml_tree_find(*parent, name);
  if (!child) {
    child = yaml_tree_new(YAML_TREE_MAPPING, *place, error);
    if (!child) return error->code;
    Status status = yaml_tree_insert(*parent, name, *place, child, error);
    if (status != STATUS_OK) {
      yaml_tree_free(child);
      return status;
    }
  }
  if (child->kind != YAML_TREE_MAPPING)
    return place_error(place, error, "expected a mapping under `%s`, found %s", name,
                       yaml_tree_found(child).text);
  *parent = child;
  return STATUS_OK;
}

/* Lets a value and all in it stand at the place of the setting. */
static void relocate(YamlNode *node, const SourcePlace *place) {
  node->place = node->key_place = *place;
  for (size_t i = 0; i < node->count; i++) relocate(node->items[i], place);
}

static Status assign(YamlNode *parent, const char *name, const char *value, const SourcePlace *place,
                     Error *error) {
  YamlNode *node = NULL;
  Status status = STATUS_OK;
  if (*value) {
    TRY(yaml_tree_parse(&node, place->file, false, value, strlen(value), error));
    relocate(node, place);
  }
  yaml_tree_remove(parent, name);
  if (node) TRY(yaml_tree_insert(parent, name, *place, node, error));
  return STATUS_OK;
cleanup:
  yaml_tree_free(node);
  return status;
}

Status override_put(YamlNode *root, const char *key, const char *value, const SourcePlace *place,
                    Error *error) {
  Status status = STATUS_OK;
  char *names = text_copy(key, error);
  if (!names) return error->code;
  char *name = names;
  int depth = 1;
  for (char *dot; (dot = strchr(name, '.')); name = dot + 1) {
    *dot = '\0';
    if (dot == name || ++depth > YAML_TREE_DEPTH) break;
    TRY(descend(&root, name, place, error));
  }
  if (!*name || strchr(name, '.'))
    TRY(place_error(place, error, "expected a key such as `flow.capillary_number` before the `=`"));
  TRY(assign(root, name, value, place, error));
cleanup:
  array_free(names);
  return status;
}

Status override_apply(YamlNode *root, const char *setting, const char *source, Error *error) {
  const SourcePlace place = {.file = source};
  const char *equals = strchr(setting, '=');
  if (!equals) return place_error(&place, error, "expected KEY=VALUE, found no `=`");
  char *key = text_copy(setting, error);
  if (!key) return error->code;
  key[equals - setting] = '\0';
  const Status status = override_put(root, key, equals + 1, &place, error);
  array_free(key);
  return status;
}
