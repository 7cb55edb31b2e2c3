/* What a damage law says by itself, before any run. */
#ifndef CAPSELLA_STUDY_ONSET_H
#define CAPSELLA_STUDY_ONSET_H

#include "laws/material.h"

typedef struct {
  double onset; /* the Y at which damage begins */
  double
      severity; /* the largest (1 - d(Y))^2 Y: the energy release rate of the sound membrane at which a point
                   under a given tension would give way, if the energy were quadratic in the strain. A scale
                   for the limit of a capsule, not its value; for d = (Y - Y_D)/Y_C it is
                   4 (Y_D + Y_C)^3 / (27 Y_C^2) */
} DamageOnset;

/* Asks a law in which damage is a function of the largest Y so far, with parameters that are the same
 * everywhere and whose drive is local; `known` is false for any other.  Values as Y_max in a summary: over
 * G_s. */
Status damage_onset(const Material *material, bool *known, DamageOnset *onset, Error *error);

#endif
