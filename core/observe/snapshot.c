/* The layout of a snapshot: VTKHDF 1.0 (UnstructuredGrid) for ParaView 5.11 and later, and the restart group.
 */
#include "observe/snapshot.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/hdf.h"
#include "observe/seal.h"
#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ARRAYS       "/restart/arrays"
#define POINT_DATA   "/VTKHDF/PointData"
#define CONNECTIVITY "/VTKHDF/Connectivity"

enum { VTK_QUADRATIC_TRIANGLE = 22 }; /* node order as in mesh.h: corners, then edges 01, 12, 20 */

static const size_t LARGEST_FILE = (size_t)1 << 34;
static const char NAME_FORMAT[] = "snapshot_%06d.vtkhdf";

Status snapshot_path(Text *path, const char *folder, int number, Error *error) {
  char name[64];
  snprintf(name, sizeof name, NAME_FORMAT, number);
  return file_join(path, folder, name, error);
}

/* --- writing --- */

/* Offsets [n_elements + 1] and types [n_elements] of the cells: all alike, but the format wants them. */
static Status write_cells(Hdf *hdf, const Mesh *mesh, Error *error) {
  Status status;
  const size_t n = (size_t)mesh->n_elements;
  const int ids = 6 * mesh->n_elements;
  int *offset = NULL;
  unsigned char *type = NULL;
  TRY(ARRAY_NEW(&offset, n + 1, error));
  TRY(ARRAY_NEW(&type, n, error));
  for (size_t e = 0; e <= n; e++) offset[e] = 6 * (int)e;
  memset(type, VTK_QUADRATIC_TRIANGLE, n);
  TRY(hdf_write(hdf, "/VTKHDF/NumberOfCells", HDF_INT, 1, 0, &mesh->n_elements, error));
  TRY(hdf_write(hdf, "/VTKHDF/NumberOfConnectivityIds", HDF_INT, 1, 0, &ids, error));
  TRY(hdf_write(hdf, CONNECTIVITY, HDF_INT, 6 * n, 0, mesh->element, error));
  TRY(hdf_write(hdf, "/VTKHDF/Offsets", HDF_INT, n + 1, 0, offset, error));
  TRY(hdf_write(hdf, "/VTKHDF/Types", HDF_BYTE, n, 0, type, error));
cleanup:
  array_free(type);
  array_free(offset);
  return status;
}

static Status write_field(Hdf *hdf, const Mesh *mesh, const SnapshotField *field, Error *error) {
  Text path = {0};
  Status status = text_append(&path, error, POINT_DATA "/%s", field->name);
  const size_t columns = field->components == 1 ? 0 : (size_t)field->components;
  if (status == STATUS_OK)
    status = hdf_write(hdf, path.data, HDF_DOUBLE, (size_t)mesh->n_nodes, columns, field->values, error);
  text_free(&path);
  return status;
}

static Status write_cell_data(Hdf *hdf, const Mesh *mesh, const SnapshotCells *cells, Error *error) {
  Text path = {0};
  Status status = text_append(&path, error, "/VTKHDF/CellData/%s", cells->name);
  if (status == STATUS_OK)
    status = hdf_write(hdf, path.data, HDF_DOUBLE, (size_t)mesh->n_elements, 0, cells->values, error);
  text_free(&path);
  return status;
}

static Status write_grid(Hdf *hdf, const Snapshot *snapshot, Error *error) {
  Status status;
  const Mesh *mesh = snapshot->mesh;
  const int version[2] = {1, 0};
  const SnapshotField reference = {"X", 3, mesh->X};
  TRY(hdf_write(hdf, "/VTKHDF/NumberOfPoints", HDF_INT, 1, 0, &mesh->n_nodes, error));
  TRY(hdf_set_integers(hdf, "/VTKHDF", "Version", version, 2, error));
  TRY(hdf_set_text(hdf, "/VTKHDF", "Type", "UnstructuredGrid", error));
  TRY(hdf_write(hdf, "/VTKHDF/Points", HDF_DOUBLE, (size_t)mesh->n_nodes, 3, snapshot->x, error));
  TRY(write_cells(hdf, mesh, error));
  TRY(write_field(hdf, mesh, &reference, error));
  TRY(hdf_link(hdf, "/VTKHDF/Points", POINT_DATA "/x", error));
  for (size_t k = 0; k < snapshot->n_fields; k++) TRY(write_field(hdf, mesh, &snapshot->fields[k], error));
  for (size_t k = 0; k < snapshot->n_cells; k++) TRY(write_cell_data(hdf, mesh, &snapshot->cells[k], error));
  TRY(hdf_write(hdf, "/VTKHDF/FieldData/TimeValue", HDF_DOUBLE, 1, 0, &snapshot->t, error));
cleanup:
  return status;
}

static Status item_path(const RestartItem *item, Text *path, Error *error) {
  return text_append(path, error, ARRAYS "/%s", item->name);
}

static HdfType item_type(const RestartItem *item) {
  return item->doubles ? HDF_DOUBLE : HDF_LONG_LONG;
}

static void *item_values(const RestartItem *item) {
  return item->doubles ? (void *)item->doubles : (void *)item->integers;
}

static Status write_item(Hdf *hdf, const RestartItem *item, Error *error) {
  Text path = {0};
  Status status = item_path(item, &path, error);
  if (status == STATUS_OK)
    status = hdf_write(hdf, path.data, item_type(item), item->count, 0, item_values(item), error);
  text_free(&path);
  return status;
}

Status snapshot_write(const char *path, const Snapshot *snapshot, Error *error) {
  Status status;
  Hdf *hdf = NULL;
  char *image = NULL;
  size_t length;
  TRY(hdf_new(&hdf, SEAL_SIZE, error));
  TRY(write_grid(hdf, snapshot, error));
  TRY(hdf_write_text(hdf, "/restart/scene", snapshot->scene, error));
  TRY(hdf_write(hdf, "/restart/t", HDF_DOUBLE, 1, 0, &snapshot->t, error));
  for (size_t k = 0; k < snapshot->n_restart; k++) TRY(write_item(hdf, &snapshot->restart[k], error));
  TRY(hdf_image(hdf, &image, &length, error));
  seal_make(image + SEAL_SIZE, length - SEAL_SIZE, image);
  TRY(file_write(path, image, length, error));
cleanup:
  if (status != STATUS_OK && !image) error_prefix(error, "%s: ", path); /* writing names the file by itself */
  array_free(image);
  hdf_free(hdf);
  return status;
}

/* --- reading --- */

static Status read_sealed(const char *path, Text *file, Error *error) {
  Status status = file_read(path, LARGEST_FILE, file, error);
  if (status != STATUS_OK) return status;
  status = seal_check(file->data, file->length, error);
  return status == STATUS_OK ? status : error_prefix(error, "%s: ", path);
}

static Status open_sealed(const char *path, Hdf **hdf, Error *error) {
  Text file = {0};
  Status status = read_sealed(path, &file, error);
  if (status == STATUS_OK) {
    status = hdf_open(hdf, file.data, file.length, error);
    if (status != STATUS_OK) error_prefix(error, "%s: ", path);
  }
  text_free(&file);
  return status;
}

#define OTHER_SCENE                                                                                          \
  "it belongs to another scene; go on with the scene it was made with (resolved.yaml beside it), or start "  \
  "anew in another folder"

static Status check_item(Hdf *hdf, const RestartItem *item, const char *path, Error *error) {
  HdfType type;
  size_t count;
  if (!hdf_exists(hdf, path))
    return error_set(error, STATUS_INPUT, "expected the array `%s`, found none: " OTHER_SCENE, item->name);
  Status status = hdf_describe(hdf, path, &type, &count, error);
  if (status != STATUS_OK) return status;
  if (type != item_type(item))
    return error_set(error, STATUS_INPUT, "array `%s`: expected %s, found another type: " OTHER_SCENE,
                     item->name, item->doubles ? "doubles" : "integers");
  if (count != item->count)
    return error_set(error, STATUS_INPUT, "array `%s`: expected %zu values, found %zu: " OTHER_SCENE,
                     item->name, item->count, count);
  return STATUS_OK;
}

static bool is_listed(const char *name, const RestartItem *items, size_t n_items) {
  for (size_t k = 0; k < n_items; k++)
    if (strcmp(name, items[k].name) == 0) return true;
  return false;
}

static Status check_nothing_more(Hdf *hdf, const RestartItem *items, size_t n_items, Error *error) {
  Status status = STATUS_OK;
  Text name = {0};
  size_t count = 0;
  if (hdf_exists(hdf, ARRAYS)) TRY(hdf_count(hdf, ARRAYS, &count, error));
  for (size_t k = 0; k < count; k++) {
    text_free(&name);
    TRY(hdf_name(hdf, ARRAYS, k, &name, error));
    if (!is_listed(name.data, items, n_items))
      TRY(error_set(error, STATUS_INPUT, "found the array `%s`, which this scene does not have: " OTHER_SCENE,
                    name.data));
  }
cleanup:
  text_free(&name);
  return status;
}

/* Checks the item, or (with `is_read`) reads it. */
static Status take_item(Hdf *hdf, const RestartItem *item, bool is_read, Error *error) {
  Text path = {0};
  Status status = item_path(item, &path, error);
  if (status == STATUS_OK)
    status = is_read ? hdf_read(hdf, path.data, item_type(item), item->count, item_values(item), error)
                     : check_item(hdf, item, path.data, error);
  text_free(&path);
  return status;
}

Status snapshot_read_restart(const char *path, const RestartItem *items, size_t n_items, Error *error) {
  Hdf *hdf;
  Status status = open_sealed(path, &hdf, error);
  if (status != STATUS_OK) return status;
  for (size_t k = 0; k < n_items; k++) TRY(take_item(hdf, &items[k], false, error));
  TRY(check_nothing_more(hdf, items, n_items, error));
  for (size_t k = 0; k < n_items; k++) TRY(take_item(hdf, &items[k], true, error));
cleanup:
  if (status != STATUS_OK) error_prefix(error, "%s: ", path);
  hdf_free(hdf);
  return status;
}

Status snapshot_read_scene(const char *path, Text *scene, double *t, Error *error) {
  Hdf *hdf;
  Status status = open_sealed(path, &hdf, error);
  if (status != STATUS_OK) return status;
  if (scene) TRY(hdf_read_text(hdf, "/restart/scene", scene, error));
  if (t) TRY(hdf_read(hdf, "/restart/t", HDF_DOUBLE, 1, t, error));
cleanup:
  if (status != STATUS_OK) error_prefix(error, "%s: ", path);
  hdf_free(hdf);
  return status;
}

/* Number of values of a dataset that must hold whole rows of `columns`. */
static Status count_rows(Hdf *hdf, const char *path, size_t columns, int *rows, Error *error) {
  HdfType type;
  size_t count;
  Status status = hdf_describe(hdf, path, &type, &count, error);
  if (status != STATUS_OK) return status;
  if (count == 0 || count % columns != 0 || count > INT_MAX)
    return error_set(error, STATUS_IO, "%s: expected rows of %zu values, found %zu values", path, columns,
                     count);
  *rows = (int)(count / columns);
  return STATUS_OK;
}

static Status read_elements(Hdf *hdf, SnapshotGrid *grid, Error *error) {
  Status status;
  TRY(count_rows(hdf, CONNECTIVITY, 6, &grid->n_elements, error));
  TRY(ARRAY_NEW(&grid->element, grid->n_elements, error));
  TRY(hdf_read(hdf, CONNECTIVITY, HDF_INT, 6 * (size_t)grid->n_elements, grid->element, error));
  for (int e = 0; e < grid->n_elements; e++)
    for (int k = 0; k < 6; k++)
      if (grid->element[e][k] < 0 || grid->element[e][k] >= grid->n_nodes)
        TRY(error_set(error, STATUS_IO, "element %d names node %d of %d", e, grid->element[e][k],
                      grid->n_nodes));
cleanup:
  return status;
}

static Status read_grid_field(Hdf *hdf, size_t index, SnapshotGrid *grid, Error *error) {
  Status status;
  Text name = {0}, path = {0};
  int values;
  GridField *field = &grid->field[grid->n_fields];
  TRY(hdf_name(hdf, POINT_DATA, index, &name, error));
  TRY(text_append(&path, error, POINT_DATA "/%s", name.data));
  TRY(count_rows(hdf, path.data, (size_t)grid->n_nodes, &field->components, error));
  if (name.length >= sizeof field->name)
    TRY(error_set(error, STATUS_IO, "%s: expected a name of less than %zu bytes", path.data,
                  sizeof field->name));
  memcpy(field->name, name.data, name.length + 1);
  values = field->components * grid->n_nodes;
  TRY(ARRAY_NEW(&field->values, values, error));
  grid->n_fields++; /* from here on freed with the grid */
  TRY(hdf_read(hdf, path.data, HDF_DOUBLE, (size_t)values, field->values, error));
cleanup:
  text_free(&name);
  text_free(&path);
  return status;
}

Status snapshot_read_grid(const char *path, SnapshotGrid *grid, Error *error) {
  Hdf *hdf;
  size_t count;
  *grid = (SnapshotGrid){0};
  Status status = open_sealed(path, &hdf, error);
  if (status != STATUS_OK) return status;
  TRY(hdf_read(hdf, "/restart/t", HDF_DOUBLE, 1, &grid->t, error));
  TRY(count_rows(hdf, "/VTKHDF/Points", 3, &grid->n_nodes, error));
  TRY(read_elements(hdf, grid, error));
  TRY(hdf_count(hdf, POINT_DATA, &count, error));
  for (size_t k = 0; k < count && k < GRID_MAX_FIELDS; k++) TRY(read_grid_field(hdf, k, grid, error));
cleanup:
  if (status != STATUS_OK) {
    error_prefix(error, "%s: ", path);
    snapshot_grid_free(grid);
  }
  hdf_free(hdf);
  return status;
}

void snapshot_grid_free(SnapshotGrid *grid) {
  array_free(grid->element);
  for (size_t k = 0; k < grid->n_fields; k++) array_free(grid->field[k].values);
  *grid = (SnapshotGrid){0};
}

const GridField *snapshot_grid_find(const SnapshotGrid *grid, const char *name) {
  for (size_t k = 0; k < grid->n_fields; k++)
    if (strcmp(grid->field[k].name, name) == 0) return &grid->field[k];
  return NULL;
}

/* --- finding --- */

/* The number of a snapshot from its file name, -1 when the name is none. */
static int number_of(const char *name) {
  int number = -1;
  char back[64];
  if (sscanf(name, "snapshot_%9d.vtkhdf", &number) != 1 || number < 0) return -1;
  snprintf(back, sizeof back, NAME_FORMAT, number);
  return strcmp(name, back) == 0 ? number : -1;
}

static int by_number(const void *a, const void *b) {
  const int *left = a, *right = b;
  return (*left > *right) - (*left < *right);
}

Status snapshot_list(const char *folder, int **numbers, size_t *count, Error *error) {
  *numbers = NULL;
  *count = 0;
  DIR *entries = opendir(folder);
  if (!entries)
    return error_set(error, STATUS_IO, "%s: the folder cannot be read: %s", folder, strerror(errno));
  size_t room = 0;
  while (readdir(entries)) room++;
  Status status = ARRAY_NEW(numbers, room, error);
  rewinddir(entries);
  /* Files that appeared in between do not fit and are not missed. */
  for (struct dirent *entry; status == STATUS_OK && *count < room && (entry = readdir(entries));) {
    int number = number_of(entry->d_name);
    if (number >= 0) (*numbers)[(*count)++] = number;
  }
  closedir(entries);
  if (*count > 0) qsort(*numbers, *count, sizeof **numbers, by_number);
  return status;
}

/* Whether snapshot `number` is whole; `path` gets its name. */
static Status check_whole(const char *folder, int number, Text *path, Error *error) {
  Text file = {0};
  Status status = snapshot_path(path, folder, number, error);
  if (status == STATUS_OK) status = read_sealed(path->data, &file, error);
  text_free(&file);
  return status;
}

Status snapshot_find_newest(const char *folder, Text *path, int *number, Log *log, Error *error) {
  Status status;
  int *numbers = NULL;
  size_t count, total;
  Text found = {0};
  *number = -1;
  TRY(snapshot_list(folder, &numbers, &count, error));
  total = count;
  while (count > 0 && *number < 0) {
    text_free(&found);
    status = check_whole(folder, numbers[--count], &found, error);
    if (status == STATUS_OK)
      *number = numbers[count];
    else if (status == STATUS_IO)
      log_warning(log, "%s", error->text);
    else
      goto cleanup;
  }
  if (*number >= 0)
    status = text_append(path, error, "%s", found.data);
  else if (total > 0)
    status =
        error_prefix(error,
                     "%s: none of its snapshots is whole (a run without --resume starts anew and removes "
                     "them); the oldest: ",
                     folder);
cleanup:
  text_free(&found);
  array_free(numbers);
  return status;
}
