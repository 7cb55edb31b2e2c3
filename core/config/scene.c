/* From a scene file to a Scene and back, row by row of the schema.  What one row cannot know, because it
 * concerns several keys, is checked in complete(). */
#include "config/scene.h"

#include "base/array.h"
#include "base/file.h"
#include "config/override.h"
#include "config/value.h"
#include <math.h>
#include <string.h>

/* Refuses keys that no row knows, and values in place of mappings; `prefix` is the key of `mapping` with a
 * dot behind it. */
static Status check_keys(const YamlNode *mapping, const char *prefix, Error *error) {
  Status status = STATUS_OK;
  Text key = {0}, hint = {0};
  for (size_t i = 0; i < mapping->count; i++) {
    const YamlNode *node = mapping->items[i];
    text_free(&key);
    TRY(text_append(&key, error, "%s%s", prefix, node->key));
    if (schema_is_mapping(key.data)) {
      if (node->kind != YAML_TREE_MAPPING)
        TRY(place_error(&node->place, error, "expected a mapping for `%s`, found %s", key.data,
                        yaml_tree_found(node).text));
      TRY(text_append(&key, error, "."));
      TRY(check_keys(node, key.data, error));
    } else if (strcmp(key.data, "study") == 0) {
      TRY(place_error(&node->key_place, error, "expected a scene, found a study; `capsella study` runs it"));
    } else if (!schema_find(key.data)) {
      TRY(schema_suggest(key.data, &hint, error));
      TRY(place_error(&node->key_place, error, "expected a known key, found `%s`%s%s%s", key.data,
                      hint.data ? " (did you mean `" : "", hint.data ? hint.data : "",
                      hint.data ? "`?)" : ""));
    }
  }
cleanup:
  text_free(&key);
  text_free(&hint);
  return status;
}

/* The node of a key with dots; NULL when there is none, and then *nearest is the innermost mapping on the way
 * to it. */
static const YamlNode *find(const YamlNode *root, const char *key, const YamlNode **nearest) {
  char name[64];
  const YamlNode *node = root;
  for (*nearest = root; node && *key; key += *key == '.') {
    size_t length = strcspn(key, ".");
    *nearest = node;
    memcpy(name, key, length);
    name[length] = '\0';
    node = yaml_tree_find(node, name);
    key += length;
  }
  return node;
}

static Status missing(const SchemaRow *row, const YamlNode *mapping, Error *error) {
  Text expected = {0};
  Status status = schema_expected(row, &expected, error);
  if (status == STATUS_OK)
    status = place_error(&mapping->place, error, "expected the key `%s` (%s)%s%s, found none", row->key,
                         expected.data, row->where ? ", required where " : "",
                         row->where ? row->where->words : "");
  text_free(&expected);
  return status;
}

static Status read_default(const SchemaRow *row, const char *value, Scene *scene, Error *error) {
  YamlNode *node;
  Status status = yaml_tree_parse(&node, "default", false, value, strlen(value), error);
  if (status != STATUS_OK) return status;
  status = value_read(row, node, scene, error);
  yaml_tree_free(node);
  return status;
}

static Status read_row(const SchemaRow *row, const YamlNode *root, Scene *scene, Error *error) {
  const YamlNode *mapping, *node = find(root, row->key, &mapping);
  if (node && !schema_applies(row, scene))
    return place_error(&node->key_place, error, "expected `%s` only where %s, found it here", row->key,
                       row->where->words);
  if (node) return value_read(row, node, scene, error);
  const char *value = schema_default(row, scene->accuracy);
  if (row->type == TYPE_GROUP || !schema_applies(row, scene)) return STATUS_OK;
  return value ? read_default(row, value, scene, error) : missing(row, mapping, error);
}

/* All rows; those whose default depends on `accuracy` once that is known. */
static Status read_rows(const YamlNode *root, Scene *scene, Error *error) {
  Status status = STATUS_OK;
  if (root->kind != YAML_TREE_MAPPING)
    return place_error(&root->place, error, "expected a mapping with the keys of a scene, found %s",
                       yaml_tree_found(root).text);
  TRY(check_keys(root, "", error));
  for (int pass = 0; pass < 2; pass++)
    for (size_t i = 0; i < SCHEMA_ROWS; i++)
      if (schema_has_preset(&SCHEMA[i]) == (pass == 1)) TRY(read_row(&SCHEMA[i], root, scene, error));
cleanup:
  return status;
}

static void fill_gradient(FlowKind kind, double gradient[3][3]) {
  switch (kind) {
  case FLOW_SIMPLE_SHEAR:
    gradient[0][2] = 1;
    break;
  case FLOW_PLANAR_HYPERBOLIC:
    gradient[0][0] = 1;
    gradient[2][2] = -1;
    break;
  case FLOW_UNIAXIAL_EXTENSION:
    gradient[0][0] = 1;
    gradient[1][1] = gradient[2][2] = -0.5;
    break;
  case FLOW_LINEAR:
  case FLOW_INFLATION:
    break;
  }
}

/* The name becomes that of a folder of results. */
static Status check_name(const YamlNode *root, const char *name, Error *error) {
  const YamlNode *mapping, *node = find(root, "name", &mapping);
  if (!node || (name[0] != '.' && !strchr(name, '/'))) return STATUS_OK;
  return place_error(&node->place, error, "expected a name without '/' or a leading '.', found `%s`", name);
}

static Status check_axis(const YamlNode *root, const double axis[3], Error *error) {
  const YamlNode *mapping, *node = find(root, "capsule.mesh.rotation.axis", &mapping);
  if (!node || axis[0] != 0 || axis[1] != 0 || axis[2] != 0) return STATUS_OK;
  return place_error(&node->place, error, "expected an axis with a direction, found [0, 0, 0]");
}

static Status check_gradient(const YamlNode *root, const double gradient[3][3], Error *error) {
  const YamlNode *mapping, *node = find(root, "flow.gradient", &mapping);
  double trace = gradient[0][0] + gradient[1][1] + gradient[2][2], size = 0;
  for (int i = 0; i < 9; i++) size = fmax(size, fabs(gradient[i / 3][i % 3]));
  /* decimal fractions need not cancel to the last bit */
  if (!node || fabs(trace) <= 1e-12 * size) return STATUS_OK;
  return place_error(&node->place, error,
                     "expected a gradient with trace 0 (the fluid is incompressible), found trace %g", trace);
}

static Status check_path(const YamlNode *root, const Scene *scene, Error *error) {
  const YamlNode *mapping, *node = find(root, "flow.path", &mapping);
  if (!node) return STATUS_OK;
  double last = scene->flow.path[scene->flow.n_path - 1][0];
  if (last >= scene->time.end) return STATUS_OK;
  return place_error(&node->place, error, "expected a path to `time.end` = %g, found one to t = %g",
                     scene->time.end, last);
}

/* Rates are taken between rows of the history. */
static Status check_steady(const YamlNode *root, const Scene *scene, Error *error) {
  const YamlNode *mapping, *node = find(root, "stop.steady", &mapping);
  if (!node || scene->stop.steady == 0 || scene->output.history_every > 0) return STATUS_OK;
  return place_error(&node->place, error,
                     "expected `output.history_every` above 0, between whose rows rates are taken, found 0");
}

/* Quartic interpolation is on the four elements that come from halving one. */
static Status check_interpolation(const YamlNode *root, const Scene *scene, Error *error) {
  const YamlNode *mapping, *node = find(root, "membrane.interpolation", &mapping);
  if (!node || scene->membrane.interpolation == INTERPOLATION_QUADRATIC || scene->mesh.subdivisions > 0)
    return STATUS_OK;
  return place_error(
      &node->place, error,
      "expected `quadratic` on an icosahedron that is not halved (`capsule.mesh.subdivisions` is "
      "0), found `quartic`");
}

/* What no row can see by itself. */
static Status complete(const YamlNode *root, Scene *scene, Error *error) {
  Status status;
  fill_gradient(scene->flow.kind, scene->flow.gradient);
  TRY(check_name(root, scene->name, error));
  TRY(check_axis(root, scene->mesh.rotation_axis, error));
  TRY(check_gradient(root, (const double(*)[3])scene->flow.gradient, error));
  TRY(check_path(root, scene, error));
  TRY(check_steady(root, scene, error));
  TRY(check_interpolation(root, scene, error));
cleanup:
  return status;
}

/* Keeps the texts that places point to as long as the scene. */
static Status keep_sources(Scene *scene, const char *file, const char *const *sets, size_t n_sets,
                           Error *error) {
  Status status = STATUS_OK;
  Text source = {0};
  scene->file = text_copy(file, error);
  if (!scene->file) return error->code;
  TRY(ARRAY_NEW(&scene->sources, n_sets, error));
  for (scene->n_sources = 0; scene->n_sources < n_sets; scene->n_sources++) {
    text_free(&source);
    TRY(text_append(&source, error, "--set %s", sets[scene->n_sources]));
    scene->sources[scene->n_sources] = text_copy(source.data, error);
    if (!scene->sources[scene->n_sources]) TRY(error->code);
  }
cleanup:
  text_free(&source);
  return status;
}

/* From a tree to a scene that holds its sources already. */
static Status read_tree(Scene *scene, const YamlNode *root, Error *error) {
  Status status;
  TRY(read_rows(root, scene, error));
  TRY(complete(root, scene, error));
cleanup:
  return status;
}

Status scene_read_tree(Scene *scene, const char *file, const YamlNode *root, Error *error) {
  Status status;
  *scene = (Scene){0};
  TRY(keep_sources(scene, file, NULL, 0, error));
  TRY(read_tree(scene, root, error));
cleanup:
  if (status != STATUS_OK) scene_free(scene);
  return status;
}

Status scene_read_text(Scene *scene, const char *file, const char *bytes, size_t length,
                       const char *const *sets, size_t n_sets, Error *error) {
  Status status;
  YamlNode *root = NULL;
  *scene = (Scene){0};
  TRY(keep_sources(scene, file, sets, n_sets, error));
  TRY(yaml_tree_parse(&root, scene->file, true, bytes, length, error));
  for (size_t i = 0; i < n_sets && root->kind == YAML_TREE_MAPPING; i++)
    TRY(override_apply(root, sets[i], scene->sources[i], error));
  TRY(read_tree(scene, root, error));
cleanup:
  yaml_tree_free(root);
  if (status != STATUS_OK) scene_free(scene);
  return status;
}

Status scene_read(Scene *scene, const char *path, const char *const *sets, size_t n_sets, Error *error) {
  Text text = {0};
  *scene = (Scene){0};
  Status status = file_read(path, YAML_TREE_BYTES, &text, error);
  if (status == STATUS_IO) status = error->code = STATUS_INPUT; /* a wrong path is wrong input */
  if (status == STATUS_OK) status = scene_read_text(scene, path, text.data, text.length, sets, n_sets, error);
  text_free(&text);
  return status;
}

void scene_free(Scene *scene) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++) value_free(&SCHEMA[i], scene);
  for (size_t i = 0; i < scene->n_sources; i++) array_free(scene->sources[i]);
  array_free(scene->sources);
  array_free(scene->file);
  *scene = (Scene){0};
}

/* "# " in front of each line. */
static Status print_comments(const char *comments, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  while (comments && *comments) {
    size_t length = strcspn(comments, "\n");
    TRY(text_append(yaml, error, "#%s", length ? " " : ""));
    TRY(text_append_bytes(yaml, error, comments, length));
    TRY(text_append(yaml, error, "\n"));
    comments += length + (comments[length] == '\n');
  }
cleanup:
  return status;
}

/* The names of a key, each on a line of its own, but for those shared with the key before; no line end behind
 * the last. */
static Status print_key(const char *key, const char *before, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  int indent = 0;
  bool shared = true;
  for (const char *name = key; *name; indent += 2) {
    size_t length = strcspn(name, ".");
    shared = shared && strncmp(key, before, (size_t)(name - key) + length + 1) == 0;
    bool last = name[length] == '\0';
    if (!shared || last)
      TRY(text_append(yaml, error, "%*s%.*s:%s", indent, "", (int)length, name, last ? " " : "\n"));
    name += length + !last;
  }
cleanup:
  return status;
}

Status scene_print(const Scene *scene, const char *comments, Text *yaml, Error *error) {
  Status status;
  const char *before = "";
  TRY(print_comments(comments, yaml, error));
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    const SchemaRow *row = &SCHEMA[i];
    if (row->type == TYPE_GROUP || !schema_applies(row, scene)) continue;
    TRY(print_key(row->key, before, yaml, error));
    TRY(value_print(row, scene, yaml, error));
    TRY(text_append(yaml, error, "\n"));
    before = row->key;
  }
cleanup:
  return status;
}
