/* A snapshot with bytes changed.  Where the input is odd at its start, the rest is the whole file; otherwise
 * it is a list of changes, three bytes for the place and one for the value, to a good snapshot that is sealed
 * anew after: so that what stands behind the checksum is met as well. */
#include "base/file.h"
#include "fuzz.h"
#include "mesh/mesh.h"
#include "observe/seal.h"
#include "observe/snapshot.h"
#include <string.h>

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

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const bool is_whole = size > 0 && data[0] % 2 == 1;
  const char *path =
      is_whole ? fuzz_file(data + 1, size - 1) : changed_file(data + (size > 0), size - (size > 0));
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
