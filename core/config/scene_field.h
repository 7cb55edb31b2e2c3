/* Parameters of a law that vary over the membrane, as a scene says it:
 *
 *     Y_C: {around: P, radius: 0.3, inside: 1.0, outside: 2.0}              a spot; or around: [x, y, z]
 *     Y_C: {file: strengths.txt}                                           one number for each element
 *     Y_C: {weibull: {mean: 2.0, modulus: 8}, seed: 7, correlation: 0.2}   random scatter
 *
 * One table says which keys each kind has; reading, printing, messages and the manual are made from it.  What
 * values the elements get is the work of laws/field.h. */
#ifndef CAPSELLA_CONFIG_SCENE_FIELD_H
#define CAPSELLA_CONFIG_SCENE_FIELD_H

#include "base/status.h"
#include "base/text.h"
#include "config/place.h"
#include "config/units.h"
#include "config/yaml_tree.h"
#include <stdbool.h>
#include <stdint.h>

typedef enum {
  FIELD_AROUND,
  FIELD_FILE,
  FIELD_WEIBULL,
  FIELD_NORMAL,
  FIELD_LOG_NORMAL,
  FIELD_UNIFORM, /* random, between two ends */
  FIELD_KINDS
} FieldKind;

/* A quantity whose value is NAN was not given. */
typedef struct SceneField {
  FieldKind kind;
  SourcePlace place;

  /* FIELD_AROUND */
  bool around_P;    /* the point where the vorticity axis leaves the capsule */
  double center[3]; /* otherwise */
  double radius;
  Quantity inside, outside;

  /* FIELD_FILE */
  char *file;
  Quantity times; /* what the numbers of the file are multiplied by */
  bool has_hash;  /* the file must have this content: */
  uint64_t hash;

  /* Scatter */
  Quantity mean, scale, deviation, from, to;
  double modulus;
  long long seed;
  double correlation; /* length over which values are alike; 0: every element for itself */
} SceneField;

/* Reads a mapping; `key` is the parameter with dots, for messages.  STATUS_INPUT with the place of what is
 * wrong.  The caller frees *field with scene_field_free, also after a failure. */
Status scene_field_read(SceneField **field, const YamlNode *node, const char *key, Error *error);
void scene_field_free(SceneField *field);

/* On one line, so that scene_field_read gives the same bits. */
Status scene_field_print(const SceneField *field, Text *yaml, Error *error);

/* The kinds and their keys as a table in Markdown. */
Status scene_field_print_manual(Text *markdown, Error *error);

#endif
