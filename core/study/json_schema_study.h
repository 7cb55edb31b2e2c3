/* The JSON Schema (draft 2020-12) of a study, with that of the scene in it. */
#ifndef CAPSELLA_STUDY_JSON_SCHEMA_STUDY_H
#define CAPSELLA_STUDY_JSON_SCHEMA_STUDY_H

#include "base/status.h"
#include "base/text.h"

Status json_schema_study(Text *text, Error *error);

#endif
