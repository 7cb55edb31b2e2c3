/* The page of a run from a folder that is made here: what comes in, what is thinned, what may be missing. */
#include "run/run_page.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/snapshot.h"
#include "scratch.h"
#include "suite.h"
#include <string.h>

static const char SCENE[] = "schema: 1 # </script>\nname: a <b>\nmembrane: {law: neo_hookean}\n"
                            "flow: {kind: simple_shear, capillary_number: 0.625}\ntime: {end: 1}\n";

static void put(const char *name, const char *text) {
  Error error;
  ck_assert_int_eq(file_write(scratch_path(name), text, strlen(text), &error), STATUS_OK);
}

static void write_snapshot(int number, int subdivisions) {
  Error error;
  Mesh mesh;
  Text path = {0};
  double *zero = NULL;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&zero, 3 * mesh.n_nodes, &error), STATUS_OK);
  const SnapshotField fields[] = {
      {"q", 3, zero}, {"Y", 1, zero}, {"T1", 1, zero}, {"T2", 1, zero}, {"d", 1, zero}};
  const Snapshot snapshot = {
      .mesh = &mesh, .t = number, .x = mesh.X, .fields = fields, .n_fields = 5, .scene = SCENE};
  ck_assert_int_eq(snapshot_path(&path, scratch_folder, number, &error), STATUS_OK);
  ck_assert_msg(snapshot_write(path.data, &snapshot, &error) == STATUS_OK, "%s", error.text);
  text_free(&path);
  array_free(zero);
  mesh_free(&mesh);
}

/* A folder with a scene and nothing else. */
static void begin(void) {
  scratch_empty();
  put("resolved.yaml", SCENE);
}

static Text page(void) {
  Error error;
  Text html = {0};
  ck_assert_msg(run_page_write(scratch_folder, NULL, &error) == STATUS_OK, "%s", error.text);
  ck_assert_int_eq(file_read(scratch_path("report.html"), (size_t)1 << 26, &html, &error), STATUS_OK);
  return html;
}

static int occurrences(const Text *html, const char *word) {
  int count = 0;
  for (const char *at = html->data; (at = strstr(at, word)); at++) count++;
  return count;
}

START_TEST(summary_history_and_scene_are_in_it_as_they_are) {
  begin();
  put("summary.json", "{\"status\": \"end\", \"D12\": 0.12345678901234567}");
  put("history.csv", "t,D12\n0,0\n0.5,0.1\n1,0.2\n");
  Text html = page();
  ck_assert_int_eq(occurrences(&html, "\"D12\": 0.12345678901234567}"), 1);
  ck_assert_int_eq(occurrences(&html, "\"history\": \"t,D12\\u000a0,0\\u000a0.5,0.1\\u000a1,0.2\\u000a\""),
                   1);
  ck_assert_int_eq(occurrences(&html, "\"name\": \"a \\u003cb>\""), 1);
  ck_assert_int_eq(occurrences(&html, "schema: 1 # \\u003c/script>\\u000aname"), 1);
  ck_assert_int_eq(occurrences(&html, "\"capillary_number\": 0.625,"), 1);
  ck_assert_int_eq(occurrences(&html, "\"damage\": null"), 1);
  text_free(&html);
}
END_TEST

START_TEST(a_run_without_results_has_a_page_too) {
  begin();
  Text html = page();
  ck_assert_int_eq(occurrences(&html, "\"summary\": null"), 1);
  ck_assert_int_eq(occurrences(&html, "\"surface\": null"), 1);
  text_free(&html);
}
END_TEST

START_TEST(every_snapshot_is_a_frame) {
  begin();
  for (int k = 0; k < 3; k++) write_snapshot(k, 1);
  Text html = page();
  ck_assert_int_eq(occurrences(&html, "\"x\": {"), 3);
  ck_assert_int_eq(occurrences(&html, "\"X\": {"), 1);
  ck_assert_int_eq(occurrences(&html, "\"vorticity\": [0, 1, 0]"), 1);
  ck_assert_int_eq(occurrences(&html, "\"e1\": null"), 3); /* a sphere has no major axis */
  ck_assert_int_eq(occurrences(&html, "\"d\": {"), 3);
  text_free(&html);
}
END_TEST

START_TEST(a_damaged_snapshot_is_left_out) {
  begin();
  for (int k = 0; k < 3; k++) write_snapshot(k, 0);
  put("snapshot_000000.vtkhdf", "cut off");
  Text html = page();
  ck_assert_int_eq(occurrences(&html, "\"x\": {"), 2);
  text_free(&html);
}
END_TEST

/* 10242 nodes of 10 numbers of 16 bits are 273120 bytes of base64: 21 frames are 6 MB. */
START_TEST(many_snapshots_are_thinned_to_a_page_of_bounded_size) {
  enum { N = 30 };
  begin();
  for (int k = 0; k < N; k++) write_snapshot(k, 4);
  Text html = page();
  const int frames = occurrences(&html, "\"x\": {");
  ck_assert_int_eq(frames, 21);
  ck_assert_uint_lt(html.length, 8000000);
  ck_assert_int_eq(occurrences(&html, "\"snapshots\": 30"), 1);
  ck_assert_int_eq(occurrences(&html, "\"t\": 0,"), 1);
  ck_assert_int_eq(occurrences(&html, "\"t\": 29,"), 1);
  text_free(&html);
}
END_TEST

START_TEST(many_rows_are_thinned_and_the_last_is_kept) {
  enum { N = 30000 };
  Error error;
  Text csv = {0};
  begin();
  ck_assert_int_eq(text_append(&csv, &error, "t,D12\n"), STATUS_OK);
  for (int k = 0; k < N; k++) ck_assert_int_eq(text_append(&csv, &error, "%d,row\n", k), STATUS_OK);
  put("history.csv", csv.data);
  Text html = page();
  const int rows = occurrences(&html, ",row\\u000a");
  ck_assert_int_gt(rows, 2000);
  ck_assert_int_le(rows, 4002);
  ck_assert_int_eq(occurrences(&html, "u000a0,row\\u000a"), 1);
  ck_assert_int_eq(occurrences(&html, "u000a29999,row\\u000a\""), 1);
  text_free(&csv);
  text_free(&html);
}
END_TEST

START_TEST(a_folder_of_something_else_is_told) {
  Error error;
  scratch_empty();
  ck_assert_int_eq(run_page_write(scratch_folder, NULL, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "resolved.yaml"));
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  const int result = suite_run(
      "run_page",
      (SuiteTests){summary_history_and_scene_are_in_it_as_they_are, a_run_without_results_has_a_page_too,
                   every_snapshot_is_a_frame, a_damaged_snapshot_is_left_out,
                   many_snapshots_are_thinned_to_a_page_of_bounded_size,
                   many_rows_are_thinned_and_the_last_is_kept, a_folder_of_something_else_is_told, NULL});
  scratch_remove();
  return result;
}
