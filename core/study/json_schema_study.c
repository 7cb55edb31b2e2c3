/* The keys that all kinds of study share, then one alternative for each kind. */
#include "study/json_schema_study.h"

#include "study/json_schema_scene.h"
#include "study/study.h"
#include <string.h>

/* The shapes of keys that only some kinds of study have; which, their readers say (StudyKind.keys). */
static const struct {
  const char *key, *schema;
} SHAPES[] = {
    {"snapshots", "{\"type\": \"boolean\", \"default\": false, \"description\": \"Whether the runs keep "
                  "snapshots along the way.\"}"},
    {"charts",
     "{\"type\": \"array\", \"description\": \"Charts to draw: figures at the end of the runs over the "
     "longest varied range, or columns of their histories over another.\", \"items\": {\"type\": "
     "\"object\", \"additionalProperties\": false, \"required\": [\"draw\"], \"properties\": {\"draw\": "
     "{\"type\": [\"string\", \"array\"], \"items\": {\"type\": \"string\"}, \"minItems\": 1}, \"over\": "
     "{\"type\": \"string\"}}}}"},
    {"find",
     "{\"type\": \"array\", \"minItems\": 1, \"description\": \"What is to be found: Ca_c, the onset of "
     "damage; Ca_l, rupture; or the value of a key where something begins to hold.\", \"items\": "
     "{\"anyOf\": [{\"enum\": [\"Ca_c\", \"Ca_l\"]}, {\"type\": \"object\", \"additionalProperties\": "
     "false, \"required\": [\"name\", \"when\"], \"properties\": {\"name\": {\"type\": \"string\"}, "
     "\"key\": {\"type\": \"string\", \"default\": \"flow.capillary_number\"}, \"when\": {\"type\": "
     "\"string\", \"description\": \"damaged, ruptured, or a figure of summary.json\"}, \"above\": "
     "{\"type\": \"number\"}}}]}}"},
    {"bracket",
     "{\"type\": \"array\", \"items\": {\"type\": \"number\", \"exclusiveMinimum\": 0}, \"minItems\": 2, "
     "\"maxItems\": 2, \"description\": \"[low, high]: where it is looked for.\"}"},
    {"tolerance",
     "{\"type\": \"number\", \"exclusiveMinimum\": 0, \"description\": \"Width of the bracket at the "
     "end.\"}"},
    {"mode",
     "{\"enum\": [\"passive\", \"coupled\"], \"default\": \"passive\", \"description\": \"passive: all "
     "criteria look on along one run; coupled: a run of its own for each, which weakens the membrane.\"}"},
    {"criteria",
     "{\"type\": \"array\", \"minItems\": 1, \"description\": \"The damage laws to compare; strength "
     "names the parameters that a calibration scales together.\", \"items\": {\"type\": \"object\", "
     "\"additionalProperties\": false, \"required\": [\"law\"], \"properties\": {\"name\": {\"type\": "
     "\"string\"}, \"law\": {\"type\": \"string\"}, \"parameters\": {\"$ref\": "
     "\"#/$defs/parameters\"}, \"strength\": {\"type\": \"array\", \"items\": {\"type\": "
     "\"string\"}}}}}"},
    {"confirm", "{\"type\": \"array\", \"items\": {\"type\": \"string\"}, \"description\": \"Criteria to be "
                "confirmed by runs in which they act on the membrane.\"}"},
    {"calibrate",
     "{\"type\": \"object\", \"additionalProperties\": false, \"minProperties\": 1, "
     "\"maxProperties\": 1, \"properties\": {\"Ca_c\": {\"type\": [\"number\", \"string\"]}, \"Ca_l\": "
     "{\"type\": [\"number\", \"string\"]}}, \"description\": \"Each criterion is first made so strong "
     "that damage begins (Ca_c) or the capsule ruptures (Ca_l) there; `scene`: at that of the scene.\"}"},
};
enum { N_SHAPES = sizeof SHAPES / sizeof *SHAPES };

/* A key that is not among them may hold anything. */
static const char *shape_of(const char *key) {
  for (int k = 0; k < N_SHAPES; k++)
    if (strcmp(SHAPES[k].key, key) == 0) return SHAPES[k].schema;
  return "true";
}

/* Keys of one kind beside those that all kinds share. */
static void study_kind(Json *json, const StudyKind *kind) {
  static const char *const shared[] = {"schema", "name", "scene", "vary"};
  json_open_object(json, NULL);
  json_boolean(json, "additionalProperties", false);
  json_open_object(json, "properties");
  json_open_object(json, "study");
  json_string(json, "const", kind->name);
  json_close(json);
  for (size_t i = 0; i < sizeof shared / sizeof *shared; i++) json_raw(json, shared[i], "true");
  for (const char *const *key = kind->keys; *key; key++) json_raw(json, *key, shape_of(*key));
  json_close(json);
  json_close(json);
}

/* A search takes all three. */
static const char TOGETHER[] = "{\"find\": [\"bracket\", \"tolerance\"], \"bracket\": [\"find\"], "
                               "\"tolerance\": [\"find\"]}";

static const char VARY[] =
    "{\"type\": \"object\", \"description\": \"Keys of the scene, with dots, and the values each takes: "
    "every "
    "combination is a case.\", \"additionalProperties\": {\"anyOf\": [{\"type\": \"array\", \"minItems\": "
    "1}, "
    "{\"type\": \"object\", \"additionalProperties\": false, \"required\": [\"from\", \"to\", \"count\"], "
    "\"properties\": {\"from\": {\"type\": \"number\"}, \"to\": {\"type\": \"number\"}, \"count\": "
    "{\"type\": "
    "\"integer\", \"minimum\": 2}}}]}}";

/* The keys of all kinds.  A scene inside a study may lack what the study puts in. */
static Status study_keys(Json *json, Error *error) {
  Status status = STATUS_OK;
  json_open_object(json, "properties");
  json_raw(json, "schema", "{\"const\": 1, \"description\": \"Version of this format.\"}");
  json_open_object(json, "study");
  json_string(json, "description", "The kind of study.");
  json_open_array(json, "enum");
  for (size_t i = 0; STUDY_KINDS[i]; i++) json_string(json, NULL, STUDY_KINDS[i]->name);
  json_close(json);
  json_close(json);
  json_raw(json, "name",
           "{\"type\": [\"string\", \"number\", \"boolean\"], \"description\": \"Name of the study, for "
           "the folder of its results; the file's without it.\"}");
  json_open_object(json, "scene");
  json_string(json, "description", "The base scene: the path of a file, or a scene.");
  json_open_array(json, "anyOf");
  json_raw(json, NULL, "{\"type\": \"string\"}");
  json_open_object(json, NULL);
  TRY(json_schema_scene_keys(json, false, error));
  json_close(json);
  json_close(json);
  json_close(json);
  json_raw(json, "vary", VARY);
  json_close(json);
cleanup:
  return status;
}

Status json_schema_study(Text *text, Error *error) {
  Status status;
  Json json;
  json_begin(&json, text, error);
  json_open_object(&json, NULL);
  json_string(&json, "$schema", JSON_SCHEMA_DIALECT);
  json_string(&json, "title", "A study of Capsella");
  json_string(&json, "type", "object");
  json_raw(&json, "required", "[\"schema\", \"study\", \"scene\"]");
  json_raw(&json, "dependentRequired", TOGETHER);
  TRY(study_keys(&json, error));
  json_open_array(&json, "oneOf");
  for (size_t i = 0; STUDY_KINDS[i]; i++) study_kind(&json, STUDY_KINDS[i]);
  json_close(&json);
  json_schema_definitions(&json);
  json_close(&json);
  TRY(json_end(&json));
cleanup:
  return status;
}
