/* A snapshot with bytes changed, or one of odd parts.  What the input is, its first byte says:
 * odd: the rest is the whole file;
 * 2 more than a multiple of 4: the rest lists what is in the file, four bytes for each part, and HDF5 writes
 * it, so that what stands behind HDF5 is met with files that are sound but not those of a run; else: the rest
 * is a list of changes, three bytes for the place and one for the value, to a good snapshot. The last two are
 * sealed, so that what stands behind the checksum is met as well. */
#include "base/array.h"
#include "base/file.h"
#include "fuzz.h"
#include "mesh/mesh.h"
#include "observe/hdf.h"
#include "observe/seal.h"
#include "observe/snapshot.h"
#include <math.h>
#include <string.h>

/* Of HDF5: how much of what it frees it keeps for itself.  Without a limit (-1), an input takes half the time. */
int H5set_free_list_limits(int, int, int, int, int, int);

static double state[4] = {1, 2, 3, 4};
static long long count = 5;
static const RestartItem ITEMS[] = {{.name = "state", .count = 4, .doubles = state},
                                    {.name = "count", .count = 1, .integers = &count}};

static void must(Status status) {
  if (status != STATUS_OK) abort();
}

/* A good snapshot of 20 elements, written once. */
static const Text *good_snapshot(void) {
  static Text image;
  if (image.data) return &image;
  Error error;
  Mesh mesh;
  const char *path = fuzz_file("", 0);
  must(mesh_sphere(&mesh, 0, NULL, &error));
  const SnapshotField field = {.name = "q", .components = 3, .values = mesh.X};
  const Snapshot snapshot = {.mesh = &mesh,
                             .t = 0.5,
                             .x = mesh.X,
                             .fields = &field,
                             .n_fields = 1,
                             .restart = ITEMS,
                             .n_restart = 2,
                             .scene = "schema: 1\n"};
  char sibling[64];
  snprintf(sibling, sizeof sibling, "%s.good", path);
  must(snapshot_write(sibling, &snapshot, &error));
  must(file_read(sibling, 1 << 24, &image, &error));
  remove(sibling);
  mesh_free(&mesh);
  return &image;
}

static const char *changed_file(const uint8_t *data, size_t size) {
  const Text *good = good_snapshot();
  char *file = malloc(good->length);
  if (!file) abort();
  memcpy(file, good->data, good->length);
  const size_t body = good->length - SEAL_SIZE;
  for (size_t i = 0; i + 4 <= size; i += 4) {
    const size_t place = ((size_t)data[i] << 16 | (size_t)data[i + 1] << 8 | data[i + 2]) % body;
    file[SEAL_SIZE + place] = (char)data[i + 3];
  }
  seal_make(file + SEAL_SIZE, body, file);
  const char *path = fuzz_file(file, good->length);
  free(file);
  return path;
}

/* ---- of odd parts ---- */

/* Where a snapshot has something, and what else may be there. */
static const char *const PLACES[] = {
    "/VTKHDF/Points",
    "/VTKHDF/Connectivity",
    "/VTKHDF/PointData/x",
    "/VTKHDF/PointData/X",
    "/VTKHDF/PointData/d",
    "/VTKHDF/PointData",
    "/restart/t",
    "/restart/scene",
    "/restart/arrays",
    "/restart/arrays/state",
    "/restart/arrays/count",
    "/restart/arrays/more",
    "/VTKHDF",
    "/VTKHDF/PointData/d/of/groups",
    "/restart",
    "/VTKHDF/PointData/a_name_that_is_longer_than_all_that_a_field_may_have"};
enum { N_PLACES = sizeof PLACES / sizeof *PLACES, MOST_VALUES = 255 * 7 };

/* One part: place, kind and columns, rows, and the value that fills it.  What HDF5 refuses to write is left
 * out. */
static void put_part(Hdf *hdf, const uint8_t part[4]) {
  static double doubles[MOST_VALUES];
  static long long integers[MOST_VALUES];
  static int small[MOST_VALUES];
  const char *path = PLACES[part[0] % N_PLACES];
  const unsigned kind = part[1] % 8;
  const size_t columns = part[1] / 8 % 8, rows = part[2];
  const int value = (signed char)part[3];
  char text[] = "schema: 1\n";
  Error error;
  for (size_t k = 0; k < rows * (columns ? columns : 1); k++) {
    doubles[k] = value == -128 ? NAN : value * (1 + 0.1 * (double)k);
    integers[k] = value;
    small[k] = value < 0 ? -value + (int)k : (int)k % (value + 1);
  }
  switch (kind) {
  case 0:
    (void)!hdf_write(hdf, path, HDF_LONG_LONG, rows, columns, integers, &error);
    break;
  case 1:
  case 2:
    (void)!hdf_write(hdf, path, HDF_INT, rows, columns, small, &error);
    break;
  case 3:
    (void)!hdf_write(hdf, path, HDF_BYTE, rows, columns, integers, &error);
    break;
  case 4:
    text[rows % sizeof text] = 0;
    (void)!hdf_write_text(hdf, path, text, &error);
    break;
  case 5:
    (void)!hdf_link(hdf, path, PLACES[part[2] % N_PLACES], &error);
    break;
  default:
    (void)!hdf_write(hdf, path, HDF_DOUBLE, rows, columns, doubles, &error);
  }
}

static const char *file_of_parts(const uint8_t *data, size_t size) {
  Error error;
  Hdf *hdf;
  char *image;
  size_t length;
  must(hdf_new(&hdf, SEAL_SIZE, &error));
  for (size_t i = 0; i + 4 <= size; i += 4) put_part(hdf, data + i);
  must(hdf_image(hdf, &image, &length, &error));
  seal_make(image + SEAL_SIZE, length - SEAL_SIZE, image);
  const char *path = fuzz_file(image, length);
  array_free(image);
  hdf_free(hdf);
  return path;
}

static const char *make_file(const uint8_t *data, size_t size) {
  if (size == 0) return changed_file(data, 0);
  if (data[0] % 2 == 1) return fuzz_file(data + 1, size - 1);
  return data[0] % 4 == 2 ? file_of_parts(data + 1, size - 1) : changed_file(data + 1, size - 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static bool is_set;
  if (!is_set) is_set = H5set_free_list_limits(-1, -1, -1, -1, -1, -1) >= 0;
  const char *path = make_file(data, size);
  Error error = {0};
  SnapshotGrid grid;
  Text scene = {0};
  double t;
  if (snapshot_read_grid(path, &grid, &error) == STATUS_OK)
    snapshot_grid_free(&grid);
  else if (!error.text[0])
    abort();
  (void)!snapshot_read_scene(path, &scene, &t, &error);
  (void)!snapshot_read_restart(path, ITEMS, 2, &error);
  text_free(&scene);
  return 0;
}
