/* Quantities of a scene as the dimensionless values of parameters. */
#ifndef CAPSELLA_LAWS_SCALES_H
#define CAPSELLA_LAWS_SCALES_H

#include "base/status.h"
#include "config/units.h"
#include <mlaw/mlaw.h>

/* What makes a dimensional quantity dimensionless. */
typedef struct {
  double mass, length, time; /* SI */
} LawScales;

/* A quantity as a value of this parameter; `scales` NULL: the scene has none, and a unit is refused.
 * STATUS_INPUT, without the place. */
Status law_quantity(const mlaw_param *param, const Quantity *quantity, const LawScales *scales, double *value,
                    Error *error);

#endif
