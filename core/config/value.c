/* Typing is by the schema, never by spelling: `no` is text where text is expected and false where a boolean
 * is, and quotes change nothing. */
#include "config/value.h"

#include "base/array.h"
#include "config/yaml_print.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* One value being read: what is expected, where it goes, and what to say when it is something else. */
typedef struct {
  const SchemaRow *row;
  Scene *scene;
  Error *error;
} Reading;

static void *member(const SchemaRow *row, Scene *scene) {
  return (char *)scene + row->offset;
}
static const void *const_member(const SchemaRow *row, const Scene *scene) {
  return (const char *)scene + row->offset;
}
static void *companion(const SchemaRow *row, Scene *scene) {
  return (char *)scene + row->companion;
}

/* "expected ... for `key`, found ...", with `rest` behind it. */
static Status unexpected(const Reading *reading, const YamlNode *node, const char *rest) {
  Text expected = {0};
  Status status = schema_expected(reading->row, &expected, reading->error);
  if (status == STATUS_OK)
    status = place_error(&node->place, reading->error, "expected %s for `%s`, found %s%s", expected.data,
                         reading->row->key, yaml_tree_found(node).text, rest);
  text_free(&expected);
  return status;
}

static bool in_range(const SchemaRow *row, double value) {
  return value <= row->high && (row->above ? value > row->low : value >= row->low);
}

/* Text with something in it. */
static Status read_text(const Reading *reading, const YamlNode *node, char **text) {
  if (node->kind != YAML_TREE_TEXT || !*node->text) return unexpected(reading, node, "");
  *text = text_copy(node->text, reading->error);
  return *text ? STATUS_OK : reading->error->code;
}

static Status read_integer(const Reading *reading, const YamlNode *node, int *value) {
  if (node->kind != YAML_TREE_TEXT) return unexpected(reading, node, "");
  const char *digits = node->text + strspn(node->text, "+-");
  if (!*digits || digits[strspn(digits, "0123456789")]) return unexpected(reading, node, "");
  char *end;
  errno = 0;
  long number = strtol(node->text, &end, 10);
  if (*end || errno || !in_range(reading->row, (double)number)) return unexpected(reading, node, "");
  *value = (int)number; /* every integer of the schema has a range within int */
  return STATUS_OK;
}

static Status read_number(const Reading *reading, const YamlNode *node, double *value) {
  Quantity quantity;
  Error why;
  if (node->kind != YAML_TREE_TEXT || units_parse(node->text, &quantity, &why) != STATUS_OK)
    return unexpected(reading, node, "");
  if (quantity.has_unit) return unexpected(reading, node, ", which has a unit");
  if (!in_range(reading->row, quantity.value)) return unexpected(reading, node, "");
  *value = quantity.value;
  return STATUS_OK;
}

static Status read_automatic(const Reading *reading, const YamlNode *node) {
  bool *automatic = companion(reading->row, reading->scene);
  *automatic = node->kind == YAML_TREE_TEXT && strcmp(node->text, "auto") == 0;
  return *automatic ? STATUS_OK : read_number(reading, node, member(reading->row, reading->scene));
}

static Status read_boolean(const Reading *reading, const YamlNode *node, bool *value) {
  static const char *const WORDS[2][3] = {{"false", "no", "off"}, {"true", "yes", "on"}};
  if (node->kind != YAML_TREE_TEXT) return unexpected(reading, node, "");
  for (int meaning = 0; meaning < 2; meaning++)
    for (int i = 0; i < 3; i++)
      if (strcasecmp(node->text, WORDS[meaning][i]) == 0) {
        *value = meaning;
        return STATUS_OK;
      }
  return unexpected(reading, node, "");
}

_Static_assert(sizeof(FlowKind) == sizeof(int), "a choice is stored as an int");

static Status read_choice(const Reading *reading, const YamlNode *node, int *value) {
  const SchemaRow *row = reading->row;
  int count = 0;
  if (node->kind != YAML_TREE_TEXT) return unexpected(reading, node, "");
  for (; row->choices[count]; count++)
    if (strcmp(row->choices[count], node->text) == 0) {
      *value = count;
      if (row->companion) *(SourcePlace *)companion(row, reading->scene) = node->place;
      return STATUS_OK;
    }
  const char *nearest = text_nearest(node->text, row->choices, (size_t)count);
  if (!nearest) return unexpected(reading, node, "");
  Text rest = {0};
  Status status = text_append(&rest, reading->error, " (did you mean `%s`?)", nearest);
  if (status == STATUS_OK) status = unexpected(reading, node, rest.data);
  text_free(&rest);
  return status;
}

static Status read_quantity(const Reading *reading, const YamlNode *node, Quantity *value) {
  const SchemaRow *row = reading->row;
  Error why;
  if (node->kind != YAML_TREE_TEXT || !*node->text) return unexpected(reading, node, "");
  if (units_parse(node->text, value, &why) != STATUS_OK)
    return place_error(&node->place, reading->error, "%s for `%s`", why.text, row->key);
  if (!value->has_unit) return unexpected(reading, node, ", which has no unit");
  if (!units_agree(value->dim, row->dim)) return unexpected(reading, node, ", which has another dimension");
  return in_range(row, value->value) ? STATUS_OK : unexpected(reading, node, "");
}

static Status read_numbers(const Reading *reading, const YamlNode *node, size_t count, double *values) {
  if (node->kind != YAML_TREE_LIST || node->count != count) return unexpected(reading, node, "");
  Status status = STATUS_OK;
  for (size_t i = 0; i < count && status == STATUS_OK; i++)
    status = read_number(reading, node->items[i], &values[i]);
  return status;
}

static Status read_matrix(const Reading *reading, const YamlNode *node, double (*rows)[3]) {
  if (node->kind != YAML_TREE_LIST || node->count != 3) return unexpected(reading, node, "");
  Status status = STATUS_OK;
  for (size_t i = 0; i < 3 && status == STATUS_OK; i++)
    status = read_numbers(reading, node->items[i], 3, rows[i]);
  return status;
}

static Status read_point(const Reading *reading, const YamlNode *node, double (*points)[2], size_t i) {
  Status status = read_numbers(reading, node, 2, points[i]);
  if (status != STATUS_OK) return status;
  double t = points[i][0];
  if (i == 0 && t != 0)
    return place_error(&node->place, reading->error, "expected a path from t = 0 on, found t = %g", t);
  if (i > 0 && t <= points[i - 1][0])
    return place_error(&node->place, reading->error,
                       "expected times that rise along the path, found %g behind %g", t, points[i - 1][0]);
  return STATUS_OK;
}

static Status read_path(const Reading *reading, const YamlNode *node, double (**points)[2]) {
  if (node->kind != YAML_TREE_LIST || node->count < 1) return unexpected(reading, node, "");
  Status status = STATUS_OK;
  TRY(ARRAY_NEW(points, node->count, reading->error));
  for (size_t i = 0; i < node->count; i++) TRY(read_point(reading, node->items[i], *points, i));
  *(size_t *)companion(reading->row, reading->scene) = node->count;
cleanup:
  return status;
}

static Status read_law(const Reading *reading, const YamlNode *node, SceneLaw *law) {
  law->place = node->place;
  return read_text(reading, node, &law->law);
}

static Status read_field(const Reading *reading, const YamlNode *node, SceneParameter *parameter) {
  Text key = {0};
  Status status = text_append(&key, reading->error, "%s.%s", reading->row->key, node->key);
  if (status == STATUS_OK) status = scene_field_read(&parameter->field, node, key.data, reading->error);
  text_free(&key);
  return status;
}

static Status read_parameter(const Reading *reading, const YamlNode *node, SceneParameter *parameter) {
  static const char LETTERS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789";
  enum { LONGEST = 60 };
  Error why;
  if (!*node->key || node->key[strspn(node->key, LETTERS)] || strlen(node->key) > LONGEST)
    return place_error(
        &node->key_place, reading->error,
        "expected a parameter name of at most %d letters, digits and `_` in `%s`, found `%.60s`", LONGEST,
        reading->row->key, node->key);
  parameter->place = node->place;
  parameter->name = text_copy(node->key, reading->error);
  if (!parameter->name) return reading->error->code;
  if (node->kind == YAML_TREE_MAPPING) return read_field(reading, node, parameter);
  if (node->kind != YAML_TREE_TEXT || !*node->text)
    return place_error(&node->place, reading->error,
                       "expected a number, a quantity or a field for `%s.%s`, found %s", reading->row->key,
                       node->key, yaml_tree_found(node).text);
  if (units_parse(node->text, &parameter->value, &why) == STATUS_OK) return STATUS_OK;
  return place_error(&node->place, reading->error, "%s for `%s.%s`", why.text, reading->row->key, node->key);
}

static Status read_parameters(const Reading *reading, const YamlNode *node, SceneLaw *law) {
  if (node->kind != YAML_TREE_MAPPING) return unexpected(reading, node, "");
  Status status = STATUS_OK;
  TRY(ARRAY_NEW(&law->parameters, node->count, reading->error));
  law->n_parameters = node->count;
  for (size_t i = 0; i < node->count; i++) TRY(read_parameter(reading, node->items[i], &law->parameters[i]));
cleanup:
  return status;
}

/* The name of a criterion goes into tables: letters, digits and a little more. */
static Status name_criterion(const Reading *reading, const YamlNode *node, SceneCriterion *criterion) {
  static const char LETTERS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789.-";
  enum { LONGEST = 60 };
  const YamlNode *given = yaml_tree_find(node, "name");
  const char *name = given ? given->text : criterion->law.law;
  if (!name || !*name || name[strspn(name, LETTERS)] || strlen(name) > LONGEST)
    return place_error(given ? &given->place : &node->place, reading->error,
                       "expected a `name` of at most %d letters, digits, `_`, `.` and `-` in `%s`, found %s",
                       LONGEST, reading->row->key, given ? yaml_tree_found(given).text : "none");
  criterion->name = text_copy(name, reading->error);
  return criterion->name ? STATUS_OK : reading->error->code;
}

static Status read_criterion(const Reading *reading, const YamlNode *node, SceneCriterion *criterion) {
  Status status = STATUS_OK;
  if (node->kind != YAML_TREE_MAPPING) return unexpected(reading, node, "");
  for (size_t i = 0; i < node->count; i++) {
    const YamlNode *entry = node->items[i];
    if (strcmp(entry->key, "law") == 0)
      TRY(read_law(reading, entry, &criterion->law));
    else if (strcmp(entry->key, "parameters") == 0)
      TRY(read_parameters(reading, entry, &criterion->law));
    else if (strcmp(entry->key, "name") != 0)
      return place_error(&entry->key_place, reading->error,
                         "expected `name`, `law` or `parameters` in `%s`, found `%.60s`", reading->row->key,
                         entry->key);
  }
  if (!criterion->law.law)
    return place_error(&node->place, reading->error, "expected a `law` in `%s`, found none",
                       reading->row->key);
  TRY(name_criterion(reading, node, criterion));
cleanup:
  return status;
}

static Status read_criteria(const Reading *reading, const YamlNode *node, SceneCriterion **criteria) {
  Status status = STATUS_OK;
  size_t *count = companion(reading->row, reading->scene);
  if (node->kind != YAML_TREE_LIST) return unexpected(reading, node, "");
  TRY(ARRAY_NEW(criteria, node->count, reading->error));
  *count = node->count;
  for (size_t i = 0; i < node->count; i++) {
    TRY(read_criterion(reading, node->items[i], &(*criteria)[i]));
    for (size_t k = 0; k < i; k++)
      if (strcmp((*criteria)[k].name, (*criteria)[i].name) == 0)
        TRY(place_error(&node->items[i]->place, reading->error,
                        "expected criteria of different names in `%s`, found `%s` twice (give a `name`)",
                        reading->row->key, (*criteria)[i].name));
  }
cleanup:
  return status;
}

Status value_read(const SchemaRow *row, const YamlNode *node, Scene *scene, Error *error) {
  Reading reading = {row, scene, error};
  void *value = member(row, scene);
  switch (row->type) {
  case TYPE_TEXT:
    return read_text(&reading, node, value);
  case TYPE_INTEGER:
    return read_integer(&reading, node, value);
  case TYPE_NUMBER:
    return read_number(&reading, node, value);
  case TYPE_AUTOMATIC:
    return read_automatic(&reading, node);
  case TYPE_BOOLEAN:
    return read_boolean(&reading, node, value);
  case TYPE_CHOICE:
    return read_choice(&reading, node, value);
  case TYPE_QUANTITY:
    return read_quantity(&reading, node, value);
  case TYPE_VECTOR:
    return read_numbers(&reading, node, 3, value);
  case TYPE_MATRIX:
    return read_matrix(&reading, node, value);
  case TYPE_PATH:
    return read_path(&reading, node, value);
  case TYPE_LAW:
    return read_law(&reading, node, value);
  case TYPE_PARAMETERS:
    return read_parameters(&reading, node, value);
  case TYPE_CRITERIA:
    return read_criteria(&reading, node, value);
  case TYPE_GROUP:
    *(bool *)value = true;
    return STATUS_OK;
  }
  return error_set(error, STATUS_FAILED, "`%s` has no type", row->key);
}

static Status print_numbers(const double *values, size_t count, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < count; i++) {
    TRY(text_append(yaml, error, i ? ", " : "["));
    TRY(units_print_number(yaml, values[i], error));
  }
  TRY(text_append(yaml, error, "]"));
cleanup:
  return status;
}

/* [count] rows of `width` numbers. */
static Status print_rows(const double *values, size_t count, size_t width, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < count; i++) {
    TRY(text_append(yaml, error, i ? ", " : "["));
    TRY(print_numbers(values + width * i, width, yaml, error));
  }
  TRY(text_append(yaml, error, "]"));
cleanup:
  return status;
}

static Status print_parameters(const SceneLaw *law, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  TRY(text_append(yaml, error, "{"));
  for (size_t i = 0; i < law->n_parameters; i++) {
    TRY(text_append(yaml, error, "%s%s: ", i ? ", " : "", law->parameters[i].name));
    const SceneParameter *given = &law->parameters[i];
    TRY(given->field ? scene_field_print(given->field, yaml, error)
                     : units_print(yaml, &given->value, error));
  }
  TRY(text_append(yaml, error, "}"));
cleanup:
  return status;
}

static Status print_criteria(const SceneCriterion *criteria, size_t count, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  TRY(text_append(yaml, error, "["));
  for (size_t i = 0; i < count; i++) {
    TRY(text_append(yaml, error, "%s{name: \"%s\", law: ", i ? ", " : "", criteria[i].name));
    TRY(yaml_print_text(criteria[i].law.law, yaml, error));
    TRY(text_append(yaml, error, ", parameters: "));
    TRY(print_parameters(&criteria[i].law, yaml, error));
    TRY(text_append(yaml, error, "}"));
  }
  TRY(text_append(yaml, error, "]"));
cleanup:
  return status;
}

Status value_print(const SchemaRow *row, const Scene *scene, Text *yaml, Error *error) {
  const void *value = const_member(row, scene);
  switch (row->type) {
  case TYPE_TEXT:
    return yaml_print_text(*(char *const *)value, yaml, error);
  case TYPE_INTEGER:
    return text_append(yaml, error, "%d", *(const int *)value);
  case TYPE_NUMBER:
    return units_print_number(yaml, *(const double *)value, error);
  case TYPE_AUTOMATIC:
    if (*(const bool *)((const char *)scene + row->companion)) return text_append(yaml, error, "auto");
    return units_print_number(yaml, *(const double *)value, error);
  case TYPE_BOOLEAN:
    return text_append(yaml, error, *(const bool *)value ? "true" : "false");
  case TYPE_CHOICE:
    return text_append(yaml, error, "%s", row->choices[*(const int *)value]);
  case TYPE_QUANTITY:
    return units_print(yaml, value, error);
  case TYPE_VECTOR:
    return print_numbers(value, 3, yaml, error);
  case TYPE_MATRIX:
    return print_rows(value, 3, 3, yaml, error);
  case TYPE_PATH: {
    const double *points = *(double *const *)value;
    return print_rows(points, *(const size_t *)((const char *)scene + row->companion), 2, yaml, error);
  }
  case TYPE_LAW:
    return yaml_print_text(((const SceneLaw *)value)->law, yaml, error);
  case TYPE_PARAMETERS:
    return print_parameters(value, yaml, error);
  case TYPE_CRITERIA:
    return print_criteria(*(SceneCriterion *const *)value,
                          *(const size_t *)((const char *)scene + row->companion), yaml, error);
  case TYPE_GROUP:
    return STATUS_OK;
  }
  return error_set(error, STATUS_FAILED, "`%s` has no type", row->key);
}

static void free_law(SceneLaw *law) {
  array_free(law->law);
  law->law = NULL;
}

static void free_parameters(SceneLaw *law) {
  for (size_t i = 0; i < law->n_parameters; i++) {
    array_free(law->parameters[i].name);
    scene_field_free(law->parameters[i].field);
  }
  array_free(law->parameters);
  law->parameters = NULL;
  law->n_parameters = 0;
}

static void free_criteria(SceneCriterion **criteria, size_t *count) {
  for (size_t i = 0; i < *count; i++) {
    array_free((*criteria)[i].name);
    free_law(&(*criteria)[i].law);
    free_parameters(&(*criteria)[i].law);
  }
  array_free(*criteria);
  *criteria = NULL;
  *count = 0;
}

void value_free(const SchemaRow *row, Scene *scene) {
  void *value = member(row, scene);
  switch (row->type) {
  case TYPE_TEXT:
  case TYPE_PATH:
    array_free(*(void **)value);
    *(void **)value = NULL;
    break;
  case TYPE_LAW:
    free_law(value);
    break;
  case TYPE_PARAMETERS:
    free_parameters(value);
    break;
  case TYPE_CRITERIA:
    free_criteria(value, companion(row, scene));
    break;
  default:
    break;
  }
}
