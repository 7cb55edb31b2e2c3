/* Scenes: what is refused, where, and in which words. */
#include "config/scene.h"
#include "scene_texts.h"
#include "suite.h"
#include <string.h>

static Status read_text(Scene *scene, const char *text, Error *error) {
  return scene_read_text(scene, "scene.yaml", text, strlen(text), NULL, 0, error);
}

typedef struct {
  const char *text, *place, *words;
} BadScene;

static void expect_refused(const BadScene *bad) {
  Scene scene;
  Error error;
  ck_assert_msg(read_text(&scene, bad->text, &error) == STATUS_INPUT, "taken: %s", bad->text);
  ck_assert_int_eq(error.code, STATUS_INPUT);
  size_t length = strlen(bad->place);
  ck_assert_msg(strncmp(error.text, bad->place, length) == 0 && error.text[length] == ' ', "%s: %s",
                bad->place, error.text);
  ck_assert_msg(strstr(error.text, bad->words) != NULL, "`%s` is not in: %s", bad->words, error.text);
  ck_assert_msg(strstr(error.text, "expected") != NULL, "%s", error.text);
  ck_assert_ptr_null(scene.file); /* left empty */
}

#define EXPECT_ALL_REFUSED(table)                                                                            \
  for (size_t i = 0; i < sizeof(table) / sizeof *(table); i++) expect_refused(&(table)[i])

START_TEST(unknown_keys_are_refused_with_the_nearest_name) {
  static const BadScene table[] = {
      {MEMBRANE "flow:\n  kind: simple_shear\n  capilary_number: 1\n" END,
       "scene.yaml:7:3:", "found `flow.capilary_number` (did you mean `flow.capillary_number`?)"},
      {MEMBRANE SHEAR END "damage: {law: marigo}\n", "scene.yaml:9:1:", "did you mean `membrane.damage`?"},
      {MEMBRANE SHEAR END "subdivisions: 3\n",
       "scene.yaml:9:1:", "did you mean `capsule.mesh.subdivisions`?"},
      {MEMBRANE SHEAR END "colour: red\n", "scene.yaml:9:1:", "expected a known key, found `colour`"},
      {MEMBRANE SHEAR END "fluid: {remove-flux: no}\n",
       "scene.yaml:9:9:", "did you mean `fluid.remove_flux`?"},
      {MEMBRANE SHEAR END "output: {every: {x: 1}}\n", "scene.yaml:9:10:", "found `output.every`"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

START_TEST(missing_keys_are_named_with_the_mapping_that_lacks_them) {
  static const BadScene table[] = {
      {"membrane: {law: a}\n" SHEAR END, "scene.yaml:1:1:", "the key `schema` (`1`), found none"},
      {"schema: 1\n" SHEAR END, "scene.yaml:1:1:", "the key `membrane.law`"},
      {"schema: 1\nmembrane: {mass_solver: pcg}\n" SHEAR END, "scene.yaml:2:11:", "`membrane.law`"},
      {MEMBRANE "  damage: {d_max: 1}\n" SHEAR END, "scene.yaml:5:11:", "`membrane.damage.law`"},
      {MEMBRANE END, "scene.yaml:1:1:", "`flow.kind`"},
      {MEMBRANE "flow: {kind: simple_shear}\n" END,
       "scene.yaml:5:7:", "`flow.capillary_number` (a number above 0)"},
      {MEMBRANE "flow: {kind: linear, capillary_number: 1}\n" END, "scene.yaml:5:7:",
       "`flow.gradient` (a list of three rows of three numbers), required where `flow.kind` is `linear`"},
      {MEMBRANE "flow: {kind: inflation}\n" END, "scene.yaml:5:7:", "`flow.path`"},
      {MEMBRANE "flow: {kind: simple_shear, physical: {radius: 1 um}}\n" END,
       "scene.yaml:5:38:", "`flow.physical.viscosity`"},
      {MEMBRANE SHEAR "time: {step: 0.1}\n", "scene.yaml:8:7:", "`time.end`"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

START_TEST(keys_that_exclude_each_other_are_refused) {
  static const BadScene table[] = {
      {"schema: 1\ncapsule: {mesh: {subdivisions: 0}}\nmembrane: {law: a, interpolation: quartic}\n" SHEAR
           END,
       "scene.yaml:3:35:", "`capsule.mesh.subdivisions` is 0), found `quartic`"},
      {MEMBRANE PHYSICAL "  capillary_number: 1\n" END, "scene.yaml:8:3:", "`flow.physical` is not given"},
      {MEMBRANE "flow: {kind: inflation, capillary_number: 1, path: [[0, 0], [10, 1]]}\n" END,
       "scene.yaml:5:25:", "only where `flow.kind` is not `inflation`"},
      {MEMBRANE "flow: {kind: inflation, physical: {radius: 1 m}, path: [[0, 0], [10, 1]]}\n" END,
       "scene.yaml:5:25:", "`flow.physical` only where `flow.kind` is not `inflation`"},
      {MEMBRANE SHEAR "  path: [[0, 0], [10, 1]]\n" END,
       "scene.yaml:8:3:", "only where `flow.kind` is `inflation`"},
      {MEMBRANE SHEAR "  gradient: [[0, 0, 1], [0, 0, 0], [0, 0, 0]]\n" END,
       "scene.yaml:8:3:", "only where `flow.kind` is `linear`"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

#define WITH(line) MEMBRANE SHEAR END line "\n" /* the line is line 9 */

START_TEST(wrong_types_are_refused) {
  static const BadScene table[] = {
      {"- a\n- b\n", "scene.yaml:1:1:", "a mapping with the keys of a scene, found a list"},
      {"text\n", "scene.yaml:1:1:", "found `text`"},
      {WITH("capsule: sphere"), "scene.yaml:9:10:", "expected a mapping for `capsule`, found `sphere`"},
      {WITH("capsule: {mesh: [3]}"),
       "scene.yaml:9:17:", "expected a mapping for `capsule.mesh`, found a list"},
      {WITH("capsule: {mesh: {subdivisions: 3.0}}"), "scene.yaml:9:32:", "a whole number from 0 to 7"},
      {WITH("capsule: {mesh: {subdivisions: three}}"), "scene.yaml:9:32:", "found `three`"},
      {WITH("capsule: {mesh: {subdivisions: }}"), "scene.yaml:9:32:", "found nothing"},
      {WITH("name: [a]"), "scene.yaml:9:7:", "expected text for `name`, found a list"},
      {WITH("name: \"\""), "scene.yaml:9:7:", "found nothing"},
      {WITH("name: ../elsewhere"),
       "scene.yaml:9:7:", "a name without '/' or a leading '.', found `../elsewhere`"},
      {WITH("stop: {steady: soon}"),
       "scene.yaml:9:16:", "a number of at least 0 for `stop.steady`, found `soon`"},
      {WITH("stop: {steady: .nan}"), "scene.yaml:9:16:", "found `.nan`"},
      {WITH("stop: {steady: nan}"), "scene.yaml:9:16:", "found `nan`"},
      {WITH("stop: {steady: .inf}"), "scene.yaml:9:16:", "found `.inf`"},
      {WITH("stop: {steady: 1e999}"), "scene.yaml:9:16:", "found `1e999`"},
      {WITH("stop: {steady: 0x10}"), "scene.yaml:9:16:", "found `0x10`"},
      {WITH("stop: {steady: 1_000}"), "scene.yaml:9:16:", "found `1_000`"},
      {WITH("stop: {steady: 1 s}"), "scene.yaml:9:16:", "found `1 s`, which has a unit"},
      {WITH("stop: {steady: {a: 1}}"), "scene.yaml:9:16:", "found a mapping"},
      {WITH("fluid: {remove_flux: maybe}"), "scene.yaml:9:22:", "expected `true` or `false`"},
      {WITH("fluid: {remove_flux: 1}"), "scene.yaml:9:22:", "expected `true` or `false`"},
      {WITH("fluid: {method: quick}"), "scene.yaml:9:17:", "expected `fast`, `direct` or `reference`"},
      {WITH("fluid: {method: refrence}"), "scene.yaml:9:17:", "(did you mean `reference`?)"},
      {WITH("capsule: {mesh: {rotation: {axis: [1, 2]}}}"), "scene.yaml:9:35:", "a list of three numbers"},
      {WITH("capsule: {mesh: {rotation: {axis: [1, 2, x]}}}"), "scene.yaml:9:42:", "found `x`"},
      {MEMBRANE SHEAR "time: {end: 1, step: fast}\n",
       "scene.yaml:8:22:", "expected `auto` or a number above 0"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

START_TEST(values_out_of_range_are_refused) {
  static const BadScene table[] = {
      {"schema: 2\n", "scene.yaml:1:9:", "expected `1` for `schema`, found `2`"},
      {WITH("capsule: {mesh: {subdivisions: 8}}"), "scene.yaml:9:32:", "from 0 to 7"},
      {WITH("capsule: {mesh: {subdivisions: -1}}"), "scene.yaml:9:32:", "found `-1`"},
      {WITH("capsule: {mesh: {subdivisions: 99999999999999999999}}"), "scene.yaml:9:32:", "from 0 to 7"},
      {WITH("capsule: {mesh: {rotation: {axis: [0, 0, 0]}}}"),
       "scene.yaml:9:35:", "an axis with a direction"},
      {MEMBRANE "flow: {kind: simple_shear, capillary_number: 0}\n" END,
       "scene.yaml:5:46:", "a number above 0"},
      {MEMBRANE "  damage: {law: marigo, d_max: 1.1}\n" SHEAR END, "scene.yaml:5:32:", "above 0, at most 1"},
      {MEMBRANE "  damage: {law: marigo, d_max: 0}\n" SHEAR END, "scene.yaml:5:32:", "found `0`"},
      {MEMBRANE SHEAR "time: {end: -1}\n", "scene.yaml:8:13:", "found `-1`"},
      {MEMBRANE SHEAR "time: {end: 1, step: 0}\n", "scene.yaml:8:22:", "a number above 0"},
      {MEMBRANE SHEAR "time: {end: 1, tolerance: 0.2}\n", "scene.yaml:8:27:", "a number from 1e-12 to 0.1"},
      {WITH("output: {history_every: -0.1}"), "scene.yaml:9:25:", "a number of at least 0"},
      {WITH("stop: {steady: 0.1}\noutput: {history_every: 0}"),
       "scene.yaml:9:16:", "`output.history_every` above 0"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

START_TEST(gradients_and_paths_that_make_no_sense_are_refused) {
  static const BadScene table[] = {
      {LINEAR("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"), "scene.yaml:8:13:", "found trace 3"},
      {LINEAR("[[1, 0, 0], [0, -1, 0]]"), "scene.yaml:8:13:", "three rows of three numbers"},
      {LINEAR("[[1, 0, 0], [0, -1], [0, 0, 0]]"), "scene.yaml:8:25:", "three rows of three numbers"},
      {LINEAR("5"), "scene.yaml:8:13:", "found `5`"},
      {PATH("[]"), "scene.yaml:7:9:", "a list of pairs"},
      {PATH("[[0, 0]]"), "scene.yaml:7:9:", "a path to `time.end` = 10, found one to t = 0"},
      {PATH("[[0, 0], [10]]"), "scene.yaml:7:18:", "a list of pairs"},
      {PATH("[[1, 0], [10, 1]]"), "scene.yaml:7:10:", "a path from t = 0 on, found t = 1"},
      {PATH("[[0, 0], [10, 1], [10, 2]]"), "scene.yaml:7:27:", "times that rise"},
      {PATH("[[0, 0], [10, -1]]"), "scene.yaml:7:23:", "a list of pairs `[t, value]` above -1"},
      {MEMBRANE SHEAR "  strength: [[0, 1], [0, 0]]\n" END, "scene.yaml:8:22:", "times that rise"},
      {PATH("[[0, 0], [9, 1]]"), "scene.yaml:7:9:", "a path to `time.end` = 10, found one to t = 9"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

#define RADIUS(radius)                                                                                       \
  MEMBRANE "flow:\n  kind: simple_shear\n  physical:\n    radius: " radius                                   \
           "\n    viscosity: 1 Pa.s\n    shear_rate: 1 1/s\n    shear_modulus: 1 N/m\n" END
#define PARAMETER(parameters) "schema: 1\nmembrane:\n  law: a\n  parameters: " parameters "\n" SHEAR END

START_TEST(quantities_and_parameters_that_make_no_sense_are_refused) {
  static const BadScene table[] = {
      {RADIUS("35"), "scene.yaml:8:13:", "with a unit, such as `35 um` for `flow.physical.radius`"},
      {RADIUS("35"), "scene.yaml:8:13:", "found `35`, which has no unit"},
      {RADIUS("35 s"), "scene.yaml:8:13:", "found `35 s`, which has another dimension"},
      {RADIUS("35 parsec"), "scene.yaml:8:13:", "found `parsec` for `flow.physical.radius`"},
      {RADIUS("-1 m"), "scene.yaml:8:13:", "a quantity above 0"},
      {RADIUS("um"), "scene.yaml:8:13:", "expected a number, found `um`"},
      {PARAMETER("1"), "scene.yaml:4:15:", "a mapping of names to numbers, quantities or fields"},
      {PARAMETER("{G_s: one}"),
       "scene.yaml:4:21:", "expected a number, found `one` for `membrane.parameters.G_s`"},
      {PARAMETER("{G_s: [1]}"),
       "scene.yaml:4:21:", "a number, a quantity or a field for `membrane.parameters.G_s`"},
      {PARAMETER("{G_s: }"), "scene.yaml:4:21:", "`membrane.parameters.G_s`, found nothing"},
      {PARAMETER("{G s: 1}"),
       "scene.yaml:4:16:", "letters, digits and `_` in `membrane.parameters`, found `G s`"},
      {PARAMETER("{G_s: 1, G_s: 2}"),
       "scene.yaml:4:24:", "each key once, found `G_s` again (first in line 4)"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

#define CRITERIA(list) MEMBRANE SHEAR END "observe:\n  criteria: " list "\n"

START_TEST(criteria_that_make_no_sense_are_refused) {
  static const BadScene table[] = {
      {CRITERIA("marigo"), "scene.yaml:10:13:", "a list of mappings"},
      {CRITERIA("[marigo]"), "scene.yaml:10:14:", "found `marigo`"},
      {CRITERIA("[{name: a}]"), "scene.yaml:10:14:", "expected a `law` in `observe.criteria`, found none"},
      {CRITERIA("[{law: a, d_max: 1}]"), "scene.yaml:10:23:", "found `d_max`"},
      {CRITERIA("[{law: a, parameters: {T: x}}]"), "scene.yaml:10:39:", "expected a number, found `x`"},
      {CRITERIA("[{law: ./a.so}]"), "scene.yaml:10:14:", "expected a `name`"},
      {CRITERIA("[{law: a, name: \"a,b\"}]"), "scene.yaml:10:29:", "found `a,b`"},
      {CRITERIA("[{law: a}, {law: a}]"), "scene.yaml:10:24:", "found `a` twice"},
  };
  EXPECT_ALL_REFUSED(table);
}
END_TEST

START_TEST(a_missing_scene_file_is_wrong_input) {
  Scene scene;
  Error error;
  ck_assert_int_eq(scene_read(&scene, "no/such/scene.yaml", NULL, 0, &error), STATUS_INPUT);
  ck_assert_int_eq(error.code, STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "no/such/scene.yaml: "));
  scene_free(&scene); /* empty: nothing happens */
}
END_TEST

int main(void) {
  return suite_run("scene refusals", (SuiteTests){unknown_keys_are_refused_with_the_nearest_name,
                                                  missing_keys_are_named_with_the_mapping_that_lacks_them,
                                                  keys_that_exclude_each_other_are_refused,
                                                  wrong_types_are_refused, values_out_of_range_are_refused,
                                                  gradients_and_paths_that_make_no_sense_are_refused,
                                                  quantities_and_parameters_that_make_no_sense_are_refused,
                                                  criteria_that_make_no_sense_are_refused,
                                                  a_missing_scene_file_is_wrong_input, NULL});
}
