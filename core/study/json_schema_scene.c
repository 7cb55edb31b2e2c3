/* Each row of the schema becomes a property, each group of keys an object. */
#include "study/json_schema_scene.h"

#include "config/scene_field_table.h"
#include "config/schema.h"
#include "observe/json.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

const char JSON_SCHEMA_DIALECT[] = "https://json-schema.org/draft/2020-12/schema";

static const char NUMBERS_3[] =
    "{\"type\": \"array\", \"items\": {\"type\": \"number\"}, \"minItems\": 3, \"maxItems\": 3}";
static const char PARAMETERS[] = "{\"$ref\": \"#/$defs/parameters\"}";

/* ---- One value of a scene ---- */

static void range(Json *json, const SchemaRow *row) {
  if (isfinite(row->low)) json_number(json, row->above ? "exclusiveMinimum" : "minimum", row->low);
  if (isfinite(row->high)) json_number(json, "maximum", row->high);
}

static void choices(Json *json, const char *const *words) {
  json_open_array(json, "enum");
  for (; *words; words++) json_string(json, NULL, *words);
  json_close(json);
}

/* `auto` or a number. */
static void automatic(Json *json, const SchemaRow *row) {
  json_open_array(json, "anyOf");
  json_raw(json, NULL, "{\"const\": \"auto\"}");
  json_open_object(json, NULL);
  json_string(json, "type", "number");
  range(json, row);
  json_close(json);
  json_close(json);
}

static void value_type(Json *json, const SchemaRow *row) {
  switch (row->type) {
  case TYPE_TEXT: /* what a YAML parser takes for a number or a truth value may be text */
    json_raw(json, "type", "[\"string\", \"number\", \"boolean\"]");
    break;
  case TYPE_INTEGER:
  case TYPE_NUMBER:
    json_string(json, "type", row->type == TYPE_INTEGER ? "integer" : "number");
    range(json, row);
    break;
  case TYPE_AUTOMATIC:
    automatic(json, row);
    break;
  case TYPE_BOOLEAN:
    json_string(json, "type", "boolean");
    break;
  case TYPE_CHOICE:
    choices(json, row->choices);
    break;
  case TYPE_QUANTITY:
  case TYPE_LAW:
    json_string(json, "type", "string");
    break;
  case TYPE_VECTOR:
    json_raw(json, "allOf", "[{\"$ref\": \"#/$defs/vector\"}]");
    break;
  case TYPE_MATRIX:
    json_raw(json, "items", "{\"$ref\": \"#/$defs/vector\"}, \"minItems\": 3, \"maxItems\": 3");
    break;
  case TYPE_PATH:
    json_raw(json, "items",
             "{\"type\": \"array\", \"items\": {\"type\": \"number\"}, \"minItems\": 2, \"maxItems\": 2}");
    break;
  case TYPE_PARAMETERS:
    json_raw(json, "allOf", "[{\"$ref\": \"#/$defs/parameters\"}]");
    break;
  case TYPE_CRITERIA:
    json_raw(json, "items", "{\"$ref\": \"#/$defs/criterion\"}");
    break;
  case TYPE_GROUP:
    break; /* its keys are rows of their own */
  }
  const bool is_list = row->type == TYPE_MATRIX || row->type == TYPE_PATH || row->type == TYPE_CRITERIA;
  if (is_list) json_string(json, "type", "array");
}

static Status description(Json *json, const SchemaRow *row, Error *error) {
  Status status;
  Text words = {0};
  TRY(text_append(&words, error, "%s", row->meaning));
  if (row->example) TRY(text_append(&words, error, " A quantity with a unit, such as `%s`.", row->example));
  if (row->where) TRY(text_append(&words, error, " Only where %s.", row->where->words));
  for (int k = 0; schema_has_preset(row) && SCHEMA_ACCURACY[k]; k++)
    TRY(text_append(&words, error, "%s %s with `accuracy: %s`", k ? "," : " Default:", row->preset[k],
                    SCHEMA_ACCURACY[k]));
  json_string(json, "description", words.data);
cleanup:
  text_free(&words);
  return status;
}

static void fallback(Json *json, const SchemaRow *row) {
  const bool is_word = row->type == TYPE_TEXT || row->type == TYPE_CHOICE || row->type == TYPE_AUTOMATIC;
  if (row->fallback) (is_word ? json_string : json_raw)(json, "default", row->fallback);
}

/* ---- Mappings of a scene ---- */

enum { LONGEST = 128 };

/* Whether the key of row i lies below the mapping `prefix` ("flow." or ""), with a name that no earlier row
 * has: its length, else 0. */
static size_t new_name(size_t i, const char *prefix) {
  const size_t length = strlen(prefix);
  if (strncmp(SCHEMA[i].key, prefix, length) != 0) return 0;
  const size_t name = strcspn(SCHEMA[i].key + length, ".");
  for (size_t k = 0; k < i; k++) {
    const char end =
        strncmp(SCHEMA[k].key, SCHEMA[i].key, length + name) == 0 ? SCHEMA[k].key[length + name] : 'x';
    if (end == '\0' || end == '.') return 0;
  }
  return name;
}

/* Whether the key must be there wherever the mapping is: a condition beyond that is not told here. */
static bool is_required(const SchemaRow *row, const char *prefix) {
  char parent[LONGEST];
  if (!row || row->type == TYPE_GROUP || row->fallback || schema_has_preset(row)) return false;
  if (!row->where) return strchr(row->key, '.') == NULL || *prefix;
  snprintf(parent, sizeof parent, "%.*s", *prefix ? (int)strlen(prefix) - 1 : 0, prefix);
  const SchemaRow *group = schema_find(parent);
  return group && group->type == TYPE_GROUP;
}

/* What must be in the mapping; a mapping in it must, when something in that must. */
static bool mapping_is_required(const char *prefix);

static bool name_is_required(size_t i, const char *prefix, size_t name) {
  char key[LONGEST];
  snprintf(key, sizeof key, "%.*s", (int)(strlen(prefix) + name), SCHEMA[i].key);
  const SchemaRow *row = schema_find(key);
  if (row) return is_required(row, prefix);
  strncat(key, ".", sizeof key - strlen(key) - 1);
  return mapping_is_required(key);
}

static bool mapping_is_required(const char *prefix) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    const size_t name = new_name(i, prefix);
    if (name && name_is_required(i, prefix, name)) return true;
  }
  return false;
}

static void required(Json *json, const char *prefix) {
  char word[LONGEST];
  if (!mapping_is_required(prefix)) return;
  json_open_array(json, "required");
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    const size_t name = new_name(i, prefix);
    if (!name || !name_is_required(i, prefix, name)) continue;
    snprintf(word, sizeof word, "%.*s", (int)name, SCHEMA[i].key + strlen(prefix));
    json_string(json, NULL, word);
  }
  json_close(json);
}

static Status mapping(Json *json, const char *prefix, bool is_whole, Error *error);

/* The value behind the name of row i in the mapping. */
static Status property(Json *json, size_t i, const char *prefix, size_t name, bool is_whole, Error *error) {
  Status status = STATUS_OK;
  char key[LONGEST];
  const size_t length = strlen(prefix);
  snprintf(key, sizeof key, "%.*s", (int)(length + name), SCHEMA[i].key);
  const SchemaRow *row = schema_find(key);
  json_open_object(json, key + length);
  if (row) {
    TRY(description(json, row, error));
    value_type(json, row);
    fallback(json, row);
  }
  if (schema_is_mapping(key)) {
    strncat(key, ".", sizeof key - strlen(key) - 1);
    TRY(mapping(json, key, is_whole, error));
  }
  json_close(json);
cleanup:
  return status;
}

/* The keys below `prefix`; `is_whole`: with those that must be there. */
static Status mapping(Json *json, const char *prefix, bool is_whole, Error *error) {
  Status status = STATUS_OK;
  json_string(json, "type", "object");
  json_boolean(json, "additionalProperties", false);
  if (is_whole) required(json, prefix);
  json_open_object(json, "properties");
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    const size_t name = new_name(i, prefix);
    if (name) TRY(property(json, i, prefix, name, is_whole, error));
  }
  json_close(json);
cleanup:
  return status;
}

Status json_schema_scene_keys(Json *json, bool is_whole, Error *error) {
  return mapping(json, "", is_whole, error);
}

/* ---- Parameters of laws ---- */

static void field_value(Json *json, const FieldItem *item) {
  switch (item->type) {
  case ITEM_NUMBER:
    json_string(json, "type", "number");
    json_number(json, item->positive ? "exclusiveMinimum" : "minimum", 0);
    break;
  case ITEM_QUANTITY:
    json_raw(json, "type", "[\"number\", \"string\"]");
    break;
  case ITEM_POINT:
    json_raw(json, "anyOf", "[{\"const\": \"P\"}, {\"$ref\": \"#/$defs/vector\"}]");
    break;
  case ITEM_FILE:
    json_string(json, "type", "string");
    break;
  case ITEM_HASH: /* a YAML parser may take the digits for a number */
    json_raw(json, "type", "[\"string\", \"number\"]");
    break;
  case ITEM_SEED:
    json_string(json, "type", "integer");
    json_number(json, "minimum", 0);
    break;
  }
}

static void field_items(Json *json, const FieldItem *items) {
  for (; items->key; items++) {
    json_open_object(json, items->key);
    json_string(json, "description", items->meaning);
    field_value(json, items);
    json_close(json);
  }
}

static void field_required(Json *json, const FieldItem *items) {
  for (; items->key; items++)
    if (items->need == ITEM_REQUIRED) json_string(json, NULL, items->key);
}

/* A mapping of `items` and, where it is scatter, of those beside it. */
static void field_form(Json *json, const FieldForm *form) {
  json_open_object(json, NULL);
  json_string(json, "description", form->meaning);
  json_string(json, "type", "object");
  json_boolean(json, "additionalProperties", false);
  json_open_array(json, "required");
  if (form->is_scatter) json_string(json, NULL, form->opening);
  field_required(json, form->is_scatter ? SCENE_FIELD_SCATTER : form->items);
  json_close(json);
  json_open_object(json, "properties");
  if (form->is_scatter) {
    json_open_object(json, form->opening);
    json_string(json, "type", "object");
    json_boolean(json, "additionalProperties", false);
    json_open_array(json, "required");
    field_required(json, form->items);
    json_close(json);
    json_open_object(json, "properties");
    field_items(json, form->items);
    json_close(json);
    json_close(json);
  }
  field_items(json, form->is_scatter ? SCENE_FIELD_SCATTER : form->items);
  json_close(json);
  json_close(json);
}

void json_schema_definitions(Json *json) {
  json_open_object(json, "$defs");
  json_raw(json, "vector", NUMBERS_3);
  json_open_object(json, "parameters");
  json_string(json, "type", "object");
  json_open_object(json, "additionalProperties");
  json_open_array(json, "anyOf");
  json_raw(json, NULL,
           "{\"description\": \"a number, or a quantity with a unit\", \"type\": [\"number\", \"string\"]}");
  for (int k = 0; k < FIELD_KINDS; k++) field_form(json, &SCENE_FIELD_FORMS[k]);
  json_close(json);
  json_close(json);
  json_close(json);
  json_open_object(json, "criterion");
  json_string(json, "type", "object");
  json_boolean(json, "additionalProperties", false);
  json_raw(json, "required", "[\"law\"]");
  json_open_object(json, "properties");
  json_raw(json, "name", "{\"type\": [\"string\", \"number\", \"boolean\"]}");
  json_raw(json, "law", "{\"type\": \"string\"}");
  json_raw(json, "parameters", PARAMETERS);
  json_close(json);
  json_close(json);
  json_close(json);
}

Status json_schema_scene(Text *text, Error *error) {
  Status status;
  Json json;
  json_begin(&json, text, error);
  json_open_object(&json, NULL);
  json_string(&json, "$schema", JSON_SCHEMA_DIALECT);
  json_string(&json, "title", "A scene of Capsella");
  TRY(json_schema_scene_keys(&json, true, error));
  json_schema_definitions(&json);
  json_close(&json);
  TRY(json_end(&json));
cleanup:
  return status;
}
