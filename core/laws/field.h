/* Values of a parameter that varies over the membrane, element by element (config/scene_field.h says how a scene
 * asks for them). */
#ifndef CAPSELLA_LAWS_FIELD_H
#define CAPSELLA_LAWS_FIELD_H

#include "base/status.h"
#include "config/scene_field.h"
#include "laws/scales.h"
#include "mesh/mesh.h"
#include <stdbool.h>

/* What fields are laid over. */
typedef struct {
  const Mesh *mesh;
  double P[3]; /* where the vorticity axis leaves the capsule at rest */
} FieldPlace;

/* value [n_elements], dimensionless, whatever the range of the parameter.  STATUS_INPUT or STATUS_IO without
 * the place in the scene. */
Status field_sample(const SceneField *field, const mlaw_param *param, const LawScales *scales,
                    const FieldPlace *place, double *value, Error *error);

/* Mean over the surface at rest; exact when all values are the same. */
double field_mean(const double *value, const Mesh *mesh);

/* Whether all values are the same. */
bool field_is_uniform(const double *value, int n);

/* Ties a field to the content of its file: the path, relative to `folder`, becomes absolute, and the hash of
 * the file is noted or, where it was given, compared.  Other fields are left alone. */
Status field_pin(SceneField *field, const char *folder, Error *error);

#endif
