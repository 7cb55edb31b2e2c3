/* The page of a study from a folder that is made here. */
#include "study/study_page.h"

#include "base/file.h"
#include "observe/snapshot.h"
#include "scratch.h"
#include "suite.h"
#include <string.h>

static const char SCENE[] = "schema: 1\nmembrane: {law: neo_hookean}\n"
                            "flow: {kind: simple_shear, capillary_number: 0.5}\ntime: {end: 1}\n";

static char folder[600]; /* a new one in the scratch folder for each test */

static void begin(const char *name) {
  Error error;
  snprintf(folder, sizeof folder, "%s", scratch_path(name));
  ck_assert_int_eq(file_make_folder(folder, &error), STATUS_OK);
}

static void put(const char *name, const char *text) {
  Error error;
  Text path = {0};
  ck_assert_int_eq(file_join(&path, folder, name, &error), STATUS_OK);
  ck_assert_int_eq(file_write(path.data, text, strlen(text), &error), STATUS_OK);
  text_free(&path);
}

/* A case with one snapshot of the sphere at rest, on a mesh of its own. */
static void put_case(const char *name, int subdivisions) {
  Error error;
  Mesh mesh;
  Text own = {0}, file = {0}, path = {0};
  ck_assert_int_eq(text_append(&own, &error, "%s/cases/%s", folder, name), STATUS_OK);
  ck_assert_int_eq(file_make_folder(own.data, &error), STATUS_OK);
  ck_assert_int_eq(text_append(&file, &error, "cases/%s/resolved.yaml", name), STATUS_OK);
  put(file.data, SCENE);
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  const Snapshot snapshot = {.mesh = &mesh, .t = 1, .x = mesh.X, .scene = SCENE};
  ck_assert_int_eq(snapshot_path(&path, own.data, 0, &error), STATUS_OK);
  ck_assert_msg(snapshot_write(path.data, &snapshot, &error) == STATUS_OK, "%s", error.text);
  text_free(&own);
  text_free(&file);
  text_free(&path);
  mesh_free(&mesh);
}

static Text page(void) {
  Error error;
  Text html = {0}, path = {0};
  ck_assert_msg(study_page_write(folder, &error) == STATUS_OK, "%s", error.text);
  ck_assert_int_eq(file_join(&path, folder, "report.html", &error), STATUS_OK);
  ck_assert_int_eq(file_read(path.data, (size_t)1 << 26, &html, &error), STATUS_OK);
  text_free(&path);
  return html;
}

static void holds(const Text *html, const char *words) {
  ck_assert_msg(strstr(html->data, words) != NULL, "%s", words);
}

START_TEST(a_folder_with_a_table_and_a_base_scene_is_a_study) {
  begin("kinds");
  ck_assert(!study_page_is_study(folder));
  put("table.csv", "a\n");
  ck_assert(!study_page_is_study(folder));
  put("scene.yaml", SCENE);
  ck_assert(study_page_is_study(folder));
}
END_TEST

START_TEST(table_summary_and_scene_are_in_it) {
  begin("texts");
  put("table.csv", "flow.capillary_number,d_max\n0.5,0.25\n");
  put("summary.json", "{\"study\": \"sweep\"}");
  put("scene.yaml", "schema: 1\n");
  Text html = page();
  holds(&html, "\"kind\": \"study\"");
  holds(&html, "\"table\": \"flow.capillary_number,d_max\\u000a0.5,0.25\\u000a\"");
  holds(&html, "\"summary\": {\"study\": \"sweep\"}");
  holds(&html, "\"scene\": \"schema: 1\\u000a\"");
  holds(&html, "\"surface\": null");
  text_free(&html);
}
END_TEST

START_TEST(the_last_states_of_cases_are_in_it_by_their_names) {
  begin("states");
  put_case("b=2", 0);
  put_case("a=1", 0);
  Text html = page();
  const char *first = strstr(html.data, "\"label\": \"a=1\""),
             *second = strstr(html.data, "\"label\": \"b=2\"");
  ck_assert(first && second && first < second);
  text_free(&html);
}
END_TEST

START_TEST(a_case_without_a_state_or_of_another_mesh_is_left_out) {
  begin("left_out");
  put_case("a", 0);
  put_case("b", 1);
  put_case("c", 0);
  put("cases/c/snapshot_000000.vtkhdf", "cut off");
  Text html = page();
  holds(&html, "\"label\": \"a\"");
  ck_assert_ptr_null(strstr(html.data, "\"label\": \"b\""));
  ck_assert_ptr_null(strstr(html.data, "\"label\": \"c\""));
  text_free(&html);
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  const int result =
      suite_run("study_page", (SuiteTests){a_folder_with_a_table_and_a_base_scene_is_a_study,
                                           table_summary_and_scene_are_in_it,
                                           the_last_states_of_cases_are_in_it_by_their_names,
                                           a_case_without_a_state_or_of_another_mesh_is_left_out, NULL});
  char command[700];
  snprintf(command, sizeof command, "rm -r '%s'", scratch_folder);
  return system(command) == 0 ? result : EXIT_FAILURE;
}
