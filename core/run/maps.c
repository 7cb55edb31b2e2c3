#include "run/maps.h"

#include "base/array.h"
#include "base/vec3.h"
#include "mesh/surface.h"
#include "observe/shape.h"
#include "observe/sheet.h"
#include "observe/snapshot.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { FIELD_D, FIELD_Y, FIELD_T1, FIELD_T2, FIELD_T2_NEGATIVE, FIELD_LOAD };
const char *const MAPS_FIELDS[] = {"d", "Y", "T1", "T2", "T2-", "q.n", NULL};
static const char *const FIELD_LABELS[] = {"damage d",
                                           "energy release rate Y",
                                           "larger principal tension T1",
                                           "smaller principal tension T2",
                                           "negative part of T2",
                                           "normal load q.n"};

enum { VIEW_SHEAR, VIEW_TRANSVERSE, VIEW_FLOW, VIEW_REFERENCE };
const char *const MAPS_VIEWS[] = {"shear", "transverse", "flow", "reference", NULL};
static const char *const VIEW_LABELS[] = {"along the vorticity axis", "e_1 to the right, vorticity axis up",
                                          "flow to the right, vorticity axis up",
                                          "on the sphere at rest, along the vorticity axis"};

typedef struct {
  SnapshotGrid grid;
  Mesh mesh; /* nodes and elements of the grid */
  const double *x, *X;
  double *field[MAPS_MOST]; /* [n_fields][n_nodes] */
  PictureView transverse;
  char heading[128];
} State;

typedef struct {
  const MapsOptions *options;
  State state[MAPS_MOST];
  size_t n_states;
  SheetRow rows[MAPS_MOST * MAPS_MOST];
  char labels[MAPS_MOST * MAPS_MOST][128];
  SheetPanel panels[MAPS_MOST * MAPS_MOST * MAPS_MOST];
} Maps;

static Status find_name(const char *const *names, const char *what, const char *name, int *place,
                        Error *error) {
  for (*place = 0; names[*place]; ++*place)
    if (strcmp(names[*place], name) == 0) return STATUS_OK;
  return error_set(error, STATUS_INPUT, "expected a %s, one of `%s`, `%s`, ..., found `%s`", what, names[0],
                   names[1], name);
}

/* ---- Finding snapshots ---- */

/* The path of the snapshot that is nearest to time t. */
static Status find_nearest(const char *folder, double t, Text *path, Error *error) {
  Status status;
  int *numbers = NULL;
  size_t count;
  double nearest = INFINITY;
  Text candidate = {0};
  TRY(snapshot_list(folder, &numbers, &count, error));
  for (size_t k = 0; k < count; k++) {
    double time;
    candidate.length = 0;
    TRY(snapshot_path(&candidate, folder, numbers[k], error));
    TRY(snapshot_read_scene(candidate.data, NULL, &time, error));
    if (!(fabs(time - t) < nearest)) continue;
    nearest = fabs(time - t);
    path->length = 0;
    TRY(text_append(path, error, "%s", candidate.data));
  }
  if (!isfinite(nearest))
    status = error_set(error, STATUS_INPUT, "%s: expected snapshots, found none", folder);
cleanup:
  text_free(&candidate);
  array_free(numbers);
  return status;
}

static Status find_newest(const char *folder, Text *path, Error *error) {
  int number;
  const Status status = snapshot_find_newest(folder, path, &number, NULL, error);
  if (status != STATUS_OK || number >= 0) return status;
  return error_set(error, STATUS_INPUT, "%s: expected a snapshot of a run, found none that is whole", folder);
}

/* ---- A state ---- */

/* From e_1 to the right and the vorticity axis e_y up: along e_2. */
static Status aim_transverse(State *state, Error *error) {
  Shape shape;
  const Status status = shape_measure(&state->mesh, NULL, state->x, (const double[]){0, 1, 0}, &shape, error);
  if (status != STATUS_OK) return status;
  state->transverse = (PictureView){.up = {0, 1, 0}};
  vec3_cross(isnan(shape.beta) ? (const double[]){1, 0, 0} : shape.e1, state->transverse.up,
             state->transverse.toward);
  return STATUS_OK;
}

static Status load_along_normal(State *state, const double *q, double *values, Error *error) {
  double *normal = NULL;
  const size_t n = (size_t)state->mesh.n_nodes;
  const Status status = ARRAY_NEW(&normal, 3 * n, error);
  if (status != STATUS_OK) return status;
  surface_normals(&state->mesh, state->x, normal);
  for (size_t k = 0; k < n; k++) values[k] = vec3_dot(q + 3 * k, normal + 3 * k);
  array_free(normal);
  return STATUS_OK;
}

static Status fill_field(State *state, int which, double *values, Error *error) {
  static const char *const sources[] = {"d", "Y", "T1", "T2", "T2", "q"};
  const GridField *source = snapshot_grid_find(&state->grid, sources[which]);
  if (!source) return error_set(error, STATUS_IO, "expected the field %s, found others", sources[which]);
  if (which == FIELD_LOAD) return load_along_normal(state, source->values, values, error);
  for (int k = 0; k < state->mesh.n_nodes; k++)
    values[k] = which == FIELD_T2_NEGATIVE ? fmin(source->values[k], 0) : source->values[k];
  return STATUS_OK;
}

static Status open_state(Maps *maps, const char *folder, const char *path, Error *error) {
  Status status;
  const MapsOptions *options = maps->options;
  State *state = &maps->state[maps->n_states++];
  TRY(snapshot_read_grid(path, &state->grid, error));
  const GridField *x = snapshot_grid_find(&state->grid, "x"), *X = snapshot_grid_find(&state->grid, "X");
  if (!x || !X) TRY(error_set(error, STATUS_IO, "%s: expected the fields x and X, found others", path));
  state->mesh = (Mesh){
      .n_nodes = state->grid.n_nodes, .n_elements = state->grid.n_elements, .element = state->grid.element};
  state->x = x->values;
  state->X = X->values;
  for (size_t f = 0; f < options->n_fields; f++) {
    int which;
    TRY(find_name(MAPS_FIELDS, "field", options->fields[f], &which, error));
    TRY(ARRAY_NEW(&state->field[f], state->mesh.n_nodes, error));
    TRY(fill_field(state, which, state->field[f], error));
  }
  TRY(aim_transverse(state, error));
  const char *slash = strrchr(folder, '/'), *name = slash && slash[1] ? slash + 1 : folder;
  if (options->n_folders > 1)
    snprintf(state->heading, sizeof state->heading, "%.28s", name); /* as much as there is room for */
  else
    snprintf(state->heading, sizeof state->heading, "t = %.4g", state->grid.t);
cleanup:
  return status;
}

static Status open_states(Maps *maps, Error *error) {
  Status status = STATUS_OK;
  const MapsOptions *options = maps->options;
  Text path = {0};
  const size_t n = options->n_times > 0 ? options->n_times : options->n_folders;
  for (size_t k = 0; k < n; k++) {
    const char *folder = options->folders[options->n_times > 0 ? 0 : k];
    path.length = 0;
    TRY(options->n_times > 0 ? find_nearest(folder, options->times[k], &path, error)
                             : find_newest(folder, &path, error));
    TRY(open_state(maps, folder, path.data, error));
  }
cleanup:
  text_free(&path);
  return status;
}

/* ---- The sheet ---- */

static PictureView view_of(const State *state, int view) {
  if (view == VIEW_TRANSVERSE) return state->transverse;
  return picture_shear_views[view == VIEW_FLOW];
}

static Status lay_row(Maps *maps, size_t row, size_t field, int view, Error *error) {
  const MapsOptions *options = maps->options;
  int which;
  const Status status = find_name(MAPS_FIELDS, "field", options->fields[field], &which, error);
  if (status != STATUS_OK) return status;
  snprintf(maps->labels[row], sizeof maps->labels[row], "%s, %s", FIELD_LABELS[which], VIEW_LABELS[view]);
  maps->rows[row] =
      (SheetRow){.label = maps->labels[row], .minimum = options->minimum, .maximum = options->maximum};
  for (size_t c = 0; c < maps->n_states; c++) {
    const State *state = &maps->state[c];
    maps->panels[row * maps->n_states + c] = (SheetPanel){.mesh = &state->mesh,
                                                          .x = view == VIEW_REFERENCE ? state->X : state->x,
                                                          .field = state->field[field],
                                                          .view = view_of(state, view)};
  }
  return STATUS_OK;
}

static Status lay_out(Maps *maps, Text *svg, Error *error) {
  Status status = STATUS_OK;
  const MapsOptions *options = maps->options;
  const char *headings[MAPS_MOST];
  for (size_t c = 0; c < maps->n_states; c++) headings[c] = maps->state[c].heading;
  for (size_t f = 0; f < options->n_fields; f++)
    for (size_t v = 0; v < options->n_views; v++) {
      int view;
      TRY(find_name(MAPS_VIEWS, "view", options->views[v], &view, error));
      TRY(lay_row(maps, f * options->n_views + v, f, view, error));
    }
  TRY(sheet_print(&(Sheet){.rows = maps->rows,
                           .n_rows = options->n_fields * options->n_views,
                           .columns = headings,
                           .n_columns = maps->n_states,
                           .panels = maps->panels},
                  svg, error));
cleanup:
  return status;
}

Status maps_print(const MapsOptions *options, Text *svg, Error *error) {
  Status status;
  Maps *maps = NULL;
  TRY(ARRAY_NEW(&maps, 1, error));
  maps->options = options;
  TRY(open_states(maps, error));
  TRY(lay_out(maps, svg, error));
cleanup:
  for (size_t k = 0; maps && k < maps->n_states; k++) {
    for (size_t f = 0; f < MAPS_MOST; f++) array_free(maps->state[k].field[f]);
    snapshot_grid_free(&maps->state[k].grid);
  }
  array_free(maps);
  return status;
}
