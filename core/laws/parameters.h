/* Parameter values of one law: what a scene says against the table of the law. */
#ifndef CAPSELLA_LAWS_PARAMETERS_H
#define CAPSELLA_LAWS_PARAMETERS_H

#include "base/log.h"
#include "base/status.h"
#include "config/scene.h"
#include "laws/plugin.h"

/* What makes a dimensional quantity dimensionless. */
typedef struct {
  double mass, length, time; /* SI */
} LawScales;

/* value [n_params], dimensionless: the scene's quantities with their unit taken off by `scales`
 * (NULL: the scene has none, and a quantity with a unit is refused), defaults where the scene is silent.
 * Then, in this order: hard ranges (refused), the law's own check across parameters (refused), calibrated
 * ranges (one warning each in `log`).  STATUS_INPUT: "file:line:column: expected, found". */
Status law_parameters(const LawDescription *law, const SceneLaw *scene, const LawScales *scales, Log *log,
                      double *value, Error *error);

#endif
