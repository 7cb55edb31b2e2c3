/* Reading one entry of a study file, with messages that name its place. */
#ifndef CAPSELLA_STUDY_ENTRY_H
#define CAPSELLA_STUDY_ENTRY_H

#include "config/yaml_tree.h"

/* STATUS_INPUT when the mapping holds a key that is in neither list; both end in NULL, `more` may be NULL. */
Status entry_check_keys(const YamlNode *mapping, const char *const *keys, const char *const *more,
                        Error *error);

/* STATUS_INPUT, naming the key, when the mapping does not hold it. */
Status entry_find(const YamlNode *mapping, const char *key, const char *expected, const YamlNode **node,
                  Error *error);

/* A node as text, as a number, as a whole number from `low` on; `name` is what messages call it. */
Status entry_text(const YamlNode *node, const char *name, const char **text, Error *error);
Status entry_number(const YamlNode *node, const char *name, double *value, Error *error);
Status entry_count(const YamlNode *node, const char *name, int low, int *value, Error *error);

/* Position of a node's text in a list of words that ends in NULL. */
Status entry_choice(const YamlNode *node, const char *name, const char *const *words, int *choice,
                    Error *error);

#endif
