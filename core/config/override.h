/* `--set KEY=VALUE` and the variations of a study: changes of a scene's tree before it is read. */
#ifndef CAPSELLA_CONFIG_OVERRIDE_H
#define CAPSELLA_CONFIG_OVERRIDE_H

#include "config/yaml_tree.h"

/* Puts `value`, a piece of YAML, under the key "a.b.c" as if it were written there: it replaces what stands
 * under the key, and mappings on the way that are missing are made.  An empty value removes the key. Messages
 * about it name `place`, whose file must outlive the tree. */
Status override_put(YamlNode *root, const char *key, const char *value, const SourcePlace *place,
                    Error *error);

/* The same for "a.b.c=value"; places name `source`, "--set KEY=VALUE", which must outlive the tree. */
Status override_apply(YamlNode *root, const char *setting, const char *source, Error *error);

#endif
