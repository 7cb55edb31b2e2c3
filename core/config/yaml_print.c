/* What is printed here reads back to the same tree.  Comments and the layout of the source are not kept. */
#include "config/yaml_print.h"

#include <ctype.h>
#include <string.h>

/* Whether the text can stand without quotes everywhere, also in a list on one line. */
static bool is_plain(const char *value) {
  static const char PLAIN[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_/.0123456789-";
  if (!*value || value[strspn(value, PLAIN)]) return false;
  return value[0] != '-' || isdigit((unsigned char)value[1]); /* a dash begins lists and documents */
}

Status yaml_print_text(const char *value, Text *yaml, Error *error) {
  if (is_plain(value)) return text_append(yaml, error, "%s", value);
  Status status;
  TRY(text_append(yaml, error, "\""));
  for (const char *at = value; *at; at++) {
    static const char SPECIAL[] = "\"\\\t\n\r", ESCAPES[] = "\"\\tnr";
    const char *special = strchr(SPECIAL, *at);
    char escape[2] = {'\\', special ? ESCAPES[special - SPECIAL] : '\0'};
    TRY(special ? text_append_bytes(yaml, error, escape, 2) : text_append_bytes(yaml, error, at, 1));
  }
  TRY(text_append(yaml, error, "\""));
cleanup:
  return status;
}

Status yaml_print_inline(const YamlNode *node, Text *yaml, Error *error) {
  if (node->kind == YAML_TREE_TEXT) return yaml_print_text(node->text, yaml, error);
  const bool is_list = node->kind == YAML_TREE_LIST;
  Status status;
  TRY(text_append(yaml, error, is_list ? "[" : "{"));
  for (size_t i = 0; i < node->count; i++) {
    if (i > 0) TRY(text_append(yaml, error, ", "));
    if (!is_list) {
      TRY(yaml_print_text(node->items[i]->key, yaml, error));
      TRY(text_append(yaml, error, ": "));
    }
    TRY(yaml_print_inline(node->items[i], yaml, error));
  }
  TRY(text_append(yaml, error, is_list ? "]" : "}"));
cleanup:
  return status;
}

static Status print_entries(const YamlNode *mapping, int indent, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < mapping->count; i++) {
    const YamlNode *value = mapping->items[i];
    const bool nested = value->kind == YAML_TREE_MAPPING && value->count > 0;
    TRY(text_append(yaml, error, "%*s", indent, ""));
    TRY(yaml_print_text(value->key, yaml, error));
    TRY(text_append(yaml, error, nested ? ":\n" : ": "));
    TRY(nested ? print_entries(value, indent + 2, yaml, error) : yaml_print_inline(value, yaml, error));
    if (!nested) TRY(text_append(yaml, error, "\n"));
  }
cleanup:
  return status;
}

Status yaml_print_file(const YamlNode *mapping, Text *yaml, Error *error) {
  return print_entries(mapping, 0, yaml, error);
}
