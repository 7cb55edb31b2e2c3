/* YAML text as a tree whose nodes know where they stand.
 *
 * The subset is what a scene needs: one document of mappings, lists and scalars.  Refused, with place:
 * duplicate keys, anchors and aliases, tags, a second document, keys that are not text, text that is not
 * printable UTF-8, and what is too large or too deep.  Scalars stay text: the schema says what they mean. */
#ifndef CAPSELLA_CONFIG_YAML_TREE_H
#define CAPSELLA_CONFIG_YAML_TREE_H

#include "base/status.h"
#include "config/place.h"
#include <stdbool.h>
#include <stddef.h>

enum { YAML_TREE_BYTES = 1 << 20, YAML_TREE_DEPTH = 32, YAML_TREE_KEYS = 1000 /* in one mapping */ };

typedef enum { YAML_TREE_TEXT, YAML_TREE_LIST, YAML_TREE_MAPPING } YamlKind;

typedef struct YamlNode YamlNode;
struct YamlNode {
  YamlKind kind;
  SourcePlace place; /* of the value */
  char *text;        /* of a scalar, "" for nothing; NULL otherwise */
  char *key;         /* name of this value in its mapping; NULL elsewhere */
  SourcePlace key_place;
  YamlNode **items; /* [count] entries of a list or a mapping, in order of appearance */
  size_t count, capacity;
};

/* Parses `bytes`; places name `file`, which must outlive the tree.  `located` false leaves line and column 0
 * (the value of a --set).  The caller frees *root with yaml_tree_free. */
Status yaml_tree_parse(YamlNode **root, const char *file, bool located, const char *bytes, size_t length,
                       Error *error);
void yaml_tree_free(YamlNode *node);

/* A copy of a node with all below it, without its key. */
Status yaml_tree_copy(YamlNode **copy, const YamlNode *node, Error *error);

/* The entry of a mapping with this key, or NULL. */
YamlNode *yaml_tree_find(const YamlNode *mapping, const char *key);

/* A new empty node without a key. */
YamlNode *yaml_tree_new(YamlKind kind, SourcePlace place, Error *error);

/* Puts `value` under a key that the mapping does not hold; the mapping owns it on success. */
Status yaml_tree_insert(YamlNode *mapping, const char *key, SourcePlace place, YamlNode *value, Error *error);

/* Removes and frees the entry with this key, if there is one. */
void yaml_tree_remove(YamlNode *mapping, const char *key);

/* What stands at a node, for "found ..." messages: "`text`" (cut when long), "a list", "a mapping",
 * "nothing".
 */
typedef struct {
  char text[64];
} YamlFound;
YamlFound yaml_tree_found(const YamlNode *node);

#endif
