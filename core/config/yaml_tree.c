/* libyaml events to a tree.  The only file that includes yaml.h. */
#include "config/yaml_tree.h"

#include "base/array.h"
#include "base/text.h"
#include "config/utf8.h"
#include <stdio.h>
#include <string.h>
#include <yaml.h>

/* The parser and the event that it stands at. */
typedef struct {
  yaml_parser_t parser;
  yaml_event_t event;
  const char *file;
  bool located;
} Reader;

static SourcePlace place_of(const Reader *reader, yaml_mark_t mark) {
  SourcePlace place = {.file = reader->file};
  if (reader->located) {
    place.line = (int)mark.line + 1;
    place.column = (int)mark.column + 1;
  }
  return place;
}

/* What a message of the parser mostly means in a scene. */
static const char *advice(const char *problem) {
  static const char *const meanings[][2] = {
      {"found character that cannot start any token", " (a tab? indent with blanks)"},
      {"could not find expected ':'", " (`key: value` has a blank behind the colon)"},
      {"mapping values are not allowed in this context",
       " (a line above without its colon, one indented too far, or two colons?)"},
      {"did not find expected key", " (is the line indented as its neighbours are?)"},
      {"did not find expected ',' or '}'", " (`{a: 1, b: 2}` needs commas between and a brace at the end)"},
      {"did not find expected ',' or ']'", " (`[1, 2]` needs commas between and a bracket at the end)"},
  };
  for (size_t k = 0; k < sizeof meanings / sizeof *meanings; k++)
    if (strcmp(meanings[k][0], problem) == 0) return meanings[k][1];
  return "";
}

static Status syntax_error(const Reader *reader, Error *error) {
  const yaml_parser_t *parser = &reader->parser;
  if (parser->error == YAML_MEMORY_ERROR)
    return error_set(error, STATUS_MEMORY, "out of memory: %s cannot be parsed", reader->file);
  SourcePlace place = place_of(reader, parser->problem_mark);
  const char *problem = parser->problem ? parser->problem : "something that cannot be parsed";
  if (!parser->context)
    return place_error(&place, error, "expected YAML, found a mistake: %s%s", problem, advice(problem));
  return place_error(&place, error, "expected YAML, found a mistake %s (from line %d): %s%s", parser->context,
                     (int)parser->context_mark.line + 1, problem, advice(problem));
}

/* Moves to the next event. */
static Status next(Reader *reader, Error *error) {
  yaml_event_delete(&reader->event);
  return yaml_parser_parse(&reader->parser, &reader->event) ? STATUS_OK : syntax_error(reader, error);
}

static Status append(YamlNode *parent, YamlNode *child, Error *error) {
  if (parent->count == parent->capacity) {
    size_t capacity = parent->capacity ? 2 * parent->capacity : 4;
    YamlNode **items;
    Status status = ARRAY_NEW(&items, capacity, error);
    if (status != STATUS_OK) return status;
    if (parent->count) memcpy(items, parent->items, parent->count * sizeof *items);
    array_free(parent->items);
    parent->items = items;
    parent->capacity = capacity;
  }
  parent->items[parent->count++] = child;
  return STATUS_OK;
}

static Status refuse_decorations(const Reader *reader, Error *error) {
  const yaml_event_t *event = &reader->event;
  const yaml_char_t *anchor = NULL, *tag = NULL;
  if (event->type == YAML_SCALAR_EVENT) {
    anchor = event->data.scalar.anchor;
    tag = event->data.scalar.tag;
  } else if (event->type == YAML_SEQUENCE_START_EVENT) {
    anchor = event->data.sequence_start.anchor;
    tag = event->data.sequence_start.tag;
  } else if (event->type == YAML_MAPPING_START_EVENT) {
    anchor = event->data.mapping_start.anchor;
    tag = event->data.mapping_start.tag;
  }
  SourcePlace place = place_of(reader, event->start_mark);
  if (event->type == YAML_ALIAS_EVENT)
    return place_error(&place, error, "expected a value, found the alias `*%.40s` (write the value out)",
                       (const char *)event->data.alias.anchor);
  if (anchor)
    return place_error(&place, error, "expected a value without an anchor, found `&%.40s`",
                       (const char *)anchor);
  if (tag)
    return place_error(&place, error, "expected a value without a tag, found `%.40s`", (const char *)tag);
  return STATUS_OK;
}

/* A copy of the scalar that the reader stands at. */
static Status copy_scalar(const Reader *reader, char **copy, Error *error) {
  const char *text = (const char *)reader->event.data.scalar.value;
  size_t length = reader->event.data.scalar.length;
  if (utf8_printable(text, length) != length) { /* made by an escape such as "\0" */
    SourcePlace place = place_of(reader, reader->event.start_mark);
    return place_error(&place, error, "expected printable text, found an escaped control character");
  }
  *copy = text_copy(text, error);
  return *copy ? STATUS_OK : error->code;
}

static Status read_node(Reader *reader, int depth, YamlNode **out, Error *error);

static Status read_items(Reader *reader, int depth, YamlNode *list, Error *error) {
  Status status;
  YamlNode *item = NULL;
  for (;;) {
    TRY(next(reader, error));
    if (reader->event.type == YAML_SEQUENCE_END_EVENT) return STATUS_OK;
    TRY(read_node(reader, depth, &item, error));
    TRY(append(list, item, error));
    item = NULL;
  }
cleanup:
  yaml_tree_free(item);
  return status;
}

static Status read_key(Reader *reader, const YamlNode *mapping, char **key, Error *error) {
  SourcePlace place = place_of(reader, reader->event.start_mark);
  Status status = refuse_decorations(reader, error);
  if (status != STATUS_OK) return status;
  if (reader->event.type != YAML_SCALAR_EVENT)
    return place_error(&place, error, "expected a name as key, found a list or a mapping");
  if (mapping->count == YAML_TREE_KEYS)
    return place_error(&place, error, "expected at most %d keys in one mapping, found more", YAML_TREE_KEYS);
  status = copy_scalar(reader, key, error);
  if (status != STATUS_OK) return status;
  const YamlNode *first = yaml_tree_find(mapping, *key);
  if (first)
    return place_error(&place, error, "expected each key once, found `%.40s` again (first in line %d)", *key,
                       first->key_place.line);
  return STATUS_OK;
}

static Status read_entries(Reader *reader, int depth, YamlNode *mapping, Error *error) {
  Status status;
  char *key = NULL;
  YamlNode *value = NULL;
  for (;;) {
    TRY(next(reader, error));
    if (reader->event.type == YAML_MAPPING_END_EVENT) return STATUS_OK;
    SourcePlace place = place_of(reader, reader->event.start_mark);
    TRY(read_key(reader, mapping, &key, error));
    TRY(next(reader, error));
    TRY(read_node(reader, depth, &value, error));
    TRY(append(mapping, value, error));
    value->key = key;
    value->key_place = place;
    key = NULL;
    value = NULL;
  }
cleanup:
  array_free(key);
  yaml_tree_free(value);
  return status;
}

/* Reads the value whose first event the reader stands at; ends at its last event. */
static Status read_node(Reader *reader, int depth, YamlNode **out, Error *error) {
  Status status;
  SourcePlace place = place_of(reader, reader->event.start_mark);
  TRY(refuse_decorations(reader, error));
  if (depth > YAML_TREE_DEPTH)
    TRY(place_error(&place, error, "expected at most %d levels, found one more", YAML_TREE_DEPTH));
  YamlKind kind = reader->event.type == YAML_SCALAR_EVENT           ? YAML_TREE_TEXT
                  : reader->event.type == YAML_SEQUENCE_START_EVENT ? YAML_TREE_LIST
                                                                    : YAML_TREE_MAPPING;
  *out = yaml_tree_new(kind, place, error);
  if (!*out) return error->code;
  switch (kind) {
  case YAML_TREE_TEXT:
    return copy_scalar(reader, &(*out)->text, error);
  case YAML_TREE_LIST:
    return read_items(reader, depth + 1, *out, error);
  case YAML_TREE_MAPPING:
    return read_entries(reader, depth + 1, *out, error);
  }
cleanup:
  return status;
}

/* The whole stream: exactly one document. */
static Status read_stream(Reader *reader, YamlNode **root, Error *error) {
  Status status;
  SourcePlace place;
  TRY(next(reader, error)); /* start of the stream */
  TRY(next(reader, error));
  place = place_of(reader, reader->event.start_mark);
  if (reader->event.type == YAML_STREAM_END_EVENT)
    TRY(place_error(&place, error, "expected a value, found nothing"));
  TRY(next(reader, error));
  TRY(read_node(reader, 1, root, error));
  TRY(next(reader, error)); /* end of the document */
  TRY(next(reader, error));
  place = place_of(reader, reader->event.start_mark);
  if (reader->event.type != YAML_STREAM_END_EVENT)
    TRY(place_error(&place, error, "expected one document, found a second one"));
cleanup:
  return status;
}

static Status check_bytes(const char *file, bool located, const char *bytes, size_t length, Error *error) {
  SourcePlace place = {file, located, located};
  if (length > YAML_TREE_BYTES)
    return place_error(&place, error, "expected at most %d bytes, found %zu", YAML_TREE_BYTES, length);
  size_t good = utf8_printable(bytes, length);
  if (good == length) return STATUS_OK;
  for (size_t i = 0; located && i < good; i++) {
    bool starts = ((unsigned char)bytes[i] & 0xC0) != 0x80; /* columns count characters, not bytes */
    place.column = bytes[i] == '\n' ? 1 : place.column + starts;
    place.line += bytes[i] == '\n';
  }
  return place_error(&place, error, "expected printable UTF-8 text, found the byte 0x%02X",
                     (unsigned char)bytes[good]);
}

Status yaml_tree_parse(YamlNode **root, const char *file, bool located, const char *bytes, size_t length,
                       Error *error) {
  static const char MARK[] = "\xEF\xBB\xBF"; /* some editors put it in front of UTF-8 */
  *root = NULL;
  if (length >= 3 && memcmp(bytes, MARK, 3) == 0) {
    bytes += 3;
    length -= 3;
  }
  Status status = check_bytes(file, located, bytes, length, error);
  if (status != STATUS_OK) return status;
  Reader reader = {.file = file, .located = located};
  if (!yaml_parser_initialize(&reader.parser))
    return error_set(error, STATUS_MEMORY, "out of memory: %s cannot be parsed", file);
  yaml_parser_set_encoding(&reader.parser, YAML_UTF8_ENCODING);
  yaml_parser_set_input_string(&reader.parser, (const unsigned char *)bytes, length);
  status = read_stream(&reader, root, error);
  yaml_event_delete(&reader.event);
  yaml_parser_delete(&reader.parser);
  if (status != STATUS_OK) {
    yaml_tree_free(*root);
    *root = NULL;
  }
  return status;
}

void yaml_tree_free(YamlNode *node) {
  if (!node) return;
  for (size_t i = 0; i < node->count; i++) yaml_tree_free(node->items[i]);
  array_free(node->items);
  array_free(node->text);
  array_free(node->key);
  array_free(node);
}

Status yaml_tree_copy(YamlNode **copy, const YamlNode *node, Error *error) {
  Status status = STATUS_OK;
  YamlNode *item = NULL;
  *copy = yaml_tree_new(node->kind, node->place, error);
  if (!*copy) return error->code;
  if (node->text && !((*copy)->text = text_copy(node->text, error))) TRY(error->code);
  for (size_t i = 0; i < node->count; i++) {
    const YamlNode *original = node->items[i];
    TRY(yaml_tree_copy(&item, original, error));
    TRY(original->key ? yaml_tree_insert(*copy, original->key, original->key_place, item, error)
                      : append(*copy, item, error));
    item = NULL;
  }
  return STATUS_OK;
cleanup:
  yaml_tree_free(item);
  yaml_tree_free(*copy);
  *copy = NULL;
  return status;
}

YamlNode *yaml_tree_find(const YamlNode *mapping, const char *key) {
  for (size_t i = 0; i < mapping->count; i++)
    if (strcmp(mapping->items[i]->key, key) == 0) return mapping->items[i];
  return NULL;
}

YamlNode *yaml_tree_new(YamlKind kind, SourcePlace place, Error *error) {
  YamlNode *node;
  if (ARRAY_NEW(&node, 1, error) != STATUS_OK) return NULL;
  node->kind = kind;
  node->place = place;
  return node;
}

Status yaml_tree_insert(YamlNode *mapping, const char *key, SourcePlace place, YamlNode *value,
                        Error *error) {
  char *copy = text_copy(key, error);
  if (!copy) return error->code;
  Status status = append(mapping, value, error);
  if (status != STATUS_OK) {
    array_free(copy);
    return status;
  }
  value->key = copy;
  value->key_place = place;
  return STATUS_OK;
}

void yaml_tree_remove(YamlNode *mapping, const char *key) {
  for (size_t i = 0; i < mapping->count; i++) {
    if (strcmp(mapping->items[i]->key, key) != 0) continue;
    yaml_tree_free(mapping->items[i]);
    mapping->count--;
    memmove(mapping->items + i, mapping->items + i + 1, (mapping->count - i) * sizeof *mapping->items);
    return;
  }
}

YamlFound yaml_tree_found(const YamlNode *node) {
  YamlFound found;
  switch (node->kind) {
  case YAML_TREE_LIST:
    snprintf(found.text, sizeof found.text, "a list");
    break;
  case YAML_TREE_MAPPING:
    snprintf(found.text, sizeof found.text, "a mapping");
    break;
  case YAML_TREE_TEXT: {
    int length = (int)utf8_cut(node->text, 40);
    const char *rest = node->text[length] ? "..." : "";
    snprintf(found.text, sizeof found.text, *node->text ? "`%.*s%s`" : "nothing", length, node->text, rest);
  }
  }
  return found;
}
