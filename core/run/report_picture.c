/* Everything is read from the files of the folder: scene, snapshots, summary. */
#include "run/report_picture.h"

#include "base/array.h"
#include "base/file.h"
#include "base/vec3.h"
#include "config/scene.h"
#include "config/yaml_tree.h"
#include "mesh/p2.h"
#include "observe/picture.h"
#include "observe/snapshot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- which snapshot, which field ---- */

/* The whole snapshot nearest to a time; where none is whole, `path` stays as it is. */
static Status find_nearest(const char *folder, double time, Text *path, Error *error) {
  Status status = STATUS_OK;
  int *numbers = NULL, nearest = -1;
  size_t count;
  double t, least = HUGE_VAL;
  Text candidate = {0};
  TRY(snapshot_list(folder, &numbers, &count, error));
  for (size_t k = 0; k < count; k++) {
    candidate.length = 0;
    TRY(snapshot_path(&candidate, folder, numbers[k], error));
    if (snapshot_read_scene(candidate.data, NULL, &t, error) != STATUS_OK) continue;
    if (fabs(t - time) >= least) continue;
    least = fabs(t - time);
    nearest = numbers[k];
  }
  if (nearest >= 0) TRY(snapshot_path(path, folder, nearest, error));
cleanup:
  array_free(numbers);
  text_free(&candidate);
  return status;
}

static Status find_snapshot(const char *folder, double time, Text *path, Error *error) {
  Status status;
  int number;
  TRY(isnan(time) ? snapshot_find_newest(folder, path, &number, NULL, error)
                  : find_nearest(folder, time, path, error));
  if (!path->length)
    TRY(error_set(error, STATUS_INPUT, "%s: expected a snapshot of a run, found none that is whole", folder));
cleanup:
  return status;
}

static Status find_field(const SnapshotGrid *grid, const char *name, const GridField **field, Error *error) {
  Status status = STATUS_OK;
  Text names = {0};
  *field = snapshot_grid_find(grid, name);
  if (*field && (*field)->components == 1) return STATUS_OK;
  for (size_t k = 0; k < grid->n_fields; k++)
    if (grid->field[k].components == 1)
      TRY(text_append(&names, error, "%s%s", names.length ? ", " : "", grid->field[k].name));
  TRY(error_set(error, STATUS_INPUT, "expected one of the fields %s, found `%s`",
                names.length ? names.data : "", name));
cleanup:
  text_free(&names);
  return status;
}

static const char *label_of(const char *field) {
  static const char *const labels[][2] = {{"d", "damage d"},
                                          {"Y", "energy release rate Y / G_s"},
                                          {"T1", "larger tension T1 / G_s"},
                                          {"T2", "smaller tension T2 / G_s"}};
  for (size_t k = 0; k < sizeof labels / sizeof *labels; k++)
    if (strcmp(labels[k][0], field) == 0) return labels[k][1];
  return field;
}

/* ---- the mark ---- */

static bool read_place(const YamlNode *summary, const char *key, double X[3]) {
  const YamlNode *site = yaml_tree_find(summary, key);
  if (!site || site->kind != YAML_TREE_MAPPING) return false;
  const YamlNode *place = yaml_tree_find(site, "X");
  if (!place || place->kind != YAML_TREE_LIST || place->count != 3) return false;
  for (int i = 0; i < 3; i++) X[i] = strtod(place->items[i]->text ? place->items[i]->text : "nan", NULL);
  return isfinite(X[0] + X[1] + X[2]);
}

/* Where the point X of the membrane is now: it is an integration point, of which each element has six. */
static void carry(const SnapshotGrid *grid, const double *X_nodes, const double *x_nodes, const double X[3],
                  double x[3]) {
  const P2Table table = p2_table(triangle_rule(6));
  double least = HUGE_VAL, here[3];
  for (int e = 0; e < grid->n_elements; e++)
    for (int k = 0; k < table.n; k++) {
      p2_interpolate(X_nodes, grid->element[e], table.N[k], here);
      const double distance = vec3_distance(here, X);
      if (distance >= least) continue;
      least = distance;
      p2_interpolate(x_nodes, grid->element[e], table.N[k], x);
    }
}

/* The mark's label stays NULL where there is nothing to mark. */
static Status read_mark(const char *folder, PictureMark *mark, Error *error) {
  Status status = STATUS_OK;
  Text path = {0}, text = {0};
  YamlNode *summary = NULL;
  TRY(file_join(&path, folder, "summary.json", error));
  if (!file_exists(path.data)) goto cleanup;
  TRY(file_read(path.data, YAML_TREE_BYTES, &text, error));
  TRY(yaml_tree_parse(&summary, path.data, true, text.data, text.length, error));
  if (read_place(summary, "rupture", mark->X))
    mark->label = "first rupture";
  else if (read_place(summary, "d_max_location", mark->X))
    mark->label = "largest d";
cleanup:
  yaml_tree_free(summary);
  text_free(&text);
  text_free(&path);
  return status;
}

/* ---- the picture ---- */

enum { VIEWS = 3 };
typedef struct {
  char title[VIEWS][64];
  PictureView view[VIEWS];
} Views;

/* The last one is of the capsule at rest. */
static void make_views(Views *views, double t, bool is_shear) {
  static const char *const of_shear[] = {"the vorticity axis", "the velocity gradient", "the vorticity axis"};
  static const char *const of_any[] = {"y", "z", "y"};
  for (int k = 0; k < VIEWS; k++) {
    views->view[k] = picture_shear_views[k % 2];
    views->view[k].is_reference = k == VIEWS - 1;
    views->view[k].title = views->title[k];
    const char *along = is_shear ? of_shear[k] : of_any[k];
    if (views->view[k].is_reference)
      snprintf(views->title[k], sizeof views->title[k], "at rest, along %s", along);
    else
      snprintf(views->title[k], sizeof views->title[k], "t = %.4g, along %s", t, along);
  }
}

static const PictureAxis plain_axes[] = {{{1, 0, 0}, "x"}, {{0, 1, 0}, "y"}, {{0, 0, 1}, "z"}};

static Status draw(const SnapshotGrid *grid, const Scene *scene, const char *name, PictureMark *mark,
                   Text *svg, Error *error) {
  Status status;
  const GridField *x = snapshot_grid_find(grid, "x"), *X = snapshot_grid_find(grid, "X"), *field;
  if (!x || !X) TRY(error_set(error, STATUS_IO, "expected the fields x and X, found others"));
  TRY(find_field(grid, name, &field, error));
  if (mark->label) carry(grid, X->values, x->values, mark->X, mark->x);
  const bool is_shear = scene->flow.kind == FLOW_SIMPLE_SHEAR;
  Views views;
  make_views(&views, grid->t, is_shear);
  const Mesh mesh = {.n_nodes = grid->n_nodes, .n_elements = grid->n_elements, .element = grid->element};
  const Picture picture = {.mesh = &mesh,
                           .x = x->values,
                           .X = X->values,
                           .field = field->values,
                           .label = label_of(name),
                           .views = views.view,
                           .n_views = VIEWS,
                           .axes = is_shear ? picture_shear_axes : plain_axes,
                           .n_axes = 3,
                           .marks = mark,
                           .n_marks = mark->label != NULL,
                           .marks_shine_through = true};
  TRY(picture_print(&picture, svg, error));
cleanup:
  return status;
}

Status report_picture(const char *folder, const ReportChoice *choice, Text *svg, Error *error) {
  Status status = STATUS_OK;
  Text scene_path = {0}, path = {0};
  Scene scene = {0};
  SnapshotGrid grid = {0};
  PictureMark mark = {0};
  TRY(file_join(&scene_path, folder, "resolved.yaml", error));
  TRY(scene_read(&scene, scene_path.data, NULL, 0, error));
  TRY(find_snapshot(folder, choice->time, &path, error));
  TRY(snapshot_read_grid(path.data, &grid, error));
  TRY(read_mark(folder, &mark, error));
  const char *fallback = scene.membrane.has_damage ? "d" : "Y";
  status = draw(&grid, &scene, choice->field ? choice->field : fallback, &mark, svg, error);
  if (status != STATUS_OK) error_prefix(error, "%s: ", path.data);
cleanup:
  snapshot_grid_free(&grid);
  scene_free(&scene);
  text_free(&path);
  text_free(&scene_path);
  return status;
}
