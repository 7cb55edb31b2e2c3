/* The JSON Schema (draft 2020-12) of a scene, by which editors complete and check while one types.  It is
 * printed from the table that reads the file.  What hangs on other keys stays with the reader: a file that
 * fits its schema may still be refused, but none that the program takes is refused by the schema. */
#ifndef CAPSELLA_STUDY_JSON_SCHEMA_SCENE_H
#define CAPSELLA_STUDY_JSON_SCHEMA_SCENE_H

#include "base/status.h"
#include "base/text.h"
#include "observe/json.h"
#include <stdbool.h>

Status json_schema_scene(Text *text, Error *error);

/* ---- parts that a study uses, too ---- */

extern const char JSON_SCHEMA_DIALECT[];

/* Adds the keys of a scene to an open object; `is_whole`: with those that must be there. */
Status json_schema_scene_keys(Json *json, bool is_whole, Error *error);

/* Adds what those keys refer to, as "$defs". */
void json_schema_definitions(Json *json);

#endif
