/* The criteria of a study `compare`, as its file lists them, and as the scenes of its cases need them. */
#ifndef CAPSELLA_STUDY_CONTENDER_H
#define CAPSELLA_STUDY_CONTENDER_H

#include "base/text.h"
#include "study/study.h"

/* {name: , law: , parameters: , strength: [names of parameters]}: parts of the study's tree. */
typedef struct {
  const char *name;
  const YamlNode *law, *parameters; /* parameters: NULL when left out */
  const YamlNode *strength;         /* the parameters that a calibration scales together; NULL: none */
} Contender;

/* contenders [*n], made by array_allocate.  STATUS_INPUT with the place of what is wrong; what a law says of
 * its parameters is left to the reader of a scene. */
Status contenders_read(const Study *study, Contender **contenders, size_t *n, Error *error);

/* Position of the contender with this name; STATUS_INPUT at `node` when there is none. */
Status contender_find(const Contender *contenders, size_t n, const YamlNode *node, size_t *found,
                      Error *error);

/* Appends a contender whose strength is multiplied by `scale`, as an entry of `observe.criteria` called
 * `name`, or (name NULL) as a value of `membrane.damage`. */
Status contender_print(const Contender *contender, const char *name, double scale, Text *yaml, Error *error);

#endif
