/* The figures are a YAML tree, which JSON is, too. */
#include "study/case.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/snapshot.h"
#include "study/label.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- figures ---- */

bool case_ended(const Case *item) {
  return item->state == CASE_DONE || item->state == CASE_FAILED;
}

/* The entry of a list at a position written in digits, or NULL. */
static const YamlNode *entry_of(const YamlNode *list, const char *position) {
  char *end;
  const unsigned long k = strtoul(position, &end, 10);
  return *end == '\0' && k < list->count ? list->items[k] : NULL;
}

static const YamlNode *figure(const Case *item, const char *key) {
  char name[64];
  const YamlNode *node = item->summary;
  while (node && *key) {
    const size_t length = strcspn(key, ".");
    if (node->kind == YAML_TREE_TEXT || length >= sizeof name) return NULL;
    memcpy(name, key, length);
    name[length] = '\0';
    node = node->kind == YAML_TREE_MAPPING ? yaml_tree_find(node, name) : entry_of(node, name);
    key += length + (key[length] == '.');
  }
  return node;
}

static double number_of(const YamlNode *node) {
  if (!node || node->kind != YAML_TREE_TEXT) return NAN;
  char *end;
  const double value = strtod(node->text, &end);
  return *node->text && *end == '\0' ? value : NAN;
}

double case_number(const Case *item, const char *key) {
  return number_of(figure(item, key));
}

double case_component(const Case *item, const char *key, size_t k) {
  const YamlNode *list = figure(item, key);
  return list && list->kind == YAML_TREE_LIST && k < list->count ? number_of(list->items[k]) : NAN;
}

const char *case_status(const Case *item) {
  const YamlNode *node = figure(item, "status");
  return item->state == CASE_DONE && node && node->kind == YAML_TREE_TEXT ? node->text : "failed";
}

/* ---- folder ---- */

Status case_read_summary(Case *item, Error *error) {
  Status status = STATUS_OK;
  Text path = {0}, text = {0};
  TRY(file_join(&path, item->folder, "summary.json", error));
  if (!file_exists(path.data)) goto cleanup;
  TRY(file_read(path.data, YAML_TREE_BYTES, &text, error));
  yaml_tree_free(item->summary);
  TRY(yaml_tree_parse(&item->summary, "summary.json", true, text.data, text.length, error));
cleanup:
  text_free(&text);
  text_free(&path);
  return status;
}

bool case_has_result(const Case *item) {
  const YamlNode *node = figure(item, "status");
  if (!node || node->kind != YAML_TREE_TEXT) return false;
  return strcmp(node->text, "interrupted") != 0 && strcmp(node->text, "failed") != 0;
}

Status case_remove_file(const Case *item, const char *name, Error *error) {
  Text path = {0};
  Status status = file_join(&path, item->folder, name, error);
  if (status == STATUS_OK && remove(path.data) != 0 && errno != ENOENT)
    status = error_set(error, STATUS_IO, "%s: cannot be removed: %s", path.data, strerror(errno));
  text_free(&path);
  return status;
}

Status case_remove_snapshots(const Case *item, Error *error) {
  Status status = STATUS_OK;
  int *numbers = NULL;
  size_t count;
  Text path = {0};
  TRY(snapshot_list(item->folder, &numbers, &count, error));
  for (size_t i = 0; i < count; i++) {
    path.length = 0;
    TRY(snapshot_path(&path, item->folder, numbers[i], error));
    if (remove(path.data) != 0)
      TRY(error_set(error, STATUS_IO, "%s: cannot be removed: %s", path.data, strerror(errno)));
  }
  TRY(case_remove_file(item, "series.xdmf", error));
  TRY(case_remove_file(item, "snapshots.hdf.series", error));
cleanup:
  text_free(&path);
  array_free(numbers);
  return status;
}

Status case_clear(const Case *item, Error *error) {
  Status status = STATUS_OK;
  TRY(file_make_folder(item->folder, error));
  TRY(case_remove_file(item, "summary.json", error));
  TRY(case_remove_snapshots(item, error));
cleanup:
  return status;
}

Status case_erase(const char *folder, Error *error) {
  static const char *const names[] = {"history.csv", "resolved.yaml", "log.txt", "messages.txt", ".lock"};
  char *own = text_copy(folder, error);
  if (!own) return error->code;
  Case item = {.folder = own};
  Status status = access(folder, F_OK) == 0 ? case_clear(&item, error) : STATUS_OK;
  for (size_t k = 0; status == STATUS_OK && k < sizeof names / sizeof *names; k++)
    status = case_remove_file(&item, names[k], error);
  rmdir(folder); /* stays when it holds what is not of a case */
  array_free(own);
  return status;
}

/* ---- life ---- */

void case_free(Case *item) {
  if (!item) return;
  for (size_t i = 0; i < item->n_sets; i++) array_free(item->sets[i]);
  array_free(item->sets);
  array_free(item->label);
  array_free(item->folder);
  array_free(item->reason);
  yaml_tree_free(item->summary);
  array_free(item);
}

Status case_new(Case **made, const char *study_folder, uint64_t identity, const char *label,
                const Override *settings, size_t n, Error *error) {
  Status status = STATUS_OK;
  Text text = {0};
  Case *item = NULL;
  TRY(ARRAY_NEW(&item, 1, error));
  TRY(ARRAY_NEW(&item->sets, n, error));
  item->identity = identity;
  for (size_t i = 0; i < n; i++) {
    text.length = 0;
    TRY(text_append(&text, error, "%s=%s", settings[i].key, settings[i].value));
    if (!(item->sets[i] = text_copy(text.data, error))) TRY(error->code);
    item->n_sets = i + 1;
    item->identity = label_hash(label_hash(item->identity, text.data), "\n");
  }
  text.length = 0;
  TRY(text_append(&text, error, "%s/cases/%s", study_folder, label));
  if (!(item->folder = text_copy(text.data, error))) TRY(error->code);
  if (!(item->label = text_copy(label, error))) TRY(error->code);
cleanup:
  text_free(&text);
  if (status != STATUS_OK) {
    case_free(item);
    item = NULL;
  }
  *made = item;
  return status;
}
