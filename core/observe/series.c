/* The two indexes of a folder's snapshots, printed from the list of numbers and times. */
#include "observe/series.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/json.h"
#include "observe/number.h"
#include <string.h>

void series_free(Series *series) {
  array_free(series->entry);
  *series = (Series){0};
}

/* Puts an entry at the end, in place of those with its number or a later one. */
static Status put_entry(Series *series, int number, double t, Error *error) {
  while (series->count > 0 && series->entry[series->count - 1].number >= number) series->count--;
  if (series->count == series->capacity) {
    SeriesEntry *more;
    const size_t room = series->capacity ? 2 * series->capacity : 16;
    Status status = ARRAY_NEW(&more, room, error);
    if (status != STATUS_OK) return status;
    if (series->count) memcpy(more, series->entry, series->count * sizeof *more);
    array_free(series->entry);
    series->entry = more;
    series->capacity = room;
  }
  series->entry[series->count++] = (SeriesEntry){number, t};
  return STATUS_OK;
}

Status series_restore(Series *series, const char *folder, int newest, Log *log, Error *error) {
  Status status;
  int *numbers = NULL;
  size_t count;
  Text path = {0};
  TRY(snapshot_list(folder, &numbers, &count, error));
  for (size_t k = 0; k < count && numbers[k] <= newest; k++) {
    double t;
    text_free(&path);
    TRY(snapshot_path(&path, folder, numbers[k], error));
    status = snapshot_read_scene(path.data, NULL, &t, error);
    if (status == STATUS_OK)
      TRY(put_entry(series, numbers[k], t, error));
    else if (status == STATUS_IO)
      log_warning(log, "%s", error->text);
    else
      goto cleanup;
  }
  status = STATUS_OK;
cleanup:
  text_free(&path);
  array_free(numbers);
  return status;
}

/* --- series.xdmf --- */

/* A field of a snapshot as the format names it. */
typedef struct {
  const char *name, *center, *group; /* "Node", "PointData" or "Cell", "CellData" */
  int components, count;
} Attribute;

static Status print_attribute(Text *xml, const char *file, Attribute attribute, Error *error) {
  Status status;
  const int components = attribute.components;
  TRY(text_append(xml, error, "        <Attribute Name=\"%s\" AttributeType=\"%s\" Center=\"%s\">\n",
                  attribute.name, components == 1 ? "Scalar" : "Vector", attribute.center));
  TRY(text_append(xml, error, "          <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" "));
  TRY(text_append(xml, error, components == 1 ? "Dimensions=\"%d\"" : "Dimensions=\"%d %d\"", attribute.count,
                  components));
  TRY(text_append(xml, error, ">%s:/VTKHDF/%s/%s</DataItem>\n        </Attribute>\n", file, attribute.group,
                  attribute.name));
cleanup:
  return status;
}

static Status print_attributes(Text *xml, const char *file, const Snapshot *snapshot, Error *error) {
  Status status;
  Attribute nodes = {"X", "Node", "PointData", 3, snapshot->mesh->n_nodes};
  Attribute cells = {"", "Cell", "CellData", 1, snapshot->mesh->n_elements};
  TRY(print_attribute(xml, file, nodes, error));
  for (size_t k = 0; k < snapshot->n_fields; k++) {
    nodes.name = snapshot->fields[k].name;
    nodes.components = snapshot->fields[k].components;
    TRY(print_attribute(xml, file, nodes, error));
  }
  for (size_t k = 0; k < snapshot->n_cells; k++) {
    cells.name = snapshot->cells[k].name;
    TRY(print_attribute(xml, file, cells, error));
  }
cleanup:
  return status;
}

/* `Triangle_6` is the name that XDMF 2 and 3 share; its node order is that of mesh.h. */
static Status print_grid(Text *xml, const SeriesEntry *entry, const Snapshot *snapshot, Error *error) {
  Status status;
  const Mesh *mesh = snapshot->mesh;
  char time[NUMBER_SIZE];
  Text file = {0};
  number_print(entry->t, time);
  TRY(snapshot_path(&file, "", entry->number, error));
  TRY(text_append(
      xml, error,
      "      <Grid Name=\"capsule\" GridType=\"Uniform\">\n"
      "        <Time Value=\"%s\"/>\n"
      "        <Topology TopologyType=\"Triangle_6\" NumberOfElements=\"%d\">\n"
      "          <DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"8\" Dimensions=\"%d\">"
      "%s:/VTKHDF/Connectivity</DataItem>\n"
      "        </Topology>\n"
      "        <Geometry GeometryType=\"XYZ\">\n"
      "          <DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"%d 3\">"
      "%s:/VTKHDF/Points</DataItem>\n"
      "        </Geometry>\n",
      time, mesh->n_elements, 6 * mesh->n_elements, file.data, mesh->n_nodes, file.data));
  TRY(print_attributes(xml, file.data, snapshot, error));
  TRY(text_append(xml, error, "      </Grid>\n"));
cleanup:
  text_free(&file);
  return status;
}

static Status print_xdmf(const Series *series, const Snapshot *snapshot, Text *xml, Error *error) {
  Status status;
  TRY(text_append(xml, error,
                  "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
                  "<Xdmf Version=\"3.0\">\n"
                  "  <Domain>\n"
                  "    <Grid Name=\"series\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"));
  for (size_t k = 0; k < series->count; k++) TRY(print_grid(xml, &series->entry[k], snapshot, error));
  TRY(text_append(xml, error, "    </Grid>\n  </Domain>\n</Xdmf>\n"));
cleanup:
  return status;
}

/* --- snapshots.hdf.series --- */

static Status print_file_series(const Series *series, Text *text, Error *error) {
  Json json;
  Text file = {0};
  Status status = STATUS_OK;
  json_begin(&json, text, error);
  json_open_object(&json, NULL);
  json_string(&json, "file-series-version", "1.0");
  json_open_array(&json, "files");
  for (size_t k = 0; k < series->count; k++) {
    text_free(&file);
    TRY(snapshot_path(&file, "", series->entry[k].number, error));
    json_open_object(&json, NULL);
    json_string(&json, "name", file.data);
    json_number(&json, "time", series->entry[k].t);
    json_close(&json);
  }
  json_close(&json);
  json_close(&json);
  status = json_end(&json);
cleanup:
  text_free(&file);
  return status;
}

static Status write_text(const char *folder, const char *name, const Text *text, Error *error) {
  Text path = {0};
  Status status = file_join(&path, folder, name, error);
  if (status == STATUS_OK) status = file_write(path.data, text->data, text->length, error);
  text_free(&path);
  return status;
}

Status series_add(Series *series, const char *folder, int number, const Snapshot *snapshot, Error *error) {
  Status status;
  Text xdmf = {0}, file_series = {0};
  TRY(put_entry(series, number, snapshot->t, error));
  TRY(print_xdmf(series, snapshot, &xdmf, error));
  TRY(write_text(folder, "series.xdmf", &xdmf, error));
  TRY(print_file_series(series, &file_series, error));
  TRY(write_text(folder, "snapshots.hdf.series", &file_series, error));
cleanup:
  text_free(&file_series);
  text_free(&xdmf);
  return status;
}
