/* The C interface: figures, fields and elements of the current state. */
#include "api/capsella_handle.h"

#include <math.h>
#include <string.h>

enum { MAX_NAMES = 64 };

/* The entry of names[0..count) that is `name`, or `count`. */
static size_t find(const char *(*name_of)(size_t), const char *name) {
  size_t k = 0;
  while (name_of(k) && strcmp(name_of(k), name) != 0) k++;
  return k;
}

static CapsellaStatus refuse_name(Capsella *capsella, const char *what, const char *(*name_of)(size_t),
                                  const char *name) {
  const char *names[MAX_NAMES];
  size_t count = 0;
  while (count < MAX_NAMES && name_of(count)) {
    names[count] = name_of(count);
    count++;
  }
  const char *nearest = text_nearest(name, names, count);
  return handle_refuse(capsella, "expected the name of a %s, found `%s`%s%s%s", what, name,
                       nearest ? "; the nearest is `" : "", nearest ? nearest : "", nearest ? "`" : "");
}

/* ---- figures ---- */

/* Those that are not columns of a history. */
static const char *const more_scalars[] = {"t_c",
                                           "t_l",
                                           "volume_error_max",
                                           "energy_error_max",
                                           "capillary_number",
                                           "steps",
                                           "rejected_steps",
                                           "length_scale",
                                           "time_scale",
                                           "tension_scale"};

static double more_value(const Capsella *capsella, size_t k) {
  const Simulation *s = &capsella->simulation;
  const RecordData *data = &capsella->record.data;
  const bool flows = !simulation_is_inflation(s), physical = capsella->scene.flow.is_physical;
  const double values[] = {data->t_c,
                           data->t_l,
                           flows ? data->volume_error_max : NAN,
                           data->energy_error_max,
                           flows ? capsella->scene.flow.capillary_number : NAN,
                           (double)s->motion->steps(s->motion),
                           (double)s->motion->rejected(s->motion),
                           physical ? s->scales.length : NAN,
                           physical ? s->scales.time : NAN,
                           physical ? capsella->scene.flow.shear_modulus.value : NAN};
  _Static_assert(sizeof values / sizeof *values == sizeof more_scalars / sizeof *more_scalars,
                 "one value for each name");
  return values[k];
}

const char *capsella_scalar_name(size_t index) {
  const size_t columns = history_columns(HISTORY_INFLATION);
  if (index < columns) return history_column(index);
  index -= columns;
  return index < sizeof more_scalars / sizeof *more_scalars ? more_scalars[index] : NULL;
}

static Status read_row(Capsella *capsella) {
  Status status = STATUS_OK;
  Shape shape;
  if (capsella->row_t == capsella_time(capsella)) return STATUS_OK;
  TRY(handle_look(capsella));
  TRY(record_row(&capsella->record, &capsella->row, &shape, &capsella->error));
  capsella->row_t = capsella->row.t;
cleanup:
  return status;
}

CapsellaStatus capsella_scalar(Capsella *capsella, const char *name, double *value) {
  Status status = STATUS_OK;
  if (handle_need_scene(capsella) != CAPSELLA_OK) return CAPSELLA_USAGE;
  const size_t k = find(capsella_scalar_name, name), columns = history_columns(HISTORY_INFLATION);
  const bool flows = !simulation_is_inflation(&capsella->simulation);
  if (!capsella_scalar_name(k)) return refuse_name(capsella, "figure", capsella_scalar_name, name);
  if (k >= columns) {
    *value = more_value(capsella, k - columns);
  } else if (flows && k >= history_columns(HISTORY_FLOW)) {
    *value = NAN;
  } else {
    TRY(read_row(capsella));
    *value = history_value(&capsella->row, k);
  }
cleanup:
  return handle_result(status);
}

/* ---- fields ---- */

typedef enum { FIELD_X0, FIELD_X, FIELD_VELOCITY, FIELD_LOAD, FIELD_D, FIELD_Y, FIELD_T1, FIELD_T2 } Field;
static const char *const fields[] = {"X", "x", "velocity", "q", "d", "Y", "T1", "T2"};

const char *capsella_field_name(size_t index) {
  return index < sizeof fields / sizeof *fields ? fields[index] : NULL;
}

/* OK where `count` numbers may be copied. */
static CapsellaStatus need_room(Capsella *capsella, const char *what, size_t capacity, size_t count) {
  if (capacity >= count) return CAPSELLA_OK;
  return handle_refuse(capsella, "%s: expected room for %zu numbers, found %zu", what, count, capacity);
}

static Status measure_nodal(Capsella *capsella) {
  const double t = capsella_time(capsella);
  if (capsella->nodal_t == t) return STATUS_OK;
  const Status status = handle_look(capsella);
  if (status != STATUS_OK) return status;
  nodal_fields_measure(&capsella->nodal, &capsella->simulation);
  capsella->nodal_t = t;
  return STATUS_OK;
}

/* The field as it lies in memory; q in the units of the law. */
static Status look_at(Capsella *capsella, Field field, const double **values) {
  Status status = STATUS_OK;
  const Record *record = &capsella->record;
  const NodalFields *nodal = &capsella->nodal;
  const Simulation *s = &capsella->simulation;
  const double *const at[] = {s->mesh.X, record->x, record->v, s->motion->q,
                              nodal->d,  nodal->Y,  nodal->T1, nodal->T2};
  TRY(field >= FIELD_D ? measure_nodal(capsella) : handle_look(capsella));
  *values = at[field];
cleanup:
  return status;
}

CapsellaStatus capsella_field(Capsella *capsella, const char *name, double *values, size_t capacity,
                              size_t *count) {
  Status status = STATUS_OK;
  if (handle_need_scene(capsella) != CAPSELLA_OK) return CAPSELLA_USAGE;
  const size_t k = find(capsella_field_name, name);
  if (!capsella_field_name(k)) return refuse_name(capsella, "field", capsella_field_name, name);
  const size_t n = (size_t)capsella->simulation.mesh.n_nodes * (k >= FIELD_D ? 1 : 3);
  if (count) *count = n;
  if (!values) return CAPSELLA_OK;
  if (need_room(capsella, name, capacity, n) != CAPSELLA_OK) return CAPSELLA_USAGE;
  const double *from, unit = k == FIELD_LOAD ? capsella->simulation.material.shear_modulus : 1;
  TRY(look_at(capsella, (Field)k, &from));
  for (size_t i = 0; i < n; i++) values[i] = from[i] / unit;
cleanup:
  return handle_result(status);
}

CapsellaStatus capsella_elements(Capsella *capsella, int *nodes, size_t capacity, size_t *count) {
  if (handle_need_scene(capsella) != CAPSELLA_OK) return CAPSELLA_USAGE;
  const Mesh *mesh = &capsella->simulation.mesh;
  const size_t n = 6 * (size_t)mesh->n_elements;
  if (count) *count = n;
  if (!nodes) return CAPSELLA_OK;
  if (need_room(capsella, "elements", capacity, n) != CAPSELLA_OK) return CAPSELLA_USAGE;
  memcpy(nodes, mesh->element, n * sizeof *nodes);
  return CAPSELLA_OK;
}
