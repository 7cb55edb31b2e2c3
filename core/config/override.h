/* `--set KEY=VALUE`: changes of a scene's tree before it is read. */
#ifndef CAPSELLA_CONFIG_OVERRIDE_H
#define CAPSELLA_CONFIG_OVERRIDE_H

#include "config/yaml_tree.h"

/* Applies "a.b.c=value" to the tree as if the value were written there: it replaces what stands under the
 * key, and mappings on the way that are missing are made.  An empty value removes the key.  Places name
 * `source`, "--set KEY=VALUE", which must outlive the tree. */
Status override_apply(YamlNode *root, const char *setting, const char *source, Error *error);

#endif
