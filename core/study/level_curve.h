/* A quantity that rises along a key, known at a few values: where does it pass a level?
 *
 * Between samples ln(quantity) is taken against ln(key), by the line through the two samples around the level
 * and by the parabola through a third one: the parabola's root is the answer, the distance of the two roots
 * bounds its error with room to spare.  The answer stays between the two samples. */
#ifndef CAPSELLA_STUDY_LEVEL_CURVE_H
#define CAPSELLA_STUDY_LEVEL_CURVE_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct {
  double *x, *y; /* [n] x rising, both above 0 */
  size_t n, capacity;
} LevelCurve;

typedef struct {
  double x, error;  /* NAN: the level is not passed between samples */
  double low, high; /* the samples around it; NAN: none on that side */
} LevelCrossing;

/* Adds a sample; one at the same x is replaced. */
Status level_curve_add(LevelCurve *curve, double x, double y, Error *error);
void level_curve_free(LevelCurve *curve);

/* The first crossing from below. */
LevelCrossing level_curve_cross(const LevelCurve *curve, double level);

#endif
