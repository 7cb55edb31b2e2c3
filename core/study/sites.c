#include "study/sites.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/picture.h"
#include "observe/snapshot.h"
#include <math.h>

const char *site_region(double to_vorticity, double to_major) {
  static const double NEAR = 20;
  if (isnan(to_vorticity) || isnan(to_major)) return "";
  if (to_vorticity <= NEAR) return "vorticity_axis";
  if (to_major <= NEAR) return "major_tip";
  return to_vorticity >= 90 - NEAR ? "shear_plane" : "elsewhere";
}

static bool is_known(const SiteMark *mark) {
  return !isnan(mark->X[0]) && !isnan(mark->x[0]);
}

/* Numbers of the marks and their legend. */
typedef struct {
  PictureMark *marks; /* [2 n] */
  size_t n_marks;
  Text *labels, *lines;
  const char **legend; /* [n] */
  size_t n;
} Labels;

static void labels_free(Labels *labels) {
  for (size_t i = 0; i < labels->n; i++) {
    text_free(&labels->labels[i]);
    text_free(&labels->lines[i]);
  }
  array_free(labels->marks);
  array_free(labels->labels);
  array_free(labels->lines);
  array_free(labels->legend);
}

static Status labels_new(Labels *labels, const SiteMark *marks, size_t n, Error *error) {
  Status status = STATUS_OK;
  *labels = (Labels){0};
  TRY(ARRAY_NEW(&labels->marks, 2 * n, error));
  TRY(ARRAY_NEW(&labels->labels, n, error));
  TRY(ARRAY_NEW(&labels->lines, n, error));
  TRY(ARRAY_NEW(&labels->legend, n, error));
  for (labels->n = 0; labels->n < n;) {
    const size_t i = labels->n++;
    TRY(text_append(&labels->labels[i], error, "%zu", i + 1));
    TRY(text_append(&labels->lines[i], error, "%zu  %s%s", i + 1, marks[i].name,
                    is_known(&marks[i]) ? "" : " (no site)"));
    labels->legend[i] = labels->lines[i].data;
  }
cleanup:
  return status;
}

static void put_marks(Labels *labels, const SiteMark *marks, bool reference) {
  labels->n_marks = 0;
  for (size_t i = 0; i < labels->n; i++) {
    const double *at = reference ? marks[i].X : marks[i].x;
    if (!is_known(&marks[i])) continue;
    for (int sign = 1; sign >= -1; sign -= 2)
      labels->marks[labels->n_marks++] =
          (PictureMark){.x = {sign * at[0], sign * at[1], sign * at[2]}, .label = labels->labels[i].data};
  }
}

static Status draw(const Mesh *mesh, const double *positions, const Labels *labels, const char *folder,
                   const char *name, const char *suffix, Error *error) {
  Status status = STATUS_OK;
  Text svg = {0}, path = {0};
  const Picture picture = {
      .mesh = mesh,
      .x = positions,
      .views = picture_shear_views,
      .n_views = 2,
      .axes = picture_shear_axes,
      .n_axes = 3,
      .marks = labels->marks,
      .n_marks = labels->n_marks,
      .legend = labels->legend,
      .n_legend = labels->n,
  };
  TRY(picture_print(&picture, &svg, error));
  TRY(text_append(&path, error, "%s/%s%s.svg", folder, name, suffix));
  TRY(file_write(path.data, svg.data, svg.length, error));
cleanup:
  text_free(&svg);
  text_free(&path);
  return status;
}

Status sites_write(const Case *item, const SiteMark *marks, size_t n, const char *folder, const char *suffix,
                   Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  SnapshotGrid grid = {0};
  Labels labels = {0};
  int number;
  TRY(snapshot_find_newest(item->folder, &path, &number, NULL, error));
  if (number < 0) goto cleanup; /* a case that failed at once */
  TRY(snapshot_read_grid(path.data, &grid, error));
  TRY(labels_new(&labels, marks, n, error));
  const Mesh mesh = {.n_nodes = grid.n_nodes, .n_elements = grid.n_elements, .element = grid.element};
  const GridField *X = snapshot_grid_find(&grid, "X"), *x = snapshot_grid_find(&grid, "x");
  if (!X || !x) TRY(error_set(error, STATUS_IO, "%s: expected the fields X and x, found none", path.data));
  put_marks(&labels, marks, true);
  TRY(draw(&mesh, X->values, &labels, folder, "sites_reference", suffix, error));
  put_marks(&labels, marks, false);
  TRY(draw(&mesh, x->values, &labels, folder, "sites_capsule", suffix, error));
cleanup:
  labels_free(&labels);
  snapshot_grid_free(&grid);
  text_free(&path);
  return status;
}
