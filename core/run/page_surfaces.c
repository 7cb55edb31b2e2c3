/* Positions and fields at the nodes as they stand in the snapshots; nothing is computed but the axes of each
 * shape. */
#include "run/page_surfaces.h"

#include "base/array.h"
#include "fluid/flow.h"
#include "observe/packed.h"
#include "observe/shape.h"
#include "observe/snapshot.h"
#include <math.h>
#include <stdbool.h>

static const size_t SURFACE_BYTES = 6000000;

/* Fields of a snapshot that the page shows. */
static const char *const fields[] = {"x", "q", "Y", "T1", "T2", "d"};
enum { N_FIELDS = sizeof fields / sizeof *fields };

typedef struct {
  Page *page;
  const Scene *scene;
  Log *log;
  int n_nodes; /* of the first state; 0: none yet */
  size_t room; /* number of states that fit */
} Surfaces;

static bool is_inflation(const Surfaces *s) {
  return s->scene->flow.kind == FLOW_INFLATION;
}

static void flow_axis(const Surfaces *s, double axis[3]) {
  Flow flow;
  flow_linear(&flow, (const double(*)[3])s->scene->flow.gradient);
  for (int i = 0; i < 3; i++) axis[i] = is_inflation(s) ? i == 1 : flow.vorticity_axis[i];
}

static void put_direction(Json *json, const char *key, const double direction[3], bool is_known) {
  if (is_known)
    json_numbers(json, key, direction, 3);
  else
    json_null(json, key);
}

/* The axes of the ellipsoid of inertia; e1 and e2 only where they have a direction. */
static Status put_shape(const Surfaces *s, const SnapshotGrid *grid) {
  const Mesh mesh = {.n_nodes = grid->n_nodes, .n_elements = grid->n_elements, .element = grid->element};
  Json *json = &s->page->json;
  double axis[3];
  Shape shape;
  flow_axis(s, axis);
  const Status status =
      shape_measure(&mesh, NULL, snapshot_grid_find(grid, "x")->values, axis, &shape, s->page->error);
  if (status != STATUS_OK) return status;
  const bool has_axes = !is_inflation(s) && !isnan(shape.beta);
  json_numbers(json, "center", shape.center, 3);
  json_numbers(json, "L", (double[]){shape.L1, shape.L2, shape.L3}, 3);
  put_direction(json, "e1", shape.e1, has_axes);
  put_direction(json, "e2", shape.e2, has_axes);
  return json->status;
}

static Status put_frame(const Surfaces *s, const SnapshotGrid *grid, const char *label) {
  Status status = STATUS_OK;
  Json *json = &s->page->json;
  json_open_object(json, NULL);
  json_number(json, "t", grid->t);
  if (label) json_string(json, "label", label);
  TRY(put_shape(s, grid));
  for (size_t k = 0; k < N_FIELDS; k++) {
    const GridField *field = snapshot_grid_find(grid, fields[k]);
    if (field)
      TRY(packed_numbers(json, field->name, field->values,
                         (size_t)field->components * (size_t)grid->n_nodes));
  }
  json_close(json);
cleanup:
  return status;
}

/* How many states of this mesh the page has room for. */
static size_t states_that_fit(const SnapshotGrid *grid) {
  size_t components = 0;
  for (size_t k = 0; k < N_FIELDS; k++) {
    const GridField *field = snapshot_grid_find(grid, fields[k]);
    if (field) components += (size_t)field->components;
  }
  const size_t state = 2 * components * (size_t)grid->n_nodes * 4 / 3;
  return SURFACE_BYTES / state < 2 ? 2 : SURFACE_BYTES / state;
}

/* What all states share. */
static Status begin(Surfaces *s, const SnapshotGrid *grid, size_t count) {
  Status status = STATUS_OK;
  Json *json = &s->page->json;
  double axis[3];
  flow_axis(s, axis);
  s->n_nodes = grid->n_nodes;
  s->room = states_that_fit(grid);
  json_open_object(json, "surface");
  json_integer(json, "snapshots", (long long)count);
  put_direction(json, "vorticity", axis, !is_inflation(s));
  TRY(packed_integers(json, "element", grid->element[0], 6 * (size_t)grid->n_elements));
  TRY(packed_numbers(json, "X", snapshot_grid_find(grid, "X")->values, 3 * (size_t)grid->n_nodes));
  json_open_array(json, "frames");
cleanup:
  return status;
}

static Status read_state(const Surfaces *s, const char *path, SnapshotGrid *grid) {
  const Status status = snapshot_read_grid(path, grid, s->page->error);
  if (status != STATUS_OK) return status;
  if (!snapshot_grid_find(grid, "x") || !snapshot_grid_find(grid, "X"))
    return error_set(s->page->error, STATUS_IO, "%s: expected the fields x and X, found none", path);
  if (s->n_nodes > 0 && grid->n_nodes != s->n_nodes)
    return error_set(s->page->error, STATUS_IO,
                     "%s: not shown, its mesh is another than that of the first state", path);
  return STATUS_OK;
}

/* Whether state k is one of `room` that are evenly chosen from `count`. */
static bool is_chosen(size_t k, size_t count, size_t room) {
  if (room == 0 || count <= room) return true;
  return k * (room - 1) / (count - 1) != (k - 1) * (room - 1) / (count - 1);
}

Status page_put_surfaces(Page *page, const Scene *scene, const PageState *states, size_t count, Log *log) {
  Status status = STATUS_OK;
  SnapshotGrid grid = {0};
  Surfaces s = {.page = page, .scene = scene, .log = log};
  for (size_t k = 0; k < count; k++) {
    if (!is_chosen(k, count, s.room)) continue;
    status = read_state(&s, states[k].path, &grid);
    if (status == STATUS_OK) {
      if (s.room == 0) TRY(begin(&s, &grid, count));
      TRY(put_frame(&s, &grid, states[k].label));
    } else if (status == STATUS_IO) {
      log_warning(log, "%s", page->error->text);
      status = STATUS_OK;
    } else {
      goto cleanup;
    }
    snapshot_grid_free(&grid);
  }
  if (s.room == 0) {
    json_null(&page->json, "surface");
  } else {
    json_close(&page->json);
    json_close(&page->json);
  }
cleanup:
  snapshot_grid_free(&grid);
  return status;
}

Status page_put_snapshots(Page *page, const Scene *scene, Log *log) {
  Status status = STATUS_OK;
  int *numbers = NULL;
  size_t count = 0;
  PageState *states = NULL;
  Text path = {0};
  TRY(snapshot_list(page->folder, &numbers, &count, page->error));
  TRY(ARRAY_NEW(&states, count, page->error));
  for (size_t k = 0; k < count; k++) {
    path.length = 0;
    TRY(snapshot_path(&path, page->folder, numbers[k], page->error));
    if (!(states[k].path = text_copy(path.data, page->error))) TRY(page->error->code);
  }
  TRY(page_put_surfaces(page, scene, states, count, log));
cleanup:
  for (size_t k = 0; states && k < count; k++) array_free(states[k].path);
  array_free(states);
  array_free(numbers);
  text_free(&path);
  return status;
}
