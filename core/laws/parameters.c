/* Scene values to parameters: names, units, ranges.  What the numbers mean is the law's affair. */
#include "laws/parameters.h"

#include "base/array.h"
#include "base/text.h"
#include "config/place.h"
#include "config/units.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* ---- Ranges ---- */

static Status check_range(const mlaw_param *param, double value, Error *error) {
  const bool open_lo = param->flags & MLAW_OPEN_LO, open_hi = param->flags & MLAW_OPEN_HI;
  const bool below = open_lo ? value <= param->lo : value < param->lo;
  const bool above = open_hi ? value >= param->hi : value > param->hi;
  if (!isfinite(value)) {
    error_set(error, STATUS_INPUT, "expected a finite number, found %g", value);
  } else if (below) {
    error_set(error, STATUS_INPUT, "expected %s %g, found %g", open_lo ? "more than" : "at least", param->lo,
              value);
  } else if (above) {
    error_set(error, STATUS_INPUT, "expected %s %g, found %g", open_hi ? "less than" : "at most", param->hi,
              value);
  } else {
    return STATUS_OK;
  }
  return error->code;
}

/* The same for every element. */
static Status check_field(const mlaw_param *param, const double *value, int n, Error *error) {
  for (int e = 0; e < n; e++)
    if (check_range(param, value[e], error) != STATUS_OK) return error_prefix(error, "element %d: ", e);
  return STATUS_OK;
}

static bool is_calibrated(const mlaw_param *param, double value) {
  return value >= param->ok_lo && value <= param->ok_hi;
}

static void warn(const LawDescription *law, const mlaw_param *param, double value, const char *where,
                 const SourcePlace *place, Log *log) {
  Error message;
  error_set(&message, STATUS_OK, "parameter %s = %g%s is outside %g .. %g, where law %s was calibrated",
            param->name, value, where, param->ok_lo, param->ok_hi, law->id);
  place_prefix(place, &message);
  log_warning(log, "%s", message.text);
}

static void warn_field(const LawDescription *law, const mlaw_param *param, const double *value, int n,
                       const SourcePlace *place, Log *log) {
  int first = -1, count = 0;
  char where[80];
  for (int e = 0; e < n; e++) {
    if (is_calibrated(param, value[e])) continue;
    if (first < 0) first = e;
    count++;
  }
  if (count == 0) return;
  snprintf(where, sizeof where, " in element %d, one of %d such,", first, count);
  warn(law, param, value[first], where, place, log);
}

/* ---- From scene to table ---- */

static const SceneParameter *find_in_scene(const SceneLaw *scene, const char *name) {
  for (size_t i = 0; i < scene->n_parameters; i++) {
    if (strcmp(scene->parameters[i].name, name) == 0) return &scene->parameters[i];
  }
  return NULL;
}

static Status require(const LawDescription *law, const mlaw_param *param, Error *error) {
  if (!(param->flags & MLAW_REQUIRED)) return STATUS_OK;
  return error_set(error, STATUS_INPUT, "law %s: expected the parameter %s (%s; unit %s), found none",
                   law->id, param->name, param->about, param->unit);
}

/* What the parameters of one law come from. */
typedef struct {
  const LawDescription *law;
  const SceneLaw *scene;
  const LawScales *scales;
  const FieldPlace *place;
  Log *log;
} Sources;

static void note_field(const Sources *from, const char *name, const double *value, int n, double mean) {
  int least = 0, most = 0;
  for (int e = 1; e < n; e++) {
    if (value[e] < value[least]) least = e;
    if (value[e] > value[most]) most = e;
  }
  log_note(from->log, "parameter %s of law %s varies from %g (element %d) to %g (element %d), mean %g", name,
           from->law->id, value[least], least, value[most], most, mean);
}

/* Values of parameter k at the elements; none are kept when they are all the same. */
static Status fill_field(const Sources *from, uint32_t k, const SceneField *field, ParameterValues *values,
                         Error *error) {
  Status status;
  const mlaw_param *param = law_param(from->law, k);
  if (!from->place) return error_set(error, STATUS_INPUT, "expected a number where there is no membrane");
  const Mesh *mesh = from->place->mesh;
  double **element = &values->element[k];
  TRY(ARRAY_NEW(element, mesh->n_elements, error));
  TRY(field_sample(field, param, from->scales, from->place, *element, error));
  TRY(check_field(param, *element, mesh->n_elements, error));
  values->value[k] = field_mean(*element, mesh);
  if (field_is_uniform(*element, mesh->n_elements)) {
    array_free(*element);
    *element = NULL;
  } else {
    values->varies = true;
    note_field(from, param->name, *element, mesh->n_elements, values->value[k]);
  }
cleanup:
  return status;
}

static Status fill_in(const Sources *from, uint32_t k, ParameterValues *values, Error *error) {
  const mlaw_param *param = law_param(from->law, k);
  const SceneParameter *given = find_in_scene(from->scene, param->name);
  double *value = &values->value[k];
  if (!given) {
    *value = param->value;
    return require(from->law, param, error) == STATUS_OK ? STATUS_OK
                                                         : place_prefix(&from->scene->place, error);
  }
  Status status;
  if (given->field) {
    status = fill_field(from, k, given->field, values, error);
  } else {
    status = law_quantity(param, &given->value, from->scales, value, error);
    if (status == STATUS_OK) status = check_range(param, *value, error);
  }
  if (status == STATUS_OK || status == STATUS_MEMORY) return status;
  error_prefix(error, "parameter %s of law %s: ", param->name, from->law->id);
  return place_prefix(&given->place, error);
}

static Status refuse_unknown(const LawDescription *law, const SceneParameter *given, Error *error) {
  Status status = STATUS_OK;
  Text all = {0};
  const char **names = array_allocate(law->n_params, sizeof *names, "parameter names", error);
  if (!names) return error->code;
  for (uint32_t k = 0; k < law->n_params; k++) {
    names[k] = law_param(law, k)->name;
    if (strcmp(names[k], given->name) == 0) goto cleanup;
  }
  for (uint32_t k = 0; k < law->n_params; k++) {
    TRY(text_append(&all, error, "%s%s", k ? ", " : "", names[k]));
  }
  const char *nearest = text_nearest(given->name, names, law->n_params);
  error_set(error, STATUS_INPUT, "law %s has no parameter `%s`%s%s%s; it has: %s", law->id, given->name,
            nearest ? " (did you mean `" : "", nearest ? nearest : "", nearest ? "`?)" : "",
            all.data ? all.data : "none");
  status = place_prefix(&given->place, error);
cleanup:
  text_free(&all);
  array_free(names);
  return status;
}

/* The law's own check of the parameters of one element; -1: of uniform ones. */
static Status check_across(const Sources *from, const ParameterValues *values, int element, double *scratch,
                           Error *error) {
  mlaw_error err = {.point = -1};
  for (uint32_t k = 0; k < values->n; k++) scratch[k] = parameter_at(values, k, element);
  if (from->law->check(scratch, &err) == MLAW_OK) return STATUS_OK;
  err.text[sizeof err.text - 1] = '\0';
  error_set(error, STATUS_INPUT, "law %s refuses its parameters: %s", from->law->id, err.text);
  if (element >= 0) error_prefix(error, "element %d: ", element);
  return place_prefix(&from->scene->place, error);
}

static Status check_all(const Sources *from, const ParameterValues *values, Error *error) {
  double *scratch = NULL;
  Status status = STATUS_OK;
  if (!from->law->check) return status;
  const int first = values->varies ? 0 : -1, last = values->varies ? from->place->mesh->n_elements - 1 : -1;
  TRY(ARRAY_NEW(&scratch, values->n, error));
  for (int e = first; e <= last; e++) TRY(check_across(from, values, e, scratch, error));
cleanup:
  array_free(scratch);
  return status;
}

static void warn_outside_calibration(const Sources *from, const ParameterValues *values) {
  for (uint32_t k = 0; k < values->n; k++) {
    const mlaw_param *param = law_param(from->law, k);
    const SceneParameter *given = find_in_scene(from->scene, param->name);
    const SourcePlace *place = given ? &given->place : &from->scene->place;
    if (values->element[k]) {
      warn_field(from->law, param, values->element[k], from->place->mesh->n_elements, place, from->log);
    } else if (!is_calibrated(param, values->value[k])) {
      warn(from->law, param, values->value[k], "", place, from->log);
    }
  }
}

Status law_parameters(const LawDescription *law, const SceneLaw *scene, const LawScales *scales,
                      const FieldPlace *place, Log *log, ParameterValues *values, Error *error) {
  Status status = STATUS_OK;
  const Sources from = {law, scene, scales, place, log};
  *values = (ParameterValues){.n = law->n_params};
  TRY(ARRAY_NEW(&values->value, law->n_params, error));
  TRY(ARRAY_NEW(&values->element, law->n_params, error));
  for (size_t i = 0; i < scene->n_parameters; i++) TRY(refuse_unknown(law, &scene->parameters[i], error));
  for (uint32_t k = 0; k < law->n_params; k++) TRY(fill_in(&from, k, values, error));
  TRY(check_all(&from, values, error));
  warn_outside_calibration(&from, values);
cleanup:
  if (status != STATUS_OK) parameter_values_free(values);
  return status;
}

void parameter_values_free(ParameterValues *values) {
  for (uint32_t k = 0; values->element && k < values->n; k++) array_free(values->element[k]);
  array_free(values->element);
  array_free(values->value);
  *values = (ParameterValues){0};
}

double parameter_at(const ParameterValues *values, uint32_t k, int element) {
  return element >= 0 && values->element[k] ? values->element[k][element] : values->value[k];
}
