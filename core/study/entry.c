/* Scalars are text in the tree; what they mean is said here, for study files as value.c says it for scenes.
 */
#include "study/entry.h"

#include "base/text.h"
#include "config/units.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static size_t length_of(const char *const *words) {
  size_t n = 0;
  while (words && words[n]) n++;
  return n;
}

static bool contains(const char *const *words, const char *word) {
  for (size_t i = 0; i < length_of(words); i++)
    if (strcmp(words[i], word) == 0) return true;
  return false;
}

static Status unknown_key(const YamlNode *node, const char *const *keys, const char *const *more,
                          Error *error) {
  enum { MOST = 64 };
  const char *names[MOST];
  size_t n = 0;
  for (size_t i = 0; i < length_of(keys) && n < MOST; i++) names[n++] = keys[i];
  for (size_t i = 0; i < length_of(more) && n < MOST; i++) names[n++] = more[i];
  const char *nearest = text_nearest(node->key, names, n);
  return place_error(&node->key_place, error, "expected a known key, found `%.60s`%s%s%s", node->key,
                     nearest ? " (did you mean `" : "", nearest ? nearest : "", nearest ? "`?)" : "");
}

Status entry_check_keys(const YamlNode *mapping, const char *const *keys, const char *const *more,
                        Error *error) {
  for (size_t i = 0; i < mapping->count; i++)
    if (!contains(keys, mapping->items[i]->key) && !contains(more, mapping->items[i]->key))
      return unknown_key(mapping->items[i], keys, more, error);
  return STATUS_OK;
}

Status entry_find(const YamlNode *mapping, const char *key, const char *expected, const YamlNode **node,
                  Error *error) {
  *node = yaml_tree_find(mapping, key);
  if (*node) return STATUS_OK;
  return place_error(&mapping->place, error, "expected the key `%s` (%s), found none", key, expected);
}

static Status unexpected(const YamlNode *node, const char *name, const char *expected, Error *error) {
  return place_error(&node->place, error, "expected %s for `%s`, found %s", expected, name,
                     yaml_tree_found(node).text);
}

Status entry_text(const YamlNode *node, const char *name, const char **text, Error *error) {
  if (node->kind != YAML_TREE_TEXT || !*node->text) return unexpected(node, name, "text", error);
  *text = node->text;
  return STATUS_OK;
}

Status entry_number(const YamlNode *node, const char *name, double *value, Error *error) {
  Quantity quantity;
  Error why;
  const bool reads = node->kind == YAML_TREE_TEXT && units_parse(node->text, &quantity, &why) == STATUS_OK;
  if (!reads || quantity.has_unit) return unexpected(node, name, "a number", error);
  *value = quantity.value;
  return STATUS_OK;
}

Status entry_count(const YamlNode *node, const char *name, int low, int *value, Error *error) {
  double number;
  char expected[48];
  const Status status = entry_number(node, name, &number, error);
  if (status != STATUS_OK) return status;
  snprintf(expected, sizeof expected, "a whole number of at least %d", low);
  if (!(number >= low && number <= 1e6 && number == floor(number)))
    return unexpected(node, name, expected, error);
  *value = (int)number;
  return STATUS_OK;
}

Status entry_choice(const YamlNode *node, const char *name, const char *const *words, int *choice,
                    Error *error) {
  const char *text = NULL;
  Status status = entry_text(node, name, &text, error);
  if (status != STATUS_OK) return status;
  for (*choice = 0; words[*choice]; ++*choice)
    if (strcmp(words[*choice], text) == 0) return STATUS_OK;
  const char *nearest = text_nearest(text, words, length_of(words));
  Text list = {0};
  for (size_t i = 0; words[i]; i++)
    TRY(text_append(&list, error, "%s`%s`", i == 0 ? "" : words[i + 1] ? ", " : " or ", words[i]));
  status = place_error(&node->place, error, "expected %s for `%s`, found `%.60s`%s%s%s", list.data, name,
                       text, nearest ? " (did you mean `" : "", nearest ? nearest : "", nearest ? "`?)" : "");
cleanup:
  text_free(&list);
  return status;
}
