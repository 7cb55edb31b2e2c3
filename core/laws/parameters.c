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

/* ---- Units ---- */

/* The usual name of a unit with these exponents of kg, m, s, or their product. */
static const char *unit_name(const signed char dim[4], char *buffer, size_t size) {
  static const struct {
    signed char dim[4];
    const char *name;
  } known[] = {{{0, 0, 0}, "a number without unit"},
               {{1, 0, -2}, "N/m"},
               {{1, -1, -2}, "Pa"},
               {{1, 1, -2}, "N"},
               {{1, 2, -2}, "J"},
               {{0, 1, 0}, "m"},
               {{0, 0, 1}, "s"},
               {{0, 0, -1}, "1/s"},
               {{1, -1, -1}, "Pa s"},
               {{1, 0, 0}, "kg"},
               {{0, 1, -1}, "m/s"}};
  for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
    if (units_agree(known[k].dim, dim)) return known[k].name;
  }
  snprintf(buffer, size, "kg^%d m^%d s^%d", dim[0], dim[1], dim[2]);
  return buffer;
}

static Status without_unit(const mlaw_param *param, const Quantity *quantity, const LawScales *scales,
                           double *value, Error *error) {
  char buffer[64];
  *value = quantity->value;
  if (!quantity->has_unit) return STATUS_OK;
  if (!units_agree(param->dim, quantity->dim)) {
    return error_set(error, STATUS_INPUT, "expected %s, found %s",
                     strcmp(param->unit, "1") == 0 ? "a number without unit" : param->unit,
                     unit_name(quantity->dim, buffer, sizeof buffer));
  }
  if (!scales) {
    return error_set(error, STATUS_INPUT,
                     "expected a number without unit, since the scene gives no physical scales, found %s",
                     unit_name(quantity->dim, buffer, sizeof buffer));
  }
  *value /= pow(scales->mass, param->dim[0]) * pow(scales->length, param->dim[1]) *
            pow(scales->time, param->dim[2]);
  return STATUS_OK;
}

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

static void warn_outside_calibration(const LawDescription *law, const mlaw_param *param, double value,
                                     const SourcePlace *place, Log *log) {
  if (value >= param->ok_lo && value <= param->ok_hi) return;
  Error message;
  error_set(&message, STATUS_OK, "parameter %s = %g is outside %g .. %g, where law %s was calibrated",
            param->name, value, param->ok_lo, param->ok_hi, law->id);
  place_prefix(place, &message);
  log_warning(log, "%s", message.text);
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

static Status fill_in(const LawDescription *law, const SceneLaw *scene, uint32_t k, const LawScales *scales,
                      double *value, Error *error) {
  const mlaw_param *param = law_param(law, k);
  const SceneParameter *given = find_in_scene(scene, param->name);
  if (!given) {
    *value = param->value;
    return require(law, param, error) == STATUS_OK ? STATUS_OK : place_prefix(&scene->place, error);
  }
  Status status = without_unit(param, &given->value, scales, value, error);
  if (status == STATUS_OK) status = check_range(param, *value, error);
  if (status == STATUS_OK) return STATUS_OK;
  error_prefix(error, "parameter %s of law %s: ", param->name, law->id);
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

static Status check_across(const LawDescription *law, const SceneLaw *scene, const double *value,
                           Error *error) {
  mlaw_error err = {.point = -1};
  if (!law->check || law->check(value, &err) == MLAW_OK) return STATUS_OK;
  err.text[sizeof err.text - 1] = '\0';
  error_set(error, STATUS_INPUT, "law %s refuses its parameters: %s", law->id, err.text);
  return place_prefix(&scene->place, error);
}

Status law_parameters(const LawDescription *law, const SceneLaw *scene, const LawScales *scales, Log *log,
                      double *value, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < scene->n_parameters; i++) TRY(refuse_unknown(law, &scene->parameters[i], error));
  for (uint32_t k = 0; k < law->n_params; k++) TRY(fill_in(law, scene, k, scales, &value[k], error));
  TRY(check_across(law, scene, value, error));
  for (uint32_t k = 0; k < law->n_params; k++) {
    const mlaw_param *param = law_param(law, k);
    const SceneParameter *given = find_in_scene(scene, param->name);
    warn_outside_calibration(law, param, value[k], given ? &given->place : &scene->place, log);
  }
cleanup:
  return status;
}
