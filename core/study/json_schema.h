/* JSON Schemas (draft 2020-12) of a scene and of a study, by which editors complete and check while one
 * types. They are printed from the tables that read the files.  What hangs on other keys stays with the
 * reader: a file that fits its schema may still be refused, but none that the program takes is refused by the
 * schema. */
#ifndef CAPSELLA_STUDY_JSON_SCHEMA_H
#define CAPSELLA_STUDY_JSON_SCHEMA_H

#include "base/status.h"
#include "base/text.h"

Status json_schema_scene(Text *text, Error *error);
Status json_schema_study(Text *text, Error *error);

#endif
