/* What a threshold study is to find: the value of a key at which a condition on the run begins to hold.
 *
 *     find: [Ca_c, Ca_l, {name: Ca_half, when: d_max, above: 0.3}, {name: G, key: ..., when: ruptured}] */
#ifndef CAPSELLA_STUDY_TARGET_H
#define CAPSELLA_STUDY_TARGET_H

#include "study/runner.h"

typedef enum { WHEN_DAMAGED, WHEN_RUPTURED, WHEN_ABOVE } TargetCondition;

typedef struct {
  const char *name, *key; /* owned by the tree, or constant */
  TargetCondition condition;
  const char *figure; /* WHEN_ABOVE: of summary.json */
  double above;
} Target;

/* Reads one entry of `find`. */
Status target_read(const YamlNode *node, Target *target, Error *error);

/* Whether the condition held in a case that has ended well: for the membrane itself (`where` NULL), or for a
 * criterion that looked on, damage and rupture being told in its entry of the summary ("criteria.2."). */
bool target_holds(const Target *target, const Case *item, const char *where);

#endif
