#define _XOPEN_SOURCE 700 /* realpath */
#include "laws/field.h"

#include "base/array.h"
#include "base/file.h"
#include "base/vec3.h"
#include "laws/scatter.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Geometry ---- */

static void find_center(const Mesh *mesh, int e, double center[3]) {
  for (int c = 0; c < 3; c++) {
    center[c] = 0;
    for (int k = 0; k < 6; k++) /* the quadratic shape functions at the centre are -1/9 and 4/9 */
      center[c] += (k < 3 ? -1.0 : 4.0) / 9 * mesh->X[3 * mesh->element[e][k] + c];
  }
}

/* Of the flat triangle between the corners: enough for a weight. */
static double corner_area(const Mesh *mesh, int e) {
  const double *a = &mesh->X[3 * mesh->element[e][0]], *b = &mesh->X[3 * mesh->element[e][1]],
               *c = &mesh->X[3 * mesh->element[e][2]];
  double ab[3], ac[3], normal[3];
  vec3_subtract(b, a, ab);
  vec3_subtract(c, a, ac);
  vec3_cross(ab, ac, normal);
  return 0.5 * vec3_norm(normal);
}

double field_mean(const double *value, const Mesh *mesh) {
  double sum = 0, area = 0;
  for (int e = 0; e < mesh->n_elements; e++) {
    const double weight = corner_area(mesh, e);
    sum += weight * (value[e] - value[0]);
    area += weight;
  }
  return value[0] + sum / area;
}

bool field_is_uniform(const double *value, int n) {
  for (int e = 1; e < n; e++)
    if (value[e] != value[0]) return false;
  return true;
}

/* ---- A spot ---- */

static Status sample_spot(const SceneField *field, const mlaw_param *param, const LawScales *scales,
                          const FieldPlace *place, double *value, Error *error) {
  Status status;
  double inside, outside;
  const double *center = field->around_P ? place->P : field->center;
  TRY(law_quantity(param, &field->inside, scales, &inside, error));
  TRY(law_quantity(param, &field->outside, scales, &outside, error));
  for (int e = 0; e < place->mesh->n_elements; e++) {
    double point[3];
    find_center(place->mesh, e, point);
    value[e] = vec3_distance(point, center) <= field->radius ? inside : outside;
  }
cleanup:
  return status;
}

/* ---- A file ---- */

static const size_t LARGEST_FILE = (size_t)1 << 28;
static const char BLANKS[] = " \t\r\n,;";

/* Moves to the next number; false at the end. */
static bool find_number(const char **at, int *line) {
  for (;;) {
    for (; **at && strchr(BLANKS, **at); ++*at) *line += **at == '\n';
    if (**at != '#') return **at != '\0';
    *at += strcspn(*at, "\n");
  }
}

static Status read_number(const char *at, size_t length, const char *file, int line, double *value,
                          Error *error) {
  char token[64];
  Quantity quantity;
  Error why;
  snprintf(token, sizeof token, "%.*s", (int)(length < sizeof token ? length : sizeof token - 1), at);
  if (length < sizeof token && units_parse(token, &quantity, &why) == STATUS_OK && !quantity.has_unit) {
    *value = quantity.value;
    return STATUS_OK;
  }
  return error_set(error, STATUS_INPUT, "%s:%d: expected a number, found `%.40s`", file, line, token);
}

static Status sample_file(const SceneField *field, double times, int n, double *value, Error *error) {
  Status status;
  Text text = {0};
  int count = 0, line = 1;
  status = file_read(field->file, LARGEST_FILE, &text, error);
  if (status == STATUS_IO) error->code = status = STATUS_INPUT; /* a wrong path is wrong input */
  TRY(status);
  for (const char *at = text.data; find_number(&at, &line); count++) {
    const size_t length = strcspn(at, " \t\r\n,;#");
    double number;
    TRY(read_number(at, length, field->file, line, &number, error));
    if (count < n) value[count] = times * number;
    at += length;
  }
  if (count != n)
    TRY(error_set(error, STATUS_INPUT, "%s: expected %d numbers, one for each element, found %d", field->file,
                  n, count));
cleanup:
  text_free(&text);
  return status;
}

static Status compare_hash(const SceneField *field, uint64_t found, Error *error) {
  if (!field->has_hash || found == field->hash) return STATUS_OK;
  return error_set(error, STATUS_INPUT,
                   "%s: expected the content with hash %016" PRIx64 ", found another one (%016" PRIx64 ")",
                   field->file, field->hash, found);
}

Status field_pin(SceneField *field, const char *folder, Error *error) {
  if (field->kind != FIELD_FILE) return STATUS_OK;
  Status status;
  Text path = {0};
  char *absolute = NULL;
  uint64_t hash;
  TRY(file_join(&path, folder, field->file, error));
  absolute = file_exists(path.data) ? realpath(path.data, NULL) : NULL;
  if (!absolute) TRY(error_set(error, STATUS_INPUT, "%s: expected a file that can be read", path.data));
  array_free(field->file);
  if (!(field->file = text_copy(absolute, error))) TRY(error->code);
  TRY(file_hash(absolute, &hash, error));
  TRY(compare_hash(field, hash, error));
  field->hash = hash;
  field->has_hash = true;
cleanup:
  text_free(&path);
  free(absolute);
  return status == STATUS_OK ? status : place_prefix(&field->place, error);
}

/* ---- Scatter ---- */

/* The two numbers of a distribution, dimensionless. */
typedef struct {
  double first, second;
} Shape;

static Status expect(bool holds, const char *what, Error *error) {
  return holds ? STATUS_OK : error_set(error, STATUS_INPUT, "expected %s", what);
}

static Status read_shape(const SceneField *field, const mlaw_param *param, const LawScales *scales,
                         Shape *shape, Error *error) {
  Status status = STATUS_OK;
  const bool by_mean = !isnan(field->mean.value);
  switch (field->kind) {
  case FIELD_WEIBULL:
    TRY(law_quantity(param, by_mean ? &field->mean : &field->scale, scales, &shape->first, error));
    TRY(expect(shape->first > 0, by_mean ? "a mean above 0" : "a scale above 0", error));
    shape->second = field->modulus;
    if (by_mean) shape->first = scatter_weibull_scale(shape->first, shape->second);
    break;
  case FIELD_UNIFORM:
    TRY(law_quantity(param, &field->from, scales, &shape->first, error));
    TRY(law_quantity(param, &field->to, scales, &shape->second, error));
    TRY(expect(shape->first <= shape->second, "`from` not above `to`", error));
    break;
  default:
    TRY(law_quantity(param, &field->mean, scales, &shape->first, error));
    TRY(law_quantity(param, &field->deviation, scales, &shape->second, error));
    TRY(expect(shape->second >= 0, "a deviation of at least 0", error));
    if (field->kind == FIELD_LOG_NORMAL) TRY(expect(shape->first > 0, "a mean above 0", error));
  }
cleanup:
  return status;
}

static double value_of(FieldKind kind, Shape shape, double score) {
  switch (kind) {
  case FIELD_WEIBULL:
    return scatter_weibull(score, shape.first, shape.second);
  case FIELD_UNIFORM:
    return scatter_uniform(score, shape.first, shape.second);
  case FIELD_LOG_NORMAL:
    return scatter_log_normal(score, shape.first, shape.second);
  default:
    return scatter_normal(score, shape.first, shape.second);
  }
}

static Status sample_scatter(const SceneField *field, Shape shape, const Mesh *mesh, double *value,
                             Error *error) {
  double(*center)[3];
  Status status = ARRAY_NEW(&center, mesh->n_elements, error);
  if (status != STATUS_OK) return status;
  for (int e = 0; e < mesh->n_elements; e++) find_center(mesh, e, center[e]);
  TRY(scatter_scores(field->seed, field->correlation, mesh->n_elements, (const double(*)[3])center, value,
                     error));
  for (int e = 0; e < mesh->n_elements; e++) value[e] = value_of(field->kind, shape, value[e]);
cleanup:
  array_free(center);
  return status;
}

Status field_sample(const SceneField *field, const mlaw_param *param, const LawScales *scales,
                    const FieldPlace *place, double *value, Error *error) {
  Status status;
  double times;
  Shape shape;
  switch (field->kind) {
  case FIELD_AROUND:
    return sample_spot(field, param, scales, place, value, error);
  case FIELD_FILE:
    TRY(law_quantity(param, &field->times, scales, &times, error));
    return sample_file(field, times, place->mesh->n_elements, value, error);
  default:
    TRY(read_shape(field, param, scales, &shape, error));
    return sample_scatter(field, shape, place->mesh, value, error);
  }
cleanup:
  return status;
}
