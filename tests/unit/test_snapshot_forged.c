/* Snapshots whose seal is whole and whose contents are not those of a run: what reads them says what is
 * wrong. */
#include "base/array.h"
#include "observe/hdf.h"
#include "observe/seal.h"
#include "observe/snapshot.h"
#include "run/maps.h"
#include "run/report_picture.h"
#include "run/run_page.h"
#include "study/sites.h"
#include "study_file.h"
#include "suite.h"
#include <math.h>

enum { NODES = 6, MOST_FIELDS = GRID_MAX_FIELDS + 4 };

/* One element with its six nodes, but for what a test puts in its place. */
typedef struct {
  size_t n_coordinates, n_ids, n_values; /* values of the fields that have one component */
  int node;                              /* the last that the element names */
  const char *fields[MOST_FIELDS];       /* "x" and "X" have three components */
} Forgery;

static const Forgery WHOLE = {3 * NODES, 6, NODES, NODES - 1, {"x", "X", "d"}};

static void write_field(Hdf *hdf, const char *name, size_t n_values) {
  static const double at[3 * NODES] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0};
  Error error;
  char path[256];
  const bool is_position = name[0] == 'x' || name[0] == 'X';
  snprintf(path, sizeof path, "/VTKHDF/PointData/%s", name);
  ck_assert_int_eq(
      hdf_write(hdf, path, HDF_DOUBLE, is_position ? NODES : n_values, is_position ? 3 : 0, at, &error),
      STATUS_OK);
}

static const char *forge(const Forgery *forgery) {
  Error error;
  Hdf *hdf;
  char *image;
  size_t length;
  const double coordinates[4 * NODES] = {0}, t = 0.5;
  const int ids[8] = {0, 1, 2, 3, 4, forgery->node};
  const char *path = scratch_path("snapshot_000000.vtkhdf");
  ck_assert_int_eq(hdf_new(&hdf, SEAL_SIZE, &error), STATUS_OK);
  ck_assert_int_eq(
      hdf_write(hdf, "/VTKHDF/Points", HDF_DOUBLE, forgery->n_coordinates, 0, coordinates, &error),
      STATUS_OK);
  ck_assert_int_eq(hdf_write(hdf, "/VTKHDF/Connectivity", HDF_INT, forgery->n_ids, 0, ids, &error),
                   STATUS_OK);
  for (int k = 0; k < MOST_FIELDS && forgery->fields[k]; k++)
    write_field(hdf, forgery->fields[k], forgery->n_values);
  ck_assert_int_eq(hdf_write(hdf, "/restart/t", HDF_DOUBLE, 1, 0, &t, &error), STATUS_OK);
  ck_assert_int_eq(hdf_image(hdf, &image, &length, &error), STATUS_OK);
  seal_make(image + SEAL_SIZE, length - SEAL_SIZE, image);
  ck_assert_int_eq(file_write(path, image, length, &error), STATUS_OK);
  array_free(image);
  hdf_free(hdf);
  return path;
}

START_TEST(one_element_can_be_read) {
  SnapshotGrid grid;
  Error error;
  const Status status = snapshot_read_grid(forge(&WHOLE), &grid, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  ck_assert_int_eq(grid.n_elements, 1);
  ck_assert_int_eq(grid.n_nodes, NODES);
  ck_assert_uint_eq(grid.n_fields, 3);
  snapshot_grid_free(&grid);
}
END_TEST

/* The whole forgery with ASSIGNMENT to `f` is refused with these words. */
#define EXPECT_REFUSED(assignment, words)                                                                    \
  do {                                                                                                       \
    SnapshotGrid grid;                                                                                       \
    Error error = {.text = "nothing"};                                                                       \
    Forgery f = WHOLE;                                                                                       \
    assignment;                                                                                              \
    ck_assert_int_eq(snapshot_read_grid(forge(&f), &grid, &error), STATUS_IO);                               \
    expect_words(&error, words);                                                                             \
    ck_assert_uint_eq(grid.n_fields, 0);                                                                     \
    ck_assert_ptr_null(grid.element);                                                                        \
  } while (0)

START_TEST(tables_that_do_not_fit_each_other_are_named) {
  EXPECT_REFUSED(f.n_coordinates = 17, "/VTKHDF/Points: expected rows of 3 values, found 17 values");
  EXPECT_REFUSED(f.n_coordinates = 0, "/VTKHDF/Points: expected rows of 3 values, found 0 values");
  EXPECT_REFUSED(f.n_ids = 7, "/VTKHDF/Connectivity: expected rows of 6 values, found 7 values");
  EXPECT_REFUSED(f.node = NODES, "element 0 names node 6 of 6");
  EXPECT_REFUSED(f.node = -1, "element 0 names node -1 of 6");
  EXPECT_REFUSED(f.n_values = 7, "/VTKHDF/PointData/d: expected rows of 6 values, found 7 values");
  EXPECT_REFUSED(f.fields[2] = "a_name_that_no_field_of_a_run_has", "expected a name of less than 32 bytes");
}
END_TEST

/* A run writes fewer; what is more has no place in the grid. */
START_TEST(of_more_fields_than_a_grid_holds_the_rest_is_left_out) {
  char name[MOST_FIELDS][8];
  SnapshotGrid grid;
  Error error;
  Forgery forgery = WHOLE;
  for (int k = 0; k < MOST_FIELDS; k++) {
    snprintf(name[k], sizeof name[k], "%c", 'A' + k);
    forgery.fields[k] = name[k];
  }
  ck_assert_int_eq(snapshot_read_grid(forge(&forgery), &grid, &error), STATUS_OK);
  ck_assert_uint_eq(grid.n_fields, GRID_MAX_FIELDS);
  for (int k = 0; k < GRID_MAX_FIELDS; k++) ck_assert_str_eq(grid.field[k].name, name[k]);
  snapshot_grid_free(&grid);
}
END_TEST

/* ---- Readers of a run's folder ---- */

static void begin_folder(const char *const *fields) {
  scratch_empty();
  scratch_write("resolved.yaml", "schema: 1\nmembrane: {law: neo_hookean}\n"
                                 "flow: {kind: simple_shear, capillary_number: 0.625}\ntime: {end: 1}\n");
  if (!fields) return;
  Forgery forgery = WHOLE;
  memcpy(forgery.fields, fields, sizeof forgery.fields);
  forge(&forgery);
}

static const char *const ALL[MOST_FIELDS] = {"x", "X", "d"}, *const NO_POSITIONS[MOST_FIELDS] = {"d"},
                         *const NO_DAMAGE[MOST_FIELDS] = {"x", "X", "Y"};

static void expect_no_picture(const char *field, Status code, const char *words) {
  Text svg = {0};
  Error error = {.text = "nothing"};
  const ReportChoice choice = {.field = field, .time = NAN};
  ck_assert_int_eq(report_picture(scratch_folder, &choice, &svg, &error), code);
  expect_words(&error, words);
  text_free(&svg);
}

START_TEST(a_picture_needs_positions_and_a_field_that_is_there) {
  begin_folder(NULL);
  expect_no_picture("d", STATUS_INPUT, "expected a snapshot of a run, found none that is whole");
  begin_folder(NO_POSITIONS);
  expect_no_picture("d", STATUS_IO, "snapshot_000000.vtkhdf: expected the fields x and X, found others");
  begin_folder(ALL);
  expect_no_picture("D", STATUS_INPUT, "snapshot_000000.vtkhdf: expected one of the fields d, found `D`");
}
END_TEST

static void expect_no_maps(const char *field, const char *view, size_t n_times, Status code,
                           const char *words) {
  Text svg = {0};
  Error error = {.text = "nothing"};
  const MapsOptions options = {.folders = {scratch_folder},
                               .n_folders = 1,
                               .n_times = n_times,
                               .fields = {field},
                               .n_fields = 1,
                               .views = {view},
                               .n_views = 1};
  ck_assert_int_eq(maps_print(&options, &svg, &error), code);
  expect_words(&error, words);
  text_free(&svg);
}

START_TEST(maps_need_positions_and_a_field_that_is_there) {
  const char *view = MAPS_VIEWS[0];
  begin_folder(NULL);
  expect_no_maps("d", view, 0, STATUS_INPUT, "expected a snapshot of a run, found none that is whole");
  expect_no_maps("d", view, 1, STATUS_INPUT, "expected snapshots, found none");
  begin_folder(NO_POSITIONS);
  expect_no_maps("d", view, 0, STATUS_IO, "expected the fields x and X, found others");
  begin_folder(NO_DAMAGE);
  expect_no_maps("d", view, 0, STATUS_IO, "expected the field d, found others");
  expect_no_maps("D", view, 0, STATUS_INPUT, "expected a field, one of `d`, `Y`, ..., found `D`");
}
END_TEST

START_TEST(a_page_leaves_out_a_state_without_positions) {
  Error error;
  Log log = {.quiet = true};
  begin_folder(NO_POSITIONS);
  ck_assert_int_eq(run_page_write(scratch_folder, &log, &error), STATUS_OK);
  ck_assert_int_eq(log.warnings, 1);
}
END_TEST

START_TEST(a_map_of_sites_needs_positions) {
  Error error;
  const Case item = {.folder = scratch_folder};
  begin_folder(NO_POSITIONS);
  ck_assert_int_eq(sites_write(&item, NULL, 0, scratch_folder, "", &error), STATUS_IO);
  expect_words(&error, "snapshot_000000.vtkhdf: expected the fields X and x, found none");
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  const int failed = suite_run(
      "snapshot_forged",
      (SuiteTests){one_element_can_be_read, tables_that_do_not_fit_each_other_are_named,
                   of_more_fields_than_a_grid_holds_the_rest_is_left_out,
                   a_picture_needs_positions_and_a_field_that_is_there,
                   maps_need_positions_and_a_field_that_is_there, a_page_leaves_out_a_state_without_positions,
                   a_map_of_sites_needs_positions, NULL});
  scratch_remove();
  return failed;
}
