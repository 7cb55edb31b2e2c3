/* The table of all keys of a scene: reading, printing, messages and the manual are made from it. */
#ifndef CAPSELLA_CONFIG_SCHEMA_H
#define CAPSELLA_CONFIG_SCHEMA_H

#include "config/scene.h"

/* What a value is in the file -> in the Scene. */
typedef enum {
  TYPE_TEXT,       /* -> char * */
  TYPE_INTEGER,    /* -> int */
  TYPE_NUMBER,     /* -> double */
  TYPE_AUTOMATIC,  /* `auto` or a number -> double; companion: bool, true for `auto` */
  TYPE_BOOLEAN,    /* -> bool */
  TYPE_CHOICE,     /* one of `choices` -> enum, by position; companion (may be 0): SourcePlace */
  TYPE_QUANTITY,   /* number with a unit of dimension `dim` -> Quantity */
  TYPE_VECTOR,     /* [x, y, z] -> double[3] */
  TYPE_MATRIX,     /* three rows -> double[3][3] */
  TYPE_PATH,       /* [[t, value], ...] -> double (*)[2]; companion: size_t, number of points */
  TYPE_LAW,        /* name or path of a law -> law and place of a SceneLaw */
  TYPE_PARAMETERS, /* names to numbers or quantities -> parameters of a SceneLaw */
  TYPE_CRITERIA,   /* list of mappings {name, law, parameters} -> SceneCriterion *; companion: size_t */
  TYPE_GROUP,      /* a mapping that may be left out, with required keys in it -> bool: it was given */
} SchemaType;

/* In which scenes a key may stand.  There it is required when it has no default. */
typedef struct {
  bool (*holds)(const Scene *scene); /* asked when all rows above are read */
  const char *words;                 /* completes "where ..." */
} SchemaCondition;

typedef struct {
  const char *key; /* path with dots */
  SchemaType type;
  size_t offset, companion; /* in Scene; a companion of 0 is none */
  double low, high;
  bool above;                   /* low itself is excluded */
  const char *const *choices;   /* ends in NULL */
  signed char dim[4];           /* of a TYPE_QUANTITY */
  const char *example;          /* of a TYPE_QUANTITY */
  const char *fallback;         /* the default as YAML; NULL: none */
  const char *preset[3];        /* the default for each Accuracy instead of `fallback` */
  const SchemaCondition *where; /* NULL: in every scene */
  const char *meaning;          /* one sentence */
} SchemaRow;

/* The table, in the order of the manual and of resolved.yaml. */
extern const SchemaRow SCHEMA[];
extern const size_t SCHEMA_ROWS;

/* Names of an Accuracy, for the manual. */
extern const char *const SCHEMA_ACCURACY[];

/* Whether the row's key may stand in this scene (its `where` holds). */
bool schema_applies(const SchemaRow *row, const Scene *scene);

/* Whether the row's default depends on `accuracy`. */
bool schema_has_preset(const SchemaRow *row);

/* The default as YAML text; NULL when the key is required wherever it applies. */
const char *schema_default(const SchemaRow *row, Accuracy accuracy);

/* The row with this key, or NULL. */
const SchemaRow *schema_find(const char *key);

/* Whether `key` is a mapping of the scene: some row lies below it. */
bool schema_is_mapping(const char *key);

/* The key that an unknown one was most likely meant to be, appended to `suggestion`: a neighbour with a
 * similar name, else a key of the same name elsewhere, else one whose meaning defines it (Ca), else
 * nothing. */
Status schema_suggest(const char *key, Text *suggestion, Error *error);

/* What a row expects, in words: "a number above 0". */
Status schema_expected(const SchemaRow *row, Text *text, Error *error);

#endif
