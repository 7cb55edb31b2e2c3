/* Parameter values of one law: what a scene says against the table of the law. */
#ifndef CAPSELLA_LAWS_PARAMETERS_H
#define CAPSELLA_LAWS_PARAMETERS_H

#include "base/log.h"
#include "base/status.h"
#include "config/scene.h"
#include "laws/field.h"
#include "laws/plugin.h"

/* The parameters of one law, dimensionless. */
typedef struct {
  uint32_t n;
  double *value;    /* [n]; of one that varies over the membrane, its mean over the surface at rest */
  double **element; /* [n] values at the elements, [n_elements] in the order of the mesh; NULL: uniform */
  bool varies;      /* some `element` is not NULL */
} ParameterValues;

/* The scene's quantities with their unit taken off by `scales` (NULL: the scene has none, and a quantity with
 * a unit is refused), its fields laid over `place` (NULL: there is nothing to lay them over, and a field is
 * refused), defaults where the scene is silent.  Then, in this order and for every element: hard ranges
 * (refused), the law's own check across parameters (refused), calibrated ranges (one warning each in `log`).
 * STATUS_INPUT: "file:line:column: expected, found". */
Status law_parameters(const LawDescription *law, const SceneLaw *scene, const LawScales *scales,
                      const FieldPlace *place, Log *log, ParameterValues *values, Error *error);
void parameter_values_free(ParameterValues *values);

/* Value of parameter k at an element; -1: its mean. */
double parameter_at(const ParameterValues *values, uint32_t k, int element);

#endif
