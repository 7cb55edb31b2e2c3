/* Snapshots: what a restart reads is bit for bit what was written, or nothing. */
#include "observe/snapshot.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/hdf.h"
#include "scratch.h"
#include "suite.h"
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

static const char SCENE[] = "schema: 1\nname: caf\xc3\xa9 # with a comment\n";
enum { N_ITEMS = 4, N_ARRAY = 5, N_FIELDS = 3 };

/* The state of a run as far as snapshots go. */
typedef struct {
  double array[N_ARRAY], none[1];
  long long counts[2];
  double scalar;
  RestartItem items[N_ITEMS];
} State;

static void list_items(State *state) {
  state->items[0] = (RestartItem){"Ymax", N_ARRAY, state->array, NULL};
  state->items[1] = (RestartItem){"counts", 2, NULL, state->counts};
  state->items[2] = (RestartItem){"dissipated", 1, &state->scalar, NULL};
  state->items[3] = (RestartItem){"empty", 0, state->none, NULL};
}

static void make_state(State *state) {
  *state = (State){
      .array = {1.0 / 3, -0.0, 5e-324, NAN, -HUGE_VAL}, .counts = {LLONG_MIN, LLONG_MAX}, .scalar = 0.1};
  list_items(state);
}

static Mesh mesh;
static double *x, *field;

static void make_mesh(void) {
  Error error;
  if (mesh.n_nodes) return; /* made by an earlier test of an unforked run */
  ck_assert_int_eq(mesh_sphere(&mesh, 1, NULL, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&x, 3 * mesh.n_nodes, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&field, mesh.n_nodes, &error), STATUS_OK);
  for (int k = 0; k < 3 * mesh.n_nodes; k++) x[k] = 1.1 * mesh.X[k] + 0.01 * k;
  for (int k = 0; k < mesh.n_nodes; k++) field[k] = 0.3 * k;
}

static Status write_state(const char *path, const State *state, Error *error) {
  make_mesh();
  const SnapshotField fields[N_FIELDS] = {{"q", 3, x}, {"velocity", 3, mesh.X}, {"d", 1, field}};
  const SnapshotCells cells[] = {{"damage_Y_C", field}};
  const Snapshot snapshot = {.mesh = &mesh,
                             .t = 0.1,
                             .x = x,
                             .fields = fields,
                             .n_fields = N_FIELDS,
                             .cells = cells,
                             .n_cells = 1,
                             .restart = state->items,
                             .n_restart = N_ITEMS,
                             .scene = SCENE};
  return snapshot_write(path, &snapshot, error);
}

static const char *numbered(int number) {
  char name[64];
  snprintf(name, sizeof name, "snapshot_%06d.vtkhdf", number);
  return scratch_path(name);
}

static void write_number(int number) {
  Error error;
  State state;
  make_state(&state);
  ck_assert_msg(write_state(numbered(number), &state, &error) == STATUS_OK, "%s", error.text);
}

static Text bytes_of(const char *path) {
  Error error;
  Text text = {0};
  ck_assert_int_eq(file_read(path, 1 << 24, &text, &error), STATUS_OK);
  return text;
}

static void put_bytes(const char *path, const char *bytes, size_t length) {
  FILE *file = fopen(path, "wb");
  ck_assert_uint_eq(fwrite(bytes, 1, length, file), length);
  fclose(file);
}

START_TEST(the_restart_reads_back_bit_for_bit) {
  Error error;
  State written, read = {0};
  Text scene = {0};
  double t;
  make_state(&written);
  list_items(&read);
  write_number(7);
  ck_assert_int_eq(snapshot_read_restart(numbered(7), read.items, N_ITEMS, &error), STATUS_OK);
  ck_assert_mem_eq(read.array, written.array, sizeof read.array);
  ck_assert_mem_eq(read.counts, written.counts, sizeof read.counts);
  ck_assert(read.scalar == written.scalar);
  ck_assert_int_eq(snapshot_read_scene(numbered(7), &scene, &t, &error), STATUS_OK);
  ck_assert_str_eq(scene.data, SCENE);
  ck_assert(t == 0.1);
  text_free(&scene);
}
END_TEST

START_TEST(equal_states_give_equal_files_and_nothing_else_is_left) {
  scratch_empty();
  write_number(1);
  write_number(2);
  Text first = bytes_of(numbered(1)), second = bytes_of(numbered(2));
  ck_assert_uint_eq(first.length, second.length);
  ck_assert_mem_eq(first.data, second.data, first.length);
  text_free(&first);
  text_free(&second);
  int *numbers;
  size_t count;
  Error error;
  ck_assert_int_eq(snapshot_list(scratch_folder, &numbers, &count, &error), STATUS_OK);
  ck_assert_uint_eq(count, 2);
  ck_assert(numbers[0] == 1 && numbers[1] == 2);
  array_free(numbers);
}
END_TEST

static double *read_doubles(Hdf *hdf, const char *path, size_t expected) {
  Error error;
  HdfType type;
  size_t count;
  double *values;
  ck_assert_int_eq(hdf_describe(hdf, path, &type, &count, &error), STATUS_OK);
  ck_assert_int_eq(type, HDF_DOUBLE);
  ck_assert_uint_eq(count, expected);
  ck_assert_int_eq(ARRAY_NEW(&values, count, &error), STATUS_OK);
  ck_assert_int_eq(hdf_read(hdf, path, HDF_DOUBLE, count, values, &error), STATUS_OK);
  return values;
}

static void holds(Hdf *hdf, const char *path, const double *expected, size_t count) {
  double *values = read_doubles(hdf, path, count);
  ck_assert_msg(memcmp(values, expected, count * sizeof *values) == 0, "%s", path);
  array_free(values);
}

/* Names and shapes as the VTKHDF 1.0 specification has them for an UnstructuredGrid. */
START_TEST(the_grid_is_quadratic_triangles_with_fields_at_nodes_and_cells) {
  Error error;
  Hdf *hdf;
  write_number(3);
  Text file = bytes_of(numbered(3));
  ck_assert_int_eq(hdf_open(&hdf, file.data, file.length, &error), STATUS_OK);
  const size_t n = (size_t)mesh.n_nodes, cells = (size_t)mesh.n_elements;
  holds(hdf, "/VTKHDF/Points", x, 3 * n);
  holds(hdf, "/VTKHDF/PointData/x", x, 3 * n);
  holds(hdf, "/VTKHDF/PointData/X", mesh.X, 3 * n);
  holds(hdf, "/VTKHDF/PointData/q", x, 3 * n);
  holds(hdf, "/VTKHDF/PointData/velocity", mesh.X, 3 * n);
  holds(hdf, "/VTKHDF/PointData/d", field, n);
  holds(hdf, "/VTKHDF/CellData/damage_Y_C", field, cells);
  holds(hdf, "/VTKHDF/FieldData/TimeValue", (const double[]){0.1}, 1);
  long long *ids, *offsets, sizes[3];
  unsigned char *types;
  ck_assert_int_eq(ARRAY_NEW(&ids, 6 * cells, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&offsets, cells + 1, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&types, cells, &error), STATUS_OK);
  ck_assert_int_eq(hdf_read(hdf, "/VTKHDF/NumberOfPoints", HDF_LONG_LONG, 1, &sizes[0], &error), STATUS_OK);
  ck_assert_int_eq(hdf_read(hdf, "/VTKHDF/NumberOfCells", HDF_LONG_LONG, 1, &sizes[1], &error), STATUS_OK);
  ck_assert_int_eq(hdf_read(hdf, "/VTKHDF/NumberOfConnectivityIds", HDF_LONG_LONG, 1, &sizes[2], &error),
                   STATUS_OK);
  ck_assert_int_eq(hdf_read(hdf, "/VTKHDF/Connectivity", HDF_LONG_LONG, 6 * cells, ids, &error), STATUS_OK);
  ck_assert_int_eq(hdf_read(hdf, "/VTKHDF/Offsets", HDF_LONG_LONG, cells + 1, offsets, &error), STATUS_OK);
  ck_assert_int_eq(hdf_read(hdf, "/VTKHDF/Types", HDF_BYTE, cells, types, &error), STATUS_OK);
  ck_assert(sizes[0] == (long long)n && sizes[1] == (long long)cells && sizes[2] == (long long)(6 * cells));
  for (size_t e = 0; e < cells; e++) {
    ck_assert_int_eq(types[e], 22); /* VTK_QUADRATIC_TRIANGLE: corners, then the edges 01, 12, 20 */
    for (int k = 0; k < 6; k++) ck_assert_int_eq(ids[6 * e + (size_t)k], mesh.element[e][k]);
    ck_assert_int_eq(offsets[e + 1], 6 * (long long)(e + 1));
  }
  array_free(types);
  array_free(offsets);
  array_free(ids);
  hdf_free(hdf);
  text_free(&file);
}
END_TEST

static void is_refused_as_damaged(const char *path) {
  Error error;
  State read;
  make_state(&read);
  read.scalar = 42;
  ck_assert_int_eq(snapshot_read_restart(path, read.items, N_ITEMS, &error), STATUS_IO);
  ck_assert_msg(strncmp(error.text, path, strlen(path)) == 0, "%s", error.text);
  ck_assert(read.scalar == 42);
}

START_TEST(a_file_cut_off_anywhere_is_refused) {
  write_number(4);
  Text file = bytes_of(numbered(4));
  for (size_t length = 0; length < file.length; length += length < 600 ? 1 : 97) {
    put_bytes(scratch_path("cut"), file.data, length);
    is_refused_as_damaged(scratch_path("cut"));
  }
  put_bytes(scratch_path("cut"), file.data, file.length - 1);
  is_refused_as_damaged(scratch_path("cut"));
  text_free(&file);
}
END_TEST

START_TEST(a_file_with_one_flipped_bit_is_refused) {
  uint64_t state = 424242; /* seed of xorshift64 */
  write_number(5);
  Text file = bytes_of(numbered(5));
  for (int trial = 0; trial < 1000; trial++) {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    const size_t place = (size_t)(state / 8 % file.length);
    const char mask = (char)(1U << state % 8);
    file.data[place] ^= mask;
    put_bytes(scratch_path("flipped"), file.data, file.length);
    is_refused_as_damaged(scratch_path("flipped"));
    file.data[place] ^= mask;
  }
  text_free(&file);
}
END_TEST

START_TEST(a_snapshot_of_another_scene_is_an_input_error_and_touches_nothing) {
  Error error;
  State read;
  write_number(6);
  const struct {
    int item;
    RestartItem instead;
    const char *words;
  } wrong[] = {{0, {"Ymax", N_ARRAY + 1, read.array, NULL}, "array `Ymax`: expected 6 values, found 5"},
               {1, {"counts", 2, read.array, NULL}, "array `counts`: expected doubles, found another type"},
               {2, {"other", 1, &read.scalar, NULL}, "expected the array `other`, found none"}};
  for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
    make_state(&read);
    read.scalar = 42;
    read.items[wrong[k].item] = wrong[k].instead;
    ck_assert_int_eq(snapshot_read_restart(numbered(6), read.items, N_ITEMS, &error), STATUS_INPUT);
    ck_assert_msg(strstr(error.text, wrong[k].words) && strstr(error.text, "resolved.yaml"), "%s",
                  error.text);
    ck_assert(read.scalar == 42);
  }
  make_state(&read);
  ck_assert_int_eq(snapshot_read_restart(numbered(6), read.items, N_ITEMS - 1, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, "found the array `empty`, which this scene does not have"), "%s",
                error.text);
}
END_TEST

START_TEST(a_missing_file_and_a_folder_that_cannot_be_written_are_errors) {
  Error error;
  State state;
  make_state(&state);
  ck_assert_int_eq(snapshot_read_restart(scratch_path("missing"), state.items, N_ITEMS, &error), STATUS_IO);
  ck_assert_int_eq(write_state(scratch_path("no/snapshot"), &state, &error), STATUS_IO);
}
END_TEST

static void newest_is(int expected, long warnings) {
  Error error;
  Text path = {0};
  Log log = {.quiet = true};
  int number;
  ck_assert_int_eq(snapshot_find_newest(scratch_folder, &path, &number, &log, &error), STATUS_OK);
  ck_assert_int_eq(number, expected);
  ck_assert_int_eq(log.warnings, warnings);
  if (expected < 0)
    ck_assert_uint_eq(path.length, 0);
  else
    ck_assert_str_eq(path.data, numbered(expected));
  text_free(&path);
}

START_TEST(the_newest_whole_snapshot_is_found) {
  scratch_empty();
  newest_is(-1, 0);
  write_number(0);
  newest_is(0, 0);
  write_number(12);
  write_number(9);
  newest_is(12, 0);
  put_bytes(numbered(13), "Capsella snapshot", 17); /* the disk was full */
  newest_is(12, 1);
  Text file = bytes_of(numbered(12));
  put_bytes(numbered(12), file.data, file.length / 2);
  text_free(&file);
  newest_is(9, 2);
  put_bytes(scratch_path("snapshot_000099.vtkhdf.part"), "x", 1);
  put_bytes(scratch_path("snapshot_99.vtkhdf"), "x", 1);
  put_bytes(scratch_path("snapshot_00009x.vtkhdf"), "x", 1);
  put_bytes(scratch_path("snapshot_-00001.vtkhdf"), "x", 1);
  newest_is(9, 2);
  write_number(1000000); /* seven digits */
  newest_is(1000000, 0);
  scratch_empty();
}
END_TEST

START_TEST(a_folder_that_is_not_there_is_an_error) {
  Error error;
  Text path = {0};
  int number;
  ck_assert_int_eq(snapshot_find_newest(scratch_path("missing"), &path, &number, NULL, &error), STATUS_IO);
  ck_assert_int_eq(number, -1);
}
END_TEST

/* Each allocation of the library fails in turn; the last round succeeds. */
START_TEST(running_out_of_memory_is_told_and_leaves_nothing_behind) {
  Error error;
  State state;
  Status status = STATUS_MEMORY;
  long rounds = 0;
  make_mesh();
  make_state(&state);
  scratch_empty();
  while (status != STATUS_OK) {
    array_fail_nth(++rounds);
    status = write_state(numbered(8), &state, &error);
    if (status == STATUS_OK) break;
    ck_assert_int_eq(status, STATUS_MEMORY);
    ck_assert(!file_exists(numbered(8)));
  }
  ck_assert_int_gt(rounds, 5);
  for (rounds = 1, status = STATUS_MEMORY; status != STATUS_OK; rounds++) {
    array_fail_nth(rounds);
    status = snapshot_read_restart(numbered(8), state.items, N_ITEMS, &error);
    if (status != STATUS_OK) ck_assert_int_eq(status, STATUS_MEMORY);
  }
  array_fail_nth(0);
  ck_assert_int_gt(rounds, 5);
}
END_TEST

static void same_field(const SnapshotGrid *grid, const char *name, int components, const double *values) {
  const GridField *found = snapshot_grid_find(grid, name);
  ck_assert_msg(found != NULL, "%s", name);
  ck_assert_int_eq(found->components, components);
  ck_assert_mem_eq(found->values, values, (size_t)(components * mesh.n_nodes) * sizeof *values);
}

START_TEST(the_grid_reads_back_bit_for_bit) {
  Error error;
  SnapshotGrid grid;
  write_number(3);
  ck_assert_msg(snapshot_read_grid(numbered(3), &grid, &error) == STATUS_OK, "%s", error.text);
  ck_assert(grid.t == 0.1);
  ck_assert_int_eq(grid.n_nodes, mesh.n_nodes);
  ck_assert_int_eq(grid.n_elements, mesh.n_elements);
  ck_assert_mem_eq(grid.element, mesh.element, (size_t)mesh.n_elements * sizeof *mesh.element);
  ck_assert_uint_eq(grid.n_fields, 5);
  same_field(&grid, "X", 3, mesh.X);
  same_field(&grid, "x", 3, x);
  same_field(&grid, "q", 3, x);
  same_field(&grid, "velocity", 3, mesh.X);
  same_field(&grid, "d", 1, field);
  ck_assert_ptr_null(snapshot_grid_find(&grid, "T1"));
  snapshot_grid_free(&grid);
}
END_TEST

START_TEST(a_grid_that_is_missing_or_altered_is_told) {
  Error error;
  SnapshotGrid grid;
  ck_assert_int_eq(snapshot_read_grid(scratch_path("missing"), &grid, &error), STATUS_IO);
  write_number(3);
  Text file = bytes_of(numbered(3));
  file.data[file.length / 2] ^= 1;
  put_bytes(numbered(4), file.data, file.length);
  ck_assert_int_eq(snapshot_read_grid(numbered(4), &grid, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "snapshot_000004"));
  ck_assert_uint_eq(grid.n_fields, 0);
  text_free(&file);
}
END_TEST

START_TEST(a_grid_without_memory_is_told) {
  Error error;
  SnapshotGrid grid;
  Status status = STATUS_MEMORY;
  int rounds = 0;
  write_number(3);
  while (status != STATUS_OK) {
    array_fail_nth(++rounds);
    status = snapshot_read_grid(numbered(3), &grid, &error);
    if (status != STATUS_OK) ck_assert_int_eq(status, STATUS_MEMORY);
  }
  array_fail_nth(0);
  snapshot_grid_free(&grid);
  ck_assert_int_gt(rounds, 5);
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  int result = suite_run(
      "snapshot",
      (SuiteTests){the_restart_reads_back_bit_for_bit, equal_states_give_equal_files_and_nothing_else_is_left,
                   the_grid_is_quadratic_triangles_with_fields_at_nodes_and_cells,
                   a_file_cut_off_anywhere_is_refused, a_file_with_one_flipped_bit_is_refused,
                   a_snapshot_of_another_scene_is_an_input_error_and_touches_nothing,
                   a_missing_file_and_a_folder_that_cannot_be_written_are_errors,
                   the_newest_whole_snapshot_is_found, a_folder_that_is_not_there_is_an_error,
                   running_out_of_memory_is_told_and_leaves_nothing_behind, the_grid_reads_back_bit_for_bit,
                   a_grid_that_is_missing_or_altered_is_told, a_grid_without_memory_is_told, NULL});
  scratch_remove();
  array_free(x);
  array_free(field);
  mesh_free(&mesh);
  return result;
}
