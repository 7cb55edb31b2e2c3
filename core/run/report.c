#include "run/report.h"

#include "base/file.h"
#include "config/scene.h"
#include "observe/picture.h"
#include "observe/snapshot.h"
#include "run/run_page.h"

static Status draw(const SnapshotGrid *grid, bool is_damaged, Text *svg, Error *error) {
  const Mesh mesh = {.n_nodes = grid->n_nodes, .n_elements = grid->n_elements, .element = grid->element};
  const GridField *x = snapshot_grid_find(grid, "x"),
                  *field = snapshot_grid_find(grid, is_damaged ? "d" : "Y");
  if (!x || !field) return error_set(error, STATUS_IO, "expected the fields x, Y and d, found others");
  const Picture picture = {
      .mesh = &mesh,
      .x = x->values,
      .field = field->values,
      .label = is_damaged ? "damage d" : "energy release rate Y / G_s",
      .views = picture_shear_views,
      .n_views = 2,
      .axes = picture_shear_axes,
      .n_axes = 3,
  };
  return picture_print(&picture, svg, error);
}

static Status find_newest(const char *folder, Text *path, Error *error) {
  int number;
  const Status status = snapshot_find_newest(folder, path, &number, NULL, error);
  if (status != STATUS_OK || number >= 0) return status;
  return error_set(error, STATUS_INPUT, "%s: expected a snapshot of a run, found none that is whole", folder);
}

static Status draw_newest(const char *folder, Text *svg, Error *error) {
  Status status = STATUS_OK;
  Text scene_path = {0}, path = {0};
  Scene scene = {0};
  SnapshotGrid grid = {0};
  TRY(file_join(&scene_path, folder, "resolved.yaml", error));
  TRY(scene_read(&scene, scene_path.data, NULL, 0, error));
  TRY(find_newest(folder, &path, error));
  TRY(snapshot_read_grid(path.data, &grid, error));
  status = draw(&grid, scene.membrane.has_damage, svg, error);
  if (status != STATUS_OK) error_prefix(error, "%s: ", path.data);
cleanup:
  snapshot_grid_free(&grid);
  scene_free(&scene);
  text_free(&path);
  text_free(&scene_path);
  return status;
}

Status report_folder(const char *folder, Text *written, Error *error) {
  Status status = STATUS_OK;
  Text svg = {0};
  TRY(draw_newest(folder, &svg, error));
  TRY(file_join(written, folder, "capsule.svg", error));
  TRY(file_write(written->data, svg.data, svg.length, error));
  TRY(run_page_write(folder, NULL, error));
  TRY(text_append(written, error, "\n%s/report.html", folder));
cleanup:
  text_free(&svg);
  return status;
}
