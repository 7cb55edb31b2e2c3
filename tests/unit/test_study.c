/* Study files: what they mean, and messages that name the place of a mistake. */
#include "scratch.h"
#include "study/study.h"
#include "suite.h"

#define SCENE                                                                                                \
  "scene:\n"                                                                                                 \
  "  schema: 1\n"                                                                                            \
  "  membrane: {law: neo_hookean, parameters: {G_s: 1}, damage: {law: marigo, parameters: {Y_D: 1, Y_C: "    \
  "1}}}\n"                                                                                                   \
  "  flow: {kind: simple_shear, capillary_number: 0.7}\n"                                                    \
  "  time: {end: 10}\n"
static const char SWEEP_HEAD[] = "schema: 1\nstudy: sweep\n";

static void write_file(const char *name, const char *head, const char *rest) {
  FILE *file = fopen(scratch_path(name), "w");
  ck_assert_ptr_nonnull(file);
  fprintf(file, "%s%s", head, rest);
  ck_assert_int_eq(fclose(file), 0);
}

static Study must_read(const char *rest) {
  Study study;
  Error error;
  write_file("study.yaml", SWEEP_HEAD, rest);
  const Status status = study_read(&study, scratch_path("study.yaml"), NULL, 0, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return study;
}

START_TEST(lists_and_ranges_span_an_outer_product_whose_last_axis_runs_fastest) {
  Study study = must_read(SCENE "vary:\n"
                                "  flow.capillary_number: {from: 0.1, to: 0.3, count: 3}\n"
                                "  membrane.damage: [{law: marigo, parameters: {Y_D: 2, Y_C: 1}}, '']\n");
  ck_assert_uint_eq(study.n_points, 6);
  ck_assert_str_eq(study.name, "study");
  Override settings[2];
  study_point(&study, 3, settings);
  ck_assert_str_eq(settings[0].key, "flow.capillary_number");
  ck_assert_str_eq(settings[0].value, "0.2");
  ck_assert(study.axes[0].is_numeric && !study.axes[1].is_numeric);
  study_point(&study, 4, settings);
  ck_assert_str_eq(settings[0].value, "0.3");
  ck_assert_str_eq(settings[1].value, "{law: marigo, parameters: {Y_D: 2, Y_C: 1}}");
  ck_assert_int_eq(settings[1].place.line, 10);
  size_t places[2];
  study_place(&study, 5, places);
  ck_assert(places[0] == 2 && places[1] == 1);
  study_free(&study);
}
END_TEST

/* 5 values in 3 parts: 1, 2 and 2 of them. */
START_TEST(parts_share_the_values_of_the_first_key_in_order) {
  static const double first[] = {0.1, 0.2, 0.4};
  static const size_t count[] = {1, 2, 2};
  Error error;
  for (int part = 1; part <= 3; part++) {
    Study study = must_read(SCENE "vary:\n"
                                  "  flow.capillary_number: {from: 0.1, to: 0.5, count: 5}\n"
                                  "  time.end: [1, 2]\n");
    ck_assert_int_eq(study_take_part(&study, part, 3, &error), STATUS_OK);
    ck_assert_uint_eq(study.n_points, 2 * count[part - 1]);
    ck_assert_double_eq_tol(study.axes[0].numbers[0], first[part - 1], 1e-15);
    Override settings[2];
    study_point(&study, study.n_points - 1, settings);
    ck_assert_str_eq(settings[1].value, "2");
    ck_assert_int_eq(study_take_part(&study, 1, 3, &error), STATUS_INPUT);
    study_free(&study);
  }
  Study study = must_read(SCENE);
  ck_assert_int_eq(study_take_part(&study, 1, 1, &error), STATUS_INPUT);
  study_free(&study);
}
END_TEST

START_TEST(the_scene_of_a_point_is_what_set_makes_of_the_scene) {
  Study study = must_read(SCENE "vary: {membrane.damage.parameters.Y_D: [3]}\n");
  Override settings[1];
  Scene scene;
  Error error;
  study_point(&study, 0, settings);
  const Status status = study_scene(&study, settings, 1, &scene, NULL, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  ck_assert(scene.membrane.damage.n_parameters == 2);
  for (int i = 0; i < 2; i++)
    ck_assert(scene.membrane.damage.parameters[i].value.value ==
              (strcmp(scene.membrane.damage.parameters[i].name, "Y_D") == 0 ? 3 : 1));
  scene_free(&scene);
  ck_assert(study_scene_gives(&study, "time.end") && !study_scene_gives(&study, "time.step"));
  ck_assert(!study_scene_gives(&study, "time.end.x"));
  study_free(&study);
}
END_TEST

START_TEST(a_scene_by_path_is_taken_from_the_folder_of_the_study) {
  write_file("scene.yaml", "",
             "schema: 1\nmembrane: {law: skalak, parameters: {G_s: 1, C: 1}}\n"
             "flow: {kind: simple_shear, capillary_number: 0.7}\ntime: {end: 10}\n");
  Study study = must_read("scene: scene.yaml\n");
  ck_assert_str_eq(study.scene_file, scratch_path("scene.yaml"));
  ck_assert_uint_eq(study.n_points, 1);
  study_free(&study);
}
END_TEST

START_TEST(the_settings_of_the_command_line_change_the_scene) {
  static const char *const sets[] = {"flow.capillary_number=0.4", "membrane.damage="};
  Study study;
  Scene scene;
  Error error;
  write_file("study.yaml", SWEEP_HEAD, SCENE);
  ck_assert_int_eq(study_read(&study, scratch_path("study.yaml"), sets, 2, &error), STATUS_OK);
  ck_assert_int_eq(study_scene(&study, NULL, 0, &scene, NULL, &error), STATUS_OK);
  ck_assert(scene.flow.capillary_number == 0.4 && !scene.membrane.has_damage);
  scene_free(&scene);
  study_free(&study);
}
END_TEST

START_TEST(mistakes_are_named_with_their_place) {
  static const struct {
    const char *rest, *words;
  } table[] = {
      {SCENE "vari: {}\n", ":8:1: expected a known key, found `vari` (did you mean `vary`?)"},
      {SCENE "vary: {flow.capilary_number: [0.1]}\n",
       ":8:31: expected a known key, found `flow.capilary_number` "
       "(did you mean `flow.capillary_number`?)"},
      {SCENE "vary: {flow.capillary_number: [0.1, fast]}\n", ":8:37: expected a number above 0"},
      {SCENE "vary: {membrane.damage.parameters.Y_X: [0.1]}\n", ":8:41: law marigo has no parameter `Y_X`"},
      {SCENE "vary: {flow.capillary_number: 0.1}\n", ":8:31: expected a list of values or {from, to, count}"},
      {SCENE "vary: {flow.capillary_number: []}\n", "expected 1 to 10000 values"},
      {SCENE "vary: {flow.capillary_number: {from: 1, to: 2}}\n", ":8:31: expected the key `count`"},
      {SCENE "vary: {flow.capillary_number: {from: 1, to: 2, count: 2.5}}\n", "expected a whole number"},
      {SCENE "vary: {flow.capillary_number: {from: 1, to: 2, step: 1}}\n", "found `step`"},
      {SCENE "vary: [1]\n", ":8:7: expected a mapping of keys to values for `vary`, found a list"},
      {"vary: {}\n", "expected the key `scene`"},
      {"scene: none.yaml\n", ":3:8: "},
      {"scene: [1]\n", ":3:8: expected text for `scene`, found a list"},
      {"scene: {schema: 1}\n", "expected the key `membrane.law`"},
      {SCENE "snapshots: maybe\n", ":8:12: expected `false` or `true` for `snapshots`, found `maybe`"},
      {SCENE "charts: {draw: d_max}\n", ":8:9: expected a list for `charts`, found a mapping"},
      {SCENE "charts: [d_max]\n", ":8:10: expected a mapping `{draw: , over: }`"},
      {SCENE "charts: [{over: t}]\n", "expected the key `draw`"},
      {SCENE "charts: [{draw: []}]\n", "expected one to 8 names for `draw`, found 0"},
      {SCENE "charts: [{draw: d_max}, {draw: L4}]\n", "expected columns of table.csv, found `L4`"},
      {SCENE "charts: [{draw: D12, over: angle}]\n", "expected columns of history.csv, found `angle`"},
      {SCENE "charts: [{draw: [D12, t_l], over: t}]\n", "expected columns of history.csv, found `t_l`"},
      {SCENE "name: a/b\n", ":8:7: expected a name without '/'"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Study study;
    Error error = {.text = "nothing"};
    write_file("study.yaml", SWEEP_HEAD, table[i].rest);
    ck_assert_msg(study_read(&study, scratch_path("study.yaml"), NULL, 0, &error) == STATUS_INPUT, "%s",
                  table[i].rest);
    ck_assert_msg(strstr(error.text, table[i].words) != NULL, "expected `%s` in: %s", table[i].words,
                  error.text);
  }
}
END_TEST

START_TEST(a_kind_or_version_that_is_unknown_is_refused) {
  static const struct {
    const char *head, *words;
  } table[] = {{"schema: 1\nstudy: swep\n", "found `swep` (did you mean `sweep`?)"},
               {"schema: 2\nstudy: sweep\n", "1:9: expected `1` for `schema`"},
               {"study: sweep\n", "expected the key `schema`"},
               {"schema: 1\n", "expected the key `study`"}};
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Study study;
    Error error = {.text = "nothing"};
    write_file("study.yaml", table[i].head, SCENE);
    ck_assert_int_eq(study_read(&study, scratch_path("study.yaml"), NULL, 0, &error), STATUS_INPUT);
    ck_assert_msg(strstr(error.text, table[i].words) != NULL, "%s", error.text);
  }
}
END_TEST

int main(void) {
  if (!scratch_make() || setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1) != 0) return 1;
  const int code =
      suite_run("study", (SuiteTests){lists_and_ranges_span_an_outer_product_whose_last_axis_runs_fastest,
                                      parts_share_the_values_of_the_first_key_in_order,
                                      the_scene_of_a_point_is_what_set_makes_of_the_scene,
                                      a_scene_by_path_is_taken_from_the_folder_of_the_study,
                                      the_settings_of_the_command_line_change_the_scene,
                                      mistakes_are_named_with_their_place,
                                      a_kind_or_version_that_is_unknown_is_refused, NULL});
  scratch_remove();
  return code;
}
