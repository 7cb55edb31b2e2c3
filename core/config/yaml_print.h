/* YAML text from what was read: single values, and whole trees. */
#ifndef CAPSELLA_CONFIG_YAML_PRINT_H
#define CAPSELLA_CONFIG_YAML_PRINT_H

#include "base/text.h"
#include "config/yaml_tree.h"

/* A text as a scalar, in quotes only where it needs them. */
Status yaml_print_text(const char *value, Text *yaml, Error *error);

/* A node on one line: `[0, {t: 1}]`. */
Status yaml_print_inline(const YamlNode *node, Text *yaml, Error *error);

/* A mapping as a file: one entry a line, nested ones indented; lists on one line. */
Status yaml_print_file(const YamlNode *mapping, Text *yaml, Error *error);

#endif
