/* The two indexes of a folder's snapshots. */
#include "observe/series.h"

#include "base/array.h"
#include "base/file.h"
#include "markup.h"
#include "scratch.h"
#include "suite.h"
#include <string.h>

static Status add(Series *series, int number, double t, Error *error) {
  Mesh mesh;
  ck_assert_int_eq(mesh_sphere(&mesh, 0, NULL, error), STATUS_OK);
  const SnapshotField fields[] = {{"q", 3, mesh.X}, {"d", 1, mesh.X}};
  const Snapshot snapshot = {
      .mesh = &mesh, .t = t, .x = mesh.X, .fields = fields, .n_fields = 2, .scene = ""};
  Text path = {0};
  ck_assert_int_eq(snapshot_path(&path, scratch_folder, number, error), STATUS_OK);
  ck_assert_int_eq(snapshot_write(path.data, &snapshot, error), STATUS_OK);
  text_free(&path);
  Status status = series_add(series, scratch_folder, number, &snapshot, error);
  mesh_free(&mesh);
  return status;
}

static void added(Series *series, int number, double t) {
  Error error;
  ck_assert_int_eq(add(series, number, t, &error), STATUS_OK);
}

static Text content(const char *name) {
  Error error;
  Text text = {0};
  ck_assert_int_eq(file_read(scratch_path(name), 1 << 20, &text, &error), STATUS_OK);
  return text;
}

static int occurrences(const Text *text, const char *word) {
  int count = 0;
  for (const char *at = text->data; (at = strstr(at, word)); at++) count++;
  return count;
}

START_TEST(the_xdmf_refers_to_the_datasets_of_each_snapshot) {
  Series series = {0};
  added(&series, 0, 0);
  added(&series, 1, 0.1);
  Text xdmf = content("series.xdmf");
  ck_assert_int_eq(occurrences(&xdmf, "<Grid Name=\"capsule\""), 2);
  ck_assert_int_eq(occurrences(&xdmf, "<Topology TopologyType=\"Triangle_6\" NumberOfElements=\"20\">"), 2);
  const char *const parts[] = {
      "<Time Value=\"0\"/>",
      "<Time Value=\"0.1\"/>",
      "Dimensions=\"120\">snapshot_000001.vtkhdf:/VTKHDF/Connectivity<",
      "Dimensions=\"42 3\">snapshot_000001.vtkhdf:/VTKHDF/Points<",
      "Dimensions=\"42 3\">snapshot_000001.vtkhdf:/VTKHDF/PointData/X<",
      "Dimensions=\"42 3\">snapshot_000001.vtkhdf:/VTKHDF/PointData/q<",
      "Dimensions=\"42\">snapshot_000001.vtkhdf:/VTKHDF/PointData/d<",
  };
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    ck_assert_msg(occurrences(&xdmf, parts[k]) == 1, "%s", parts[k]);
  text_free(&xdmf);
  series_free(&series);
}
END_TEST

START_TEST(the_file_series_lists_names_and_times) {
  Series series = {0};
  added(&series, 0, 0);
  added(&series, 1, 0.1);
  Text list = content("snapshots.hdf.series");
  ck_assert_str_eq(list.data, "{\n"
                              "  \"file-series-version\": \"1.0\",\n"
                              "  \"files\": [\n"
                              "    {\n"
                              "      \"name\": \"snapshot_000000.vtkhdf\",\n"
                              "      \"time\": 0\n"
                              "    },\n"
                              "    {\n"
                              "      \"name\": \"snapshot_000001.vtkhdf\",\n"
                              "      \"time\": 0.1\n"
                              "    }\n"
                              "  ]\n"
                              "}\n");
  text_free(&list);
  series_free(&series);
}
END_TEST

START_TEST(tags_are_closed_in_the_order_they_were_opened) {
  Series series = {0};
  added(&series, 0, 0);
  Text xdmf = content("series.xdmf");
  ck_assert(markup_is_nested(xdmf.data));
  text_free(&xdmf);
  series_free(&series);
}
END_TEST

START_TEST(a_resumed_series_is_that_of_an_uninterrupted_run) {
  Error error;
  Series whole = {0}, resumed = {0};
  scratch_empty();
  for (int k = 0; k < 20; k++) added(&whole, k, 0.1 * k);
  Text expected = content("series.xdmf");
  /* killed after number 19, resumed from number 8 */
  ck_assert_int_eq(series_restore(&resumed, scratch_folder, 8, NULL, &error), STATUS_OK);
  ck_assert_uint_eq(resumed.count, 9);
  for (int k = 9; k < 20; k++) added(&resumed, k, 0.1 * k);
  Text found = content("series.xdmf");
  ck_assert_str_eq(found.data, expected.data);
  text_free(&expected);
  text_free(&found);
  series_free(&whole);
  series_free(&resumed);
}
END_TEST

START_TEST(an_entry_replaces_its_number_and_later_ones) {
  Series series = {0};
  added(&series, 0, 0);
  added(&series, 1, 0.1);
  added(&series, 2, 0.2);
  added(&series, 1, 0.15);
  ck_assert_uint_eq(series.count, 2);
  ck_assert(series.entry[1].number == 1 && series.entry[1].t == 0.15);
  series_free(&series);
}
END_TEST

START_TEST(a_damaged_snapshot_is_left_out_with_a_warning) {
  Error error;
  Series series = {0}, restored = {0};
  Log log = {.quiet = true};
  scratch_empty();
  added(&series, 0, 0);
  added(&series, 1, 0.1);
  FILE *file = fopen(scratch_path("snapshot_000000.vtkhdf"), "r+b");
  fputc('c', file);
  fclose(file);
  ck_assert_int_eq(series_restore(&restored, scratch_folder, 1, &log, &error), STATUS_OK);
  ck_assert_uint_eq(restored.count, 1);
  ck_assert_int_eq(restored.entry[0].number, 1);
  ck_assert_int_eq(log.warnings, 1);
  series_free(&series);
  series_free(&restored);
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  int result = suite_run("series", (SuiteTests){the_xdmf_refers_to_the_datasets_of_each_snapshot,
                                                the_file_series_lists_names_and_times,
                                                tags_are_closed_in_the_order_they_were_opened,
                                                a_resumed_series_is_that_of_an_uninterrupted_run,
                                                an_entry_replaces_its_number_and_later_ones,
                                                a_damaged_snapshot_is_left_out_with_a_warning, NULL});
  scratch_remove();
  return result;
}
