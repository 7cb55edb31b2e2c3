/* What a membrane of a material does in the three homogeneous stretches of textbooks, for pictures: tensions
 * along a stretch, and damage along a path of stretches. */
#ifndef CAPSELLA_LAWS_CURVES_H
#define CAPSELLA_LAWS_CURVES_H

#include "laws/material.h"

typedef enum {
  STRETCH_UNIAXIAL,    /* no tension across */
  STRETCH_EQUIBIAXIAL, /* the same in both directions */
  STRETCH_PURE_SHEAR,  /* none across (l2 = 1): the "pure shear" of a strip held at its long edges */
  N_STRETCHES
} StretchMode;

/* Principal tensions T[2] of the undamaged membrane with stretches l[2], the history at its start; T[0]
 * belongs to l[0].  STATUS_REJECT where the law has no answer. */
Status curve_tensions(const Material *material, const double l[2], double T[2], Error *error);

/* Both stretches [2] of a mode, given the one along.  STATUS_REJECT where the law has no answer. */
Status curve_stretches(const Material *material, StretchMode mode, double along, double l[2], Error *error);

/* One state of a membrane that is stretched in pure shear. */
typedef struct {
  double stretch, d;
  double tension;                  /* along, of the damaged membrane */
  double channel[MLAW_N_CHANNELS]; /* of the undamaged one */
  double threshold;                /* the Y that it withstands without more damage; NAN: a law of the general
                                      kind, or more than 1e6 */
} DamageState;

/* Damage along a path of stretches [n], from rest, each step taking |change of stretch|/rate of time; `state`
 * [n].  The material has a damage law. */
Status curve_damage(const Material *material, int n, const double *stretch, double rate, DamageState *state,
                    Error *error);

#endif
