/* One value of a scene by its row of the schema: read, print, free. */
#ifndef CAPSELLA_CONFIG_VALUE_H
#define CAPSELLA_CONFIG_VALUE_H

#include "config/schema.h"
#include "config/yaml_tree.h"

/* Reads a node into its member of the scene; STATUS_INPUT with the place when it is not what the row expects.
 */
Status value_read(const SchemaRow *row, const YamlNode *node, Scene *scene, Error *error);

/* Prints the member as YAML on one line, so that value_read gives the same bits. */
Status value_print(const SchemaRow *row, const Scene *scene, Text *yaml, Error *error);

/* Frees what value_read allocated and leaves the member empty. */
void value_free(const SchemaRow *row, Scene *scene);

#endif
