/* The data of the page: texts as they are, snapshots packed.  Nothing is computed but the axes of each shape.
 */
#include "run/run_page.h"

#include "base/array.h"
#include "base/file.h"
#include "config/scene.h"
#include "fluid/flow.h"
#include "observe/packed.h"
#include "observe/page.h"
#include "observe/shape.h"
#include "observe/snapshot.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { MAX_ROWS = 4000 };
static const size_t LARGEST_TEXT = (size_t)1 << 30, SURFACE_BYTES = 6000000;

/* Fields of a snapshot that the page shows. */
static const char *const fields[] = {"x", "q", "Y", "T1", "T2", "d"};
enum { N_FIELDS = sizeof fields / sizeof *fields };

typedef struct {
  const char *folder;
  Log *log;
  Scene scene;
  Json json;
  Error *error;
} RunPage;

static size_t shown_fields(const RunPage *page) {
  return page->scene.membrane.has_damage ? N_FIELDS : N_FIELDS - 1;
}

/* ---- texts ---- */

static Status read_text(const RunPage *page, const char *name, Text *text) {
  Status status = STATUS_OK;
  Text path = {0};
  TRY(file_join(&path, page->folder, name, page->error));
  TRY(file_read(path.data, LARGEST_TEXT, text, page->error));
cleanup:
  text_free(&path);
  return status;
}

static bool has_file(const RunPage *page, const char *name) {
  Text path = {0};
  const bool found = file_join(&path, page->folder, name, page->error) == STATUS_OK && file_exists(path.data);
  text_free(&path);
  return found;
}

/* Header, every n-th row and the last, so that there are at most MAX_ROWS or so. */
static Status thin_rows(const Text *csv, Text *thinned, Error *error) {
  Status status = STATUS_OK;
  size_t rows = 0, row = 0;
  for (size_t k = 0; k < csv->length; k++) rows += csv->data[k] == '\n';
  const size_t every = rows / MAX_ROWS + 1;
  for (const char *line = csv->data, *end; line && (end = strchr(line, '\n')); line = end + 1, row++)
    if (row == 0 || row % every == 1 % every || row + 1 == rows)
      TRY(text_append_bytes(thinned, error, line, (size_t)(end + 1 - line)));
cleanup:
  return status;
}

static Status put_history(RunPage *page) {
  Status status = STATUS_OK;
  Text csv = {0}, thinned = {0};
  if (has_file(page, "history.csv")) TRY(read_text(page, "history.csv", &csv));
  TRY(thin_rows(&csv, &thinned, page->error));
  json_string(&page->json, "history", thinned.data ? thinned.data : "");
cleanup:
  text_free(&csv);
  text_free(&thinned);
  return status;
}

/* A text as it is; null when there is no such file. */
static Status put_text(RunPage *page, const char *key, const char *name) {
  Text text = {0};
  const Status status = has_file(page, name) ? read_text(page, name, &text) : STATUS_OK;
  if (status == STATUS_OK) json_string(&page->json, key, text.data);
  text_free(&text);
  return status;
}

static Status put_summary(RunPage *page) {
  Text summary = {0};
  const Status status =
      has_file(page, "summary.json") ? read_text(page, "summary.json", &summary) : STATUS_OK;
  if (status == STATUS_OK) json_raw(&page->json, "summary", summary.length > 0 ? summary.data : "null");
  text_free(&summary);
  return status;
}

static double capillary_number(const Scene *scene) {
  if (!scene->flow.is_physical) return scene->flow.capillary_number;
  return scene->flow.viscosity.value * scene->flow.shear_rate.value * scene->flow.radius.value /
         scene->flow.shear_modulus.value;
}

static Status put_scene(RunPage *page, const char *resolved) {
  static const char *const flows[] = {"simple_shear", "planar_hyperbolic", "uniaxial_extension", "linear",
                                      "inflation"};
  const Scene *scene = &page->scene;
  Json *json = &page->json;
  json_open_object(json, "scene");
  json_string(json, "flow", flows[scene->flow.kind]);
  if (scene->flow.kind == FLOW_INFLATION)
    json_null(json, "capillary_number");
  else
    json_number(json, "capillary_number", capillary_number(scene));
  json_numbers(json, "gradient", scene->flow.gradient[0], 9);
  json_string(json, "elastic", scene->membrane.elastic.law);
  json_string(json, "damage", scene->membrane.has_damage ? scene->membrane.damage.law : NULL);
  json_close(json);
  json_string(json, "resolved", resolved);
  return json->status;
}

/* ---- surfaces ---- */

/* The axes of the ellipsoid of inertia; e1 and e2 only where they have a direction. */
static Status put_shape(RunPage *page, const SnapshotGrid *grid) {
  static const double Y_AXIS[3] = {0, 1, 0};
  const Mesh mesh = {.n_nodes = grid->n_nodes, .n_elements = grid->n_elements, .element = grid->element};
  Json *json = &page->json;
  Flow flow;
  Shape shape;
  flow_linear(&flow, (const double(*)[3])page->scene.flow.gradient);
  const bool is_inflation = page->scene.flow.kind == FLOW_INFLATION;
  const Status status = shape_measure(&mesh, snapshot_grid_find(grid, "x")->values,
                                      is_inflation ? Y_AXIS : flow.vorticity_axis, &shape, page->error);
  if (status != STATUS_OK) return status;
  const bool is_round = is_inflation || isnan(shape.beta);
  json_numbers(json, "center", shape.center, 3);
  json_numbers(json, "L", (double[]){shape.L1, shape.L2, shape.L3}, 3);
  is_round ? json_null(json, "e1") : json_numbers(json, "e1", shape.e1, 3);
  is_round ? json_null(json, "e2") : json_numbers(json, "e2", shape.e2, 3);
  return json->status;
}

static Status put_frame(RunPage *page, const SnapshotGrid *grid) {
  Status status = STATUS_OK;
  json_open_object(&page->json, NULL);
  json_number(&page->json, "t", grid->t);
  TRY(put_shape(page, grid));
  for (size_t k = 0; k < shown_fields(page); k++) {
    const GridField *field = snapshot_grid_find(grid, fields[k]);
    if (field)
      TRY(packed_numbers(&page->json, field->name, field->values,
                         (size_t)field->components * (size_t)grid->n_nodes));
  }
  json_close(&page->json);
cleanup:
  return status;
}

static Status read_grid(const RunPage *page, int number, SnapshotGrid *grid) {
  Status status = STATUS_OK;
  Text path = {0};
  TRY(snapshot_path(&path, page->folder, number, page->error));
  TRY(snapshot_read_grid(path.data, grid, page->error));
  if (!snapshot_grid_find(grid, "x") || !snapshot_grid_find(grid, "X")) {
    status = error_set(page->error, STATUS_IO, "%s: expected the fields x and X, found none", path.data);
    snapshot_grid_free(grid);
  }
cleanup:
  text_free(&path);
  return status;
}

/* How many snapshots of this mesh the page has room for. */
static size_t frames_that_fit(const RunPage *page, const SnapshotGrid *grid) {
  size_t components = 0;
  for (size_t k = 0; k < shown_fields(page); k++) {
    const GridField *field = snapshot_grid_find(grid, fields[k]);
    if (field) components += (size_t)field->components;
  }
  const size_t frame = 2 * components * (size_t)grid->n_nodes * 4 / 3;
  return SURFACE_BYTES / frame < 2 ? 2 : SURFACE_BYTES / frame;
}

static void put_topology(RunPage *page, const SnapshotGrid *grid, size_t count) {
  const size_t n = (size_t)grid->n_nodes;
  Flow flow;
  flow_linear(&flow, (const double(*)[3])page->scene.flow.gradient);
  json_integer(&page->json, "snapshots", (long long)count);
  if (page->scene.flow.kind == FLOW_INFLATION)
    json_null(&page->json, "vorticity");
  else
    json_numbers(&page->json, "vorticity", flow.vorticity_axis, 3);
  packed_integers(&page->json, "element", grid->element[0], 6 * (size_t)grid->n_elements);
  packed_numbers(&page->json, "X", snapshot_grid_find(grid, "X")->values, 3 * n);
}

/* The snapshots numbers[0 .. count), or as many of them as fit, the first and the last among them. */
static Status put_frames(RunPage *page, const int *numbers, size_t count) {
  Status status = STATUS_OK;
  SnapshotGrid grid = {0};
  size_t room = 0;
  for (size_t k = 0; k < count; k++) {
    if (room > 1 && count > room && k * (room - 1) / (count - 1) == (k - 1) * (room - 1) / (count - 1))
      continue;
    status = read_grid(page, numbers[k], &grid);
    if (status == STATUS_IO) {
      log_warning(page->log, "%s", page->error->text);
      status = STATUS_OK;
      continue;
    }
    if (status != STATUS_OK) goto cleanup;
    if (room == 0) {
      room = frames_that_fit(page, &grid);
      json_open_object(&page->json, "surface");
      put_topology(page, &grid, count);
      json_open_array(&page->json, "frames");
    }
    TRY(put_frame(page, &grid));
    snapshot_grid_free(&grid);
  }
  if (room == 0) {
    json_null(&page->json, "surface");
  } else {
    json_close(&page->json);
    json_close(&page->json);
  }
cleanup:
  snapshot_grid_free(&grid);
  return status;
}

static Status put_surfaces(RunPage *page) {
  Status status = STATUS_OK;
  int *numbers = NULL;
  size_t count;
  TRY(snapshot_list(page->folder, &numbers, &count, page->error));
  TRY(put_frames(page, numbers, count));
cleanup:
  array_free(numbers);
  return status;
}

Status run_page_write(const char *folder, Log *log, Error *error) {
  Status status = STATUS_OK;
  RunPage page = {.folder = folder, .log = log, .error = error};
  Text resolved = {0}, data = {0};
  TRY(read_text(&page, "resolved.yaml", &resolved));
  TRY(scene_read_text(&page.scene, "resolved.yaml", resolved.data, resolved.length, NULL, 0, error));
  json_begin(&page.json, &data, error);
  json_open_object(&page.json, NULL);
  json_string(&page.json, "kind", "run");
  json_string(&page.json, "program", CAPSELLA_VERSION);
  json_string(&page.json, "name", page.scene.name);
  TRY(put_scene(&page, resolved.data));
  TRY(put_summary(&page));
  TRY(put_history(&page));
  TRY(put_text(&page, "criteria", "criteria.csv"));
  TRY(put_surfaces(&page));
  json_close(&page.json);
  TRY(json_end(&page.json));
  TRY(page_write(folder, data.data, error));
cleanup:
  text_free(&resolved);
  text_free(&data);
  scene_free(&page.scene);
  return status;
}
