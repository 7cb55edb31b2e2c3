/* The keys that all studies share.  Values of `vary` stay text until a scene is read with them: what they
 * mean is the schema's business, as for --set. */
#include "study/study.h"

#include "base/array.h"
#include "base/file.h"
#include "config/override.h"
#include "config/yaml_print.h"
#include "study/entry.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_VALUES = 10000, MOST_POINTS = 100000 };

static const char *const KEYS[] = {"schema", "study", "name", "scene", "vary", NULL};

/* ---- vary ---- */

static Status add_value(Axis *axis, Text *text, SourcePlace place, double number, Error *error) {
  char *value = text_copy(text->data, error);
  if (!value) return error->code;
  axis->texts[axis->n] = value;
  axis->values[axis->n] = (Override){.key = axis->key, .value = value, .place = place};
  axis->numbers[axis->n] = number;
  axis->is_numeric = axis->is_numeric && isfinite(number);
  axis->n++;
  return STATUS_OK;
}

static Status new_axis(Axis *axis, const char *key, size_t n, Error *error) {
  Status status = STATUS_OK;
  *axis = (Axis){.key = key, .is_numeric = true};
  TRY(ARRAY_NEW(&axis->values, n, error));
  TRY(ARRAY_NEW(&axis->numbers, n, error));
  TRY(ARRAY_NEW(&axis->texts, n, error));
cleanup:
  return status;
}

static Status read_list(Axis *axis, const YamlNode *node, Error *error) {
  Status status = STATUS_OK;
  Text text = {0};
  if (node->count == 0 || node->count > MOST_VALUES)
    return place_error(&node->place, error, "expected 1 to %d values for `%s`, found %zu", MOST_VALUES,
                       node->key, node->count);
  TRY(new_axis(axis, node->key, node->count, error));
  for (size_t i = 0; i < node->count; i++) {
    const YamlNode *item = node->items[i];
    Error ignored;
    double number;
    text.length = 0;
    const bool removes = item->kind == YAML_TREE_TEXT && !*item->text; /* as `--set KEY=` does */
    TRY(removes ? text_append(&text, error, "%s", "") : yaml_print_inline(item, &text, error));
    if (entry_number(item, node->key, &number, &ignored) != STATUS_OK) number = NAN;
    TRY(add_value(axis, &text, item->place, number, error));
  }
cleanup:
  text_free(&text);
  return status;
}

/* {from, to, count}: both ends are values; those between have 12 digits, so that they read as written. */
static Status read_range(Axis *axis, const YamlNode *node, Error *error) {
  static const char *const keys[] = {"from", "to", "count", NULL};
  Status status = STATUS_OK;
  const YamlNode *from_node, *to_node, *count_node;
  double from, to;
  int count;
  Text text = {0};
  TRY(entry_check_keys(node, keys, NULL, error));
  TRY(entry_find(node, "from", "a number", &from_node, error));
  TRY(entry_find(node, "to", "a number", &to_node, error));
  TRY(entry_find(node, "count", "a whole number", &count_node, error));
  TRY(entry_number(from_node, "from", &from, error));
  TRY(entry_number(to_node, "to", &to, error));
  TRY(entry_count(count_node, "count", 2, &count, error));
  if (count > MOST_VALUES)
    TRY(place_error(&count_node->place, error, "expected at most %d values, found %d", MOST_VALUES, count));
  TRY(new_axis(axis, node->key, (size_t)count, error));
  for (int i = 0; i < count; i++) {
    const double value = i == count - 1 ? to : from + (to - from) * i / (count - 1);
    text.length = 0;
    TRY(text_append(&text, error, "%.12g", value));
    TRY(add_value(axis, &text, node->place, value, error));
  }
cleanup:
  text_free(&text);
  return status;
}

static Status read_axes(Study *study, const YamlNode *vary, Error *error) {
  Status status = STATUS_OK;
  study->n_points = 1;
  if (!vary) return STATUS_OK;
  if (vary->kind != YAML_TREE_MAPPING)
    return place_error(&vary->place, error, "expected a mapping of keys to values for `vary`, found %s",
                       yaml_tree_found(vary).text);
  TRY(ARRAY_NEW(&study->axes, vary->count, error));
  for (; study->n_axes < vary->count; study->n_axes++) {
    const YamlNode *node = vary->items[study->n_axes];
    Axis *axis = &study->axes[study->n_axes];
    if (node->kind == YAML_TREE_TEXT)
      TRY(place_error(&node->place, error,
                      "expected a list of values or {from, to, count} for `%s`, found %s", node->key,
                      yaml_tree_found(node).text));
    TRY(node->kind == YAML_TREE_LIST ? read_list(axis, node, error) : read_range(axis, node, error));
    study->n_points *= axis->n;
    if (study->n_points > MOST_POINTS)
      TRY(place_error(&vary->place, error, "expected at most %d combinations in `vary`, found more",
                      MOST_POINTS));
  }
cleanup:
  if (status != STATUS_OK && study->n_axes < vary->count)
    study->n_axes++; /* the one half read is freed too */
  return status;
}

void study_place(const Study *study, size_t index, size_t *places) {
  for (size_t a = study->n_axes; a-- > 0;) {
    places[a] = index % study->axes[a].n;
    index /= study->axes[a].n;
  }
}

void study_point(const Study *study, size_t index, Override *settings) {
  for (size_t a = study->n_axes; a-- > 0;) {
    settings[a] = study->axes[a].values[index % study->axes[a].n];
    index /= study->axes[a].n;
  }
}

/* ---- the scene ---- */

static Status read_file(const char *path, YamlNode **root, Error *error) {
  Text text = {0};
  Status status = file_read(path, YAML_TREE_BYTES, &text, error);
  if (status == STATUS_IO) status = error->code = STATUS_INPUT; /* a wrong path is wrong input */
  if (status == STATUS_OK) status = yaml_tree_parse(root, path, true, text.data, text.length, error);
  text_free(&text);
  return status;
}

static Status read_scene_file(Study *study, const YamlNode *node, Error *error) {
  Status status = STATUS_OK;
  Text folder = {0}, path = {0};
  const char *name;
  TRY(entry_text(node, "scene", &name, error));
  TRY(file_folder(&folder, study->file, error));
  TRY(file_join(&path, strcmp(folder.data, ".") == 0 ? "" : folder.data, name, error));
  study->scene_file = text_copy(path.data, error);
  if (!study->scene_file) TRY(error->code);
  status = read_file(study->scene_file, &study->scene, error);
  if (status != STATUS_OK && !file_exists(study->scene_file)) place_prefix(&node->place, error);
cleanup:
  text_free(&path);
  text_free(&folder);
  return status;
}

static Status apply_sets(Study *study, const char *const *sets, size_t n_sets, Error *error) {
  Status status = STATUS_OK;
  Text source = {0};
  TRY(ARRAY_NEW(&study->sources, n_sets, error));
  for (size_t i = 0; i < n_sets; i++) {
    source.length = 0;
    TRY(text_append(&source, error, "--set %s", sets[i]));
    study->sources[i] = text_copy(source.data, error);
    if (!study->sources[i]) TRY(error->code);
    study->n_sources = i + 1;
    TRY(override_apply(study->scene, sets[i], study->sources[i], error));
  }
cleanup:
  text_free(&source);
  return status;
}

static Status read_base_scene(Study *study, const char *const *sets, size_t n_sets, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *node;
  TRY(entry_find(study->root, "scene", "the path of a scene, or a scene", &node, error));
  if (node->kind == YAML_TREE_MAPPING) {
    TRY(yaml_tree_copy(&study->scene, node, error));
    study->scene_file = text_copy(study->file, error);
    if (!study->scene_file) TRY(error->code);
  } else {
    TRY(read_scene_file(study, node, error));
  }
  if (study->scene->kind != YAML_TREE_MAPPING)
    TRY(place_error(&study->scene->place, error, "expected a mapping with the keys of a scene, found %s",
                    yaml_tree_found(study->scene).text));
  TRY(apply_sets(study, sets, n_sets, error));
cleanup:
  return status;
}

Status study_scene(const Study *study, const Override *settings, size_t n, Scene *scene, Simulation *laws,
                   Error *error) {
  Status status;
  YamlNode *tree = NULL;
  TRY(yaml_tree_copy(&tree, study->scene, error));
  for (size_t i = 0; i < n; i++)
    TRY(override_put(tree, settings[i].key, settings[i].value, &settings[i].place, error));
  TRY(scene_read_tree(scene, study->scene_file, tree, error));
  if (!laws) goto cleanup;
  status = simulation_load_laws(laws, scene, NULL, error);
  if (status != STATUS_OK) scene_free(scene);
cleanup:
  yaml_tree_free(tree);
  return status;
}

Status study_check(const Study *study, const Override *settings, size_t n, Error *error) {
  Scene scene;
  Simulation laws;
  const Status status = study_scene(study, settings, n, &scene, &laws, error);
  if (status != STATUS_OK) return status;
  simulation_free(&laws);
  scene_free(&scene);
  return STATUS_OK;
}

Status study_check_points(const Study *study, Error *error) {
  Status status = STATUS_OK;
  Override *settings = NULL;
  TRY(ARRAY_NEW(&settings, study->n_axes, error));
  for (size_t i = 0; i < study->n_points; i++) {
    study_point(study, i, settings);
    TRY(study_check(study, settings, study->n_axes, error));
  }
cleanup:
  array_free(settings);
  return status;
}

Status study_set(Study *study, const char *key, const char *value, Error *error) {
  return override_put(study->scene, key, value, &study->root->place, error);
}

bool study_scene_gives(const Study *study, const char *key) {
  char name[64];
  const YamlNode *node = study->scene;
  while (node && *key) {
    const size_t length = strcspn(key, ".");
    if (node->kind != YAML_TREE_MAPPING) return false;
    snprintf(name, sizeof name, "%.*s", (int)length, key);
    node = yaml_tree_find(node, name);
    key += length + (key[length] == '.');
  }
  return node != NULL;
}

/* ---- the whole ---- */

static Status read_kind(Study *study, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *node;
  const char *names[16] = {NULL};
  int choice;
  for (size_t i = 0; STUDY_KINDS[i]; i++) names[i] = STUDY_KINDS[i]->name;
  if (!yaml_tree_find(study->root, "study") && yaml_tree_find(study->root, "membrane"))
    TRY(place_error(&study->root->place, error, "expected a study, found a scene; `capsella run` runs it"));
  TRY(entry_find(study->root, "study", "the kind of study", &node, error));
  TRY(entry_choice(node, "study", names, &choice, error));
  study->kind = STUDY_KINDS[choice];
cleanup:
  return status;
}

static Status read_schema(const Study *study, Error *error) {
  const YamlNode *node;
  const Status status = entry_find(study->root, "schema", "`1`", &node, error);
  if (status != STATUS_OK) return status;
  if (node->kind == YAML_TREE_TEXT && strcmp(node->text, "1") == 0) return STATUS_OK;
  return place_error(&node->place, error, "expected `1` for `schema`, found %s", yaml_tree_found(node).text);
}

/* The name of the file without folder and ending, unless the study gives itself one. */
static Status read_name(Study *study, Error *error) {
  const YamlNode *node = yaml_tree_find(study->root, "name");
  const char *name;
  if (node) {
    Status status = entry_text(node, "name", &name, error);
    if (status != STATUS_OK) return status;
    if (*name == '.' || strchr(name, '/'))
      return place_error(&node->place, error, "expected a name without '/' or a leading '.', found `%s`",
                         name);
  } else {
    const char *slash = strrchr(study->file, '/');
    name = slash ? slash + 1 : study->file;
  }
  study->name = text_copy(name, error);
  if (!study->name) return error->code;
  char *dot = strrchr(study->name, '.');
  if (!node && dot && dot > study->name) *dot = '\0';
  return STATUS_OK;
}

Status study_read(Study *study, const char *path, const char *const *sets, size_t n_sets, Error *error) {
  Status status = STATUS_OK;
  *study = (Study){0};
  study->file = text_copy(path, error);
  if (!study->file) return error->code;
  TRY(read_file(study->file, &study->root, error));
  if (study->root->kind != YAML_TREE_MAPPING)
    TRY(place_error(&study->root->place, error, "expected a mapping with the keys of a study, found %s",
                    yaml_tree_found(study->root).text));
  TRY(read_schema(study, error));
  TRY(read_kind(study, error));
  TRY(entry_check_keys(study->root, KEYS, study->kind->keys, error));
  TRY(read_name(study, error));
  TRY(read_base_scene(study, sets, n_sets, error));
  if (!study_scene_gives(study, "output.report")) TRY(study_set(study, "output.report", "false", error));
  TRY(read_axes(study, yaml_tree_find(study->root, "vary"), error));
  if (study->kind->prepare) TRY(study->kind->prepare(study, error));
cleanup:
  if (status != STATUS_OK) study_free(study);
  return status;
}

static void free_texts(char **texts, size_t n) {
  for (size_t i = 0; i < n; i++) array_free(texts[i]);
  array_free(texts);
}

Status study_take_part(Study *study, int part, int parts, Error *error) {
  if (study->n_axes == 0)
    return error_set(error, STATUS_INPUT, "expected a study with `vary`, of which there can be parts");
  Axis *axis = &study->axes[0];
  const size_t n = axis->n, size = (size_t)parts;
  if (size > n)
    return error_set(
        error, STATUS_INPUT,
        "expected at most %zu parts, since the first key of `vary`, %s, has as many values, found %d", n,
        axis->key, parts);
  const size_t first = n * ((size_t)part - 1) / size, last = n * (size_t)part / size, kept = last - first;
  for (size_t i = 0; i < n; i++)
    if (i < first || i >= last) array_free(axis->texts[i]);
  memmove(axis->texts, axis->texts + first, kept * sizeof *axis->texts);
  memmove(axis->values, axis->values + first, kept * sizeof *axis->values);
  memmove(axis->numbers, axis->numbers + first, kept * sizeof *axis->numbers);
  axis->n = kept;
  study->n_points = study->n_points / n * kept;
  return STATUS_OK;
}

void study_free(Study *study) {
  for (size_t a = 0; a < study->n_axes; a++) {
    free_texts(study->axes[a].texts, study->axes[a].n);
    array_free(study->axes[a].values);
    array_free(study->axes[a].numbers);
  }
  array_free(study->axes);
  free_texts(study->sources, study->n_sources);
  yaml_tree_free(study->scene);
  yaml_tree_free(study->root);
  array_free(study->scene_file);
  array_free(study->name);
  array_free(study->file);
  *study = (Study){0};
}
