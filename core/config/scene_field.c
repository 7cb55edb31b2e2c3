/* Typing is by the table, as for the rest of a scene (value.c). */
#include "config/scene_field.h"

#include "base/array.h"
#include "config/scene_field_table.h"
#include "config/yaml_print.h"
#include <inttypes.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* ---- The table ---- */

#define AT(member) offsetof(SceneField, member)

const FieldForm SCENE_FIELD_FORMS[FIELD_KINDS] = {
    [FIELD_AROUND] = {"around",
                      false,
                      {{"around", ITEM_POINT, ITEM_REQUIRED, AT(center), false,
                        "`P`, where the vorticity axis leaves the capsule, or a point `[x, y, z]` of the "
                        "capsule at rest"},
                       {"radius", ITEM_NUMBER, ITEM_REQUIRED, AT(radius), true,
                        "distance from it, in a straight line, up to which the centres of elements count as "
                        "inside"},
                       {"inside", ITEM_QUANTITY, ITEM_REQUIRED, AT(inside), false, "value inside"},
                       {"outside", ITEM_QUANTITY, ITEM_REQUIRED, AT(outside), false, "value elsewhere"}},
                      "a spot"},
    [FIELD_FILE] =
        {"file",
         false,
         {{"file", ITEM_FILE, ITEM_REQUIRED, AT(file), false,
           "text file with one number for each element, in the order of the cells of a snapshot; a "
           "`#` begins a comment"},
          {"times", ITEM_QUANTITY, ITEM_OPTIONAL, AT(times), false,
           "what the numbers are multiplied by (default 1)"},
          {"hash", ITEM_HASH, ITEM_OPTIONAL, AT(hash), false,
           "FNV-1a hash of the file, in 16 hexadecimal digits; a file with another content is "
           "refused"}},
         "given element by element"},
    [FIELD_WEIBULL] =
        {"weibull",
         true,
         {{"mean", ITEM_QUANTITY, ITEM_OPTIONAL, AT(mean), false, "mean of the distribution, or:"},
          {"scale", ITEM_QUANTITY, ITEM_OPTIONAL, AT(scale), false, "value below which lie 63.2 % (1 - 1/e)"},
          {"modulus", ITEM_NUMBER, ITEM_REQUIRED, AT(modulus), true, "shape: the larger, the less scatter"}},
         "scatter with P(value <= s) = 1 - exp(-(s/scale)^modulus)"},
    [FIELD_NORMAL] = {"normal",
                      true,
                      {{"mean", ITEM_QUANTITY, ITEM_REQUIRED, AT(mean), false, "mean"},
                       {"deviation", ITEM_QUANTITY, ITEM_REQUIRED, AT(deviation), false,
                        "standard deviation"}},
                      "scatter with the normal distribution"},
    [FIELD_LOG_NORMAL] = {"log_normal",
                          true,
                          {{"mean", ITEM_QUANTITY, ITEM_REQUIRED, AT(mean), false,
                            "mean of the values themselves, above 0"},
                           {"deviation", ITEM_QUANTITY, ITEM_REQUIRED, AT(deviation), false,
                            "standard deviation of the values themselves"}},
                          "scatter whose logarithm is normal"},
    [FIELD_UNIFORM] = {"uniform",
                       true,
                       {{"from", ITEM_QUANTITY, ITEM_REQUIRED, AT(from), false, "smallest value"},
                        {"to", ITEM_QUANTITY, ITEM_REQUIRED, AT(to), false, "largest value"}},
                       "scatter with every value between two ends equally likely"},
};

const FieldItem SCENE_FIELD_SCATTER[] = {
    {"seed", ITEM_SEED, ITEM_REQUIRED, AT(seed), false,
     "whole number of at most 15 digits; the same seed gives the same values"},
    {"correlation", ITEM_NUMBER, ITEM_OPTIONAL, AT(correlation), false,
     "length L: the normal scores of two elements at distance r have correlation exp(-r^2/(2 L^2)), on every "
     "mesh the same field; default 0: every element for itself"},
    {.key = NULL}};

/* ---- Reading ---- */

typedef struct {
  SceneField *field;
  const char *key; /* of the parameter, or of the mapping inside it, with dots */
  Error *error;
} FieldReading;

static const char *expectation(const FieldItem *item) {
  switch (item->type) {
  case ITEM_NUMBER:
    return item->positive ? "a number above 0" : "a number of at least 0";
  case ITEM_QUANTITY:
    return "a number or a quantity";
  case ITEM_POINT:
    return "`P` or a list of three numbers";
  case ITEM_FILE:
    return "the path of a file";
  case ITEM_HASH:
    return "16 hexadecimal digits";
  case ITEM_SEED:
    return "a whole number of at most 15 digits";
  }
  return "nothing";
}

static Status unexpected(const FieldReading *reading, const FieldItem *item, const YamlNode *node) {
  return place_error(&node->place, reading->error, "expected %s for `%s.%s`, found %s", expectation(item),
                     reading->key, item->key, yaml_tree_found(node).text);
}

static bool read_plain_number(const YamlNode *node, double *value) {
  Quantity quantity;
  Error why;
  if (node->kind != YAML_TREE_TEXT || units_parse(node->text, &quantity, &why) != STATUS_OK) return false;
  *value = quantity.value;
  return !quantity.has_unit;
}

static Status read_quantity(const FieldReading *reading, const FieldItem *item, const YamlNode *node,
                            Quantity *value) {
  Error why;
  if (node->kind != YAML_TREE_TEXT || !*node->text) return unexpected(reading, item, node);
  if (units_parse(node->text, value, &why) == STATUS_OK) return STATUS_OK;
  return place_error(&node->place, reading->error, "%s for `%s.%s`", why.text, reading->key, item->key);
}

static bool read_point(const YamlNode *node, SceneField *field) {
  field->around_P = node->kind == YAML_TREE_TEXT && strcmp(node->text, "P") == 0;
  if (field->around_P) return true;
  if (node->kind != YAML_TREE_LIST || node->count != 3) return false;
  for (int c = 0; c < 3; c++)
    if (!read_plain_number(node->items[c], &field->center[c])) return false;
  return true;
}

static bool read_hash(const YamlNode *node, SceneField *field) {
  static const char DIGITS[] = "0123456789abcdefABCDEF";
  if (node->kind != YAML_TREE_TEXT || strlen(node->text) != 16 || node->text[strspn(node->text, DIGITS)])
    return false;
  field->hash = strtoull(node->text, NULL, 16);
  return field->has_hash = true;
}

static bool read_seed(const YamlNode *node, long long *seed) {
  if (node->kind != YAML_TREE_TEXT) return false;
  const size_t length = strlen(node->text);
  if (length == 0 || length > 15 || node->text[strspn(node->text, "0123456789")]) return false;
  *seed = strtoll(node->text, NULL, 10);
  return true;
}

static Status read_file(const FieldReading *reading, const FieldItem *item, const YamlNode *node) {
  if (node->kind != YAML_TREE_TEXT || !*node->text) return unexpected(reading, item, node);
  reading->field->file = text_copy(node->text, reading->error);
  return reading->field->file ? STATUS_OK : reading->error->code;
}

static Status read_item(const FieldReading *reading, const FieldItem *item, const YamlNode *node) {
  void *value = (char *)reading->field + item->offset;
  double number = 0;
  bool is_good = false;
  switch (item->type) {
  case ITEM_QUANTITY:
    return read_quantity(reading, item, node, value);
  case ITEM_FILE:
    return read_file(reading, item, node);
  case ITEM_NUMBER:
    is_good = read_plain_number(node, &number) && (item->positive ? number > 0 : number >= 0);
    *(double *)value = number;
    break;
  case ITEM_POINT:
    is_good = read_point(node, reading->field);
    break;
  case ITEM_HASH:
    is_good = read_hash(node, reading->field);
    break;
  case ITEM_SEED:
    is_good = read_seed(node, value);
    break;
  }
  return is_good ? STATUS_OK : unexpected(reading, item, node);
}

static const FieldItem *find_item(const FieldItem *items, const char *key) {
  while (items->key && strcmp(items->key, key) != 0) items++;
  return items->key ? items : NULL;
}

static Status unknown(const FieldReading *reading, const YamlNode *node, const char *const *names, size_t n) {
  const char *nearest = text_nearest(node->key, names, n);
  return place_error(&node->key_place, reading->error, "expected a known key, found `%s.%s`%s%s%s",
                     reading->key, node->key, nearest ? " (did you mean `" : "", nearest ? nearest : "",
                     nearest ? "`?)" : "");
}

static Status require(const FieldReading *reading, const YamlNode *node, const FieldItem *items) {
  for (; items->key; items++) {
    if (items->need == ITEM_OPTIONAL || yaml_tree_find(node, items->key)) continue;
    return place_error(&node->place, reading->error, "expected the key `%s.%s` (%s), found none",
                       reading->key, items->key, expectation(items));
  }
  return STATUS_OK;
}

/* A mapping with these items; `skip` (may be NULL) is a key that is read elsewhere. */
static Status read_items(const FieldReading *reading, const YamlNode *node, const FieldItem *items,
                         const char *skip) {
  const char *names[MAX_ITEMS + 1];
  size_t n = 0;
  for (; items[n].key; n++) names[n] = items[n].key;
  for (size_t i = 0; i < node->count; i++) {
    const YamlNode *child = node->items[i];
    if (skip && strcmp(child->key, skip) == 0) continue;
    const FieldItem *item = find_item(items, child->key);
    Status status = item ? read_item(reading, item, child) : unknown(reading, child, names, n);
    if (status != STATUS_OK) return status;
  }
  return require(reading, node, items);
}

/* The kind by its opening key. */
static Status read_kind(const FieldReading *reading, const YamlNode *node) {
  const char *names[FIELD_KINDS];
  for (int kind = 0; kind < FIELD_KINDS; kind++) names[kind] = SCENE_FIELD_FORMS[kind].opening;
  for (int kind = 0; kind < FIELD_KINDS; kind++) {
    if (!yaml_tree_find(node, names[kind])) continue;
    reading->field->kind = (FieldKind)kind;
    return STATUS_OK;
  }
  for (size_t i = 0; i < node->count; i++)
    if (text_nearest(node->items[i]->key, names, FIELD_KINDS))
      return unknown(reading, node->items[i], names, FIELD_KINDS);
  return place_error(&node->place, reading->error,
                     "expected one of `around`, `file`, `weibull`, `normal`, `log_normal` and `uniform` in "
                     "`%s`, found none",
                     reading->key);
}

static Status read_scatter(const FieldReading *reading, const YamlNode *node, const FieldForm *form) {
  Status status;
  Text key = {0};
  const YamlNode *inner = yaml_tree_find(node, form->opening);
  TRY(read_items(reading, node, SCENE_FIELD_SCATTER, form->opening));
  TRY(text_append(&key, reading->error, "%s.%s", reading->key, form->opening));
  if (inner->kind != YAML_TREE_MAPPING)
    TRY(place_error(&inner->place, reading->error, "expected a mapping for `%s`, found %s", key.data,
                    yaml_tree_found(inner).text));
  TRY(read_items(&(FieldReading){reading->field, key.data, reading->error}, inner, form->items, NULL));
  if (reading->field->kind == FIELD_WEIBULL &&
      isnan(reading->field->mean.value) == isnan(reading->field->scale.value))
    TRY(place_error(&inner->place, reading->error,
                    "expected one of the keys `%s.mean` and `%s.scale`, found %s", key.data, key.data,
                    isnan(reading->field->mean.value) ? "none" : "both"));
cleanup:
  text_free(&key);
  return status;
}

Status scene_field_read(SceneField **field, const YamlNode *node, const char *key, Error *error) {
  Status status = ARRAY_NEW(field, 1, error);
  if (status != STATUS_OK) return status;
  const Quantity absent = {.value = NAN};
  **field = (SceneField){.place = node->place,
                         .times = {.value = 1},
                         .mean = absent,
                         .scale = absent,
                         .deviation = absent,
                         .from = absent,
                         .to = absent};
  const FieldReading reading = {*field, key, error};
  TRY(read_kind(&reading, node));
  const FieldForm *form = &SCENE_FIELD_FORMS[(*field)->kind];
  TRY(form->is_scatter ? read_scatter(&reading, node, form) : read_items(&reading, node, form->items, NULL));
cleanup:
  return status;
}

void scene_field_free(SceneField *field) {
  if (field) array_free(field->file);
  array_free(field);
}

/* ---- Printing ---- */

static bool is_given(const SceneField *field, const FieldItem *item) {
  const void *value = (const char *)field + item->offset;
  if (item->type == ITEM_HASH) return field->has_hash;
  return item->type != ITEM_QUANTITY || !isnan(((const Quantity *)value)->value);
}

static Status print_point(const SceneField *field, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  if (field->around_P) return text_append(yaml, error, "P");
  for (int c = 0; c < 3; c++) {
    TRY(text_append(yaml, error, c ? ", " : "["));
    TRY(units_print_number(yaml, field->center[c], error));
  }
  TRY(text_append(yaml, error, "]"));
cleanup:
  return status;
}

static Status print_item(const SceneField *field, const FieldItem *item, Text *yaml, Error *error) {
  const void *value = (const char *)field + item->offset;
  switch (item->type) {
  case ITEM_NUMBER:
    return units_print_number(yaml, *(const double *)value, error);
  case ITEM_QUANTITY:
    return units_print(yaml, value, error);
  case ITEM_POINT:
    return print_point(field, yaml, error);
  case ITEM_FILE:
    return yaml_print_text(field->file, yaml, error);
  case ITEM_HASH:
    return text_append(yaml, error, "\"%016" PRIx64 "\"", field->hash);
  case ITEM_SEED:
    return text_append(yaml, error, "%lld", field->seed);
  }
  return STATUS_OK;
}

static Status print_items(const SceneField *field, const FieldItem *items, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  const char *separator = "";
  for (; items->key; items++) {
    if (!is_given(field, items)) continue;
    TRY(text_append(yaml, error, "%s%s: ", separator, items->key));
    TRY(print_item(field, items, yaml, error));
    separator = ", ";
  }
cleanup:
  return status;
}

Status scene_field_print(const SceneField *field, Text *yaml, Error *error) {
  Status status;
  const FieldForm *form = &SCENE_FIELD_FORMS[field->kind];
  TRY(text_append(yaml, error, "{"));
  if (form->is_scatter) TRY(text_append(yaml, error, "%s: {", form->opening));
  TRY(print_items(field, form->items, yaml, error));
  if (form->is_scatter) {
    TRY(text_append(yaml, error, "}, "));
    TRY(print_items(field, SCENE_FIELD_SCATTER, yaml, error));
  }
  TRY(text_append(yaml, error, "}"));
cleanup:
  return status;
}

/* ---- The manual ---- */

static Status print_manual_items(const char *kind, const FieldItem *items, Text *markdown, Error *error) {
  Status status = STATUS_OK;
  for (; items->key; items++) {
    TRY(text_append(markdown, error, "| %s | `%s` | %s | %s; %s |\n", kind, items->key, expectation(items),
                    items->need == ITEM_REQUIRED ? "required" : "optional", items->meaning));
    kind = "";
  }
cleanup:
  return status;
}

Status scene_field_print_manual(Text *markdown, Error *error) {
  Status status;
  Text kind = {0};
  TRY(text_append(markdown, error,
                  "\n## Parameters that vary over the membrane\n\n"
                  "In place of a number, a parameter of a law may be a mapping of one of these kinds:\n\n"
                  "```yaml\n"
                  "Y_C: {around: P, radius: 0.3, inside: 1.0, outside: 2.0}\n"
                  "Y_C: {file: strengths.txt}\n"
                  "Y_C: {weibull: {mean: 2.0, modulus: 8}, seed: 7, correlation: 0.2}\n"
                  "```\n\n"
                  "Each element gets one value, which must lie in the range of the parameter.\n"
                  "Symmetries of mesh and flow are used as far as the values have them; the log says which "
                  "are left.\nSnapshots hold the values as data of the cells.\n\n"
                  "| kind | key | value | meaning |\n|---|---|---|---|\n"));
  for (int k = 0; k < FIELD_KINDS; k++) {
    const FieldForm *form = &SCENE_FIELD_FORMS[k];
    text_free(&kind);
    TRY(text_append(&kind, error, form->is_scatter ? "`%s: {...}`, %s" : "`%s`, %s", form->opening,
                    form->meaning));
    TRY(print_manual_items(kind.data, form->items, markdown, error));
  }
  TRY(print_manual_items("beside any scatter", SCENE_FIELD_SCATTER, markdown, error));
cleanup:
  text_free(&kind);
  return status;
}
