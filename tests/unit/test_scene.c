/* Scenes: what is read, what is refused and where, and that resolved.yaml reads back. */
#include "base/array.h"
#include "base/file.h"
#include "config/scene.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The lines are counted by the tests below. */
#define MEMBRANE                                                                                             \
  "schema: 1\n"                                                                                              \
  "membrane:\n"                                                                                              \
  "  law: neo_hookean\n"                                                                                     \
  "  parameters: {G_s: 1.0}\n"
#define SHEAR                                                                                                \
  "flow:\n"                                                                                                  \
  "  kind: simple_shear\n"                                                                                   \
  "  capillary_number: 0.7\n"
#define END "time: {end: 10}\n"
#define PHYSICAL                                                                                             \
  "flow:\n"                                                                                                  \
  "  kind: simple_shear\n"                                                                                   \
  "  physical: {radius: 35 um, viscosity: 1 mPa.s, shear_rate: 20 1/s, shear_modulus: 0.05 N/m}\n"

static Status read_text(Scene *scene, const char *text, Error *error) {
  return scene_read_text(scene, "scene.yaml", text, strlen(text), NULL, 0, error);
}

/* A scene that must be good. */
static Scene read_good(const char *text, const char *set) {
  Scene scene;
  Error error;
  Status status = scene_read_text(&scene, "scene.yaml", text, strlen(text), &set, set != NULL, &error);
  ck_assert_msg(status == STATUS_OK, "%s", error.text);
  return scene;
}

START_TEST(every_key_lands_in_the_scene) {
  Scene s = read_good(
      "schema: 1\n"
      "name: everything\n"
      "capsule:\n"
      "  shape: sphere\n"
      "  mesh: {subdivisions: 4, rotation: {axis: [1, 2, 3], angle: 0.5}}\n"
      "membrane:\n"
      "  law: skalak\n"
      "  parameters: {G_s: 1, C: 10}\n"
      "  damage: {law: ./my.so#acme.creep, parameters: {tau: 2 s}, d_max: 0.9, nonlocal: {length: 0.25}}\n"
      "  mass_solver: umfpack\n"
      "flow: {kind: linear, capillary_number: 0.3, gradient: [[0, 0, 2], [0, 0, 0], [1, 0, 0]]}\n"
      "time: {end: 3, integrator: rk2, step: 0.01, tolerance: 1e-6, allow_unstable: true}\n"
      "stop: {rupture: continue, steady: 1e-5}\n"
      "observe: {criteria: [{law: rankine, parameters: {T_D: 1}}, {name: b, law: ./x.so#y.z}]}\n"
      "accuracy: draft\n"
      "symmetry: off\n"
      "fluid: {method: direct, remove_flux: false}\n"
      "output: {history_every: 0.1, snapshot_every: 0}\n",
      NULL);
  ck_assert_str_eq(s.file, "scene.yaml");
  ck_assert_str_eq(s.name, "everything");
  ck_assert_int_eq(s.mesh.subdivisions, 4);
  ck_assert(s.mesh.rotation_axis[0] == 1 && s.mesh.rotation_axis[1] == 2 && s.mesh.rotation_axis[2] == 3);
  ck_assert(s.mesh.rotation_angle == 0.5);
  ck_assert_str_eq(s.membrane.elastic.law, "skalak");
  ck_assert_int_eq(s.membrane.elastic.place.line, 7);
  ck_assert_int_eq(s.membrane.elastic.place.column, 8);
  ck_assert_uint_eq(s.membrane.elastic.n_parameters, 2);
  ck_assert_str_eq(s.membrane.elastic.parameters[1].name, "C");
  ck_assert(s.membrane.elastic.parameters[1].value.value == 10);
  ck_assert(!s.membrane.elastic.parameters[1].value.has_unit);
  ck_assert_int_eq(s.membrane.elastic.parameters[1].place.line, 8);
  ck_assert_int_eq(s.membrane.elastic.parameters[1].place.column, 27);
  ck_assert_str_eq(s.membrane.elastic.parameters[1].place.file, "scene.yaml");
  ck_assert(s.membrane.has_damage);
  ck_assert_str_eq(s.membrane.damage.law, "./my.so#acme.creep");
  ck_assert(s.membrane.damage.parameters[0].value.has_unit);
  ck_assert_int_eq(s.membrane.damage.parameters[0].value.dim[2], 1);
  ck_assert(s.membrane.d_max == 0.9);
  ck_assert(s.membrane.nonlocal_length == 0.25);
  ck_assert_uint_eq(s.observe.n_criteria, 2);
  ck_assert_str_eq(s.observe.criteria[0].name, "rankine");
  ck_assert_str_eq(s.observe.criteria[0].law.parameters[0].name, "T_D");
  ck_assert_int_eq(s.observe.criteria[0].law.place.line, 14);
  ck_assert_str_eq(s.observe.criteria[1].name, "b");
  ck_assert_str_eq(s.observe.criteria[1].law.law, "./x.so#y.z");
  ck_assert_uint_eq(s.observe.criteria[1].law.n_parameters, 0);
  ck_assert_int_eq(s.membrane.mass_solver, MASS_UMFPACK);
  ck_assert_int_eq(s.flow.kind, FLOW_LINEAR);
  ck_assert_int_eq(s.flow.place.line, 11);
  ck_assert(s.flow.capillary_number == 0.3 && !s.flow.is_physical);
  ck_assert(s.flow.gradient[0][2] == 2 && s.flow.gradient[2][0] == 1 && s.flow.gradient[1][1] == 0);
  ck_assert(s.time.end == 3 && !s.time.step_is_auto && s.time.step == 0.01 && s.time.tolerance == 1e-6);
  ck_assert_int_eq(s.time.integrator, INTEGRATOR_RK2);
  ck_assert(s.time.allow_unstable);
  ck_assert_int_eq(s.stop.rupture, RUPTURE_CONTINUE);
  ck_assert(s.stop.steady == 1e-5);
  ck_assert_int_eq(s.accuracy, ACCURACY_DRAFT);
  ck_assert_int_eq(s.symmetry, SYMMETRY_OFF);
  ck_assert_int_eq(s.fluid_method, FLUID_DIRECT);
  ck_assert(!s.flow.remove_flux);
  ck_assert(s.output.history_every == 0.1 && s.output.snapshot_every == 0);
  scene_free(&s);
}
END_TEST

START_TEST(a_short_scene_gets_the_documented_defaults) {
  Scene s = read_good(MEMBRANE SHEAR END, NULL);
  ck_assert_str_eq(s.name, "unnamed");
  ck_assert_int_eq(s.mesh.subdivisions, 3);
  ck_assert(s.mesh.rotation_angle == 0);
  ck_assert(!s.membrane.has_damage);
  ck_assert_ptr_null(s.membrane.damage.law);
  ck_assert_int_eq(s.membrane.mass_solver, MASS_PCG);
  ck_assert_int_eq(s.time.integrator, INTEGRATOR_RKC2);
  ck_assert(s.time.step_is_auto && s.time.tolerance == 1e-4 && !s.time.allow_unstable);
  ck_assert_int_eq(s.stop.rupture, RUPTURE_STOP);
  ck_assert(s.stop.steady == 0);
  ck_assert_int_eq(s.accuracy, ACCURACY_STANDARD);
  ck_assert_int_eq(s.symmetry, SYMMETRY_AUTO);
  ck_assert_int_eq(s.fluid_method, FLUID_FAST);
  ck_assert(s.flow.remove_flux);
  ck_assert(s.output.history_every == 0.05 && s.output.snapshot_every == 0.5);
  scene_free(&s);
}
END_TEST

START_TEST(accuracy_sets_mesh_and_tolerance_unless_they_are_given) {
  static const struct {
    const char *accuracy;
    int subdivisions;
    double tolerance;
  } table[] = {{"accuracy=draft", 2, 1e-3}, {"accuracy=standard", 3, 1e-4}, {"accuracy=fine", 4, 1e-5}};
  for (int i = 0; i < 3; i++) {
    Scene s = read_good(MEMBRANE SHEAR END, table[i].accuracy);
    ck_assert_int_eq(s.mesh.subdivisions, table[i].subdivisions);
    ck_assert(s.time.tolerance == table[i].tolerance);
    scene_free(&s);
    s = read_good(MEMBRANE SHEAR "time: {end: 1, tolerance: 0.003}\ncapsule: {mesh: {subdivisions: 5}}\n",
                  table[i].accuracy);
    ck_assert_int_eq(s.mesh.subdivisions, 5);
    ck_assert(s.time.tolerance == 0.003);
    scene_free(&s);
  }
}
END_TEST

START_TEST(gradients_of_the_named_flows_are_those_of_their_formulas) {
  static const struct {
    const char *kind;
    double gradient[3][3];
  } table[] = {{"flow.kind=simple_shear", {{0, 0, 1}}},
               {"flow.kind=planar_hyperbolic", {{1}, {0}, {0, 0, -1}}},
               {"flow.kind=uniaxial_extension", {{1}, {0, -0.5}, {0, 0, -0.5}}}};
  for (int i = 0; i < 3; i++) {
    Scene s = read_good(MEMBRANE SHEAR END, table[i].kind);
    for (int k = 0; k < 9; k++) ck_assert(s.flow.gradient[k / 3][k % 3] == table[i].gradient[k / 3][k % 3]);
    scene_free(&s);
  }
}
END_TEST

START_TEST(an_inflation_has_a_path_and_no_capillary_number) {
  Scene s = read_good(
      MEMBRANE "flow: {kind: inflation, path: [[0, 0], [1, 0.5], [2.5, 0]]}\ntime: {end: 2}\n", NULL);
  ck_assert_uint_eq(s.flow.n_path, 3);
  ck_assert(s.flow.path[1][0] == 1 && s.flow.path[1][1] == 0.5 && s.flow.path[2][0] == 2.5);
  ck_assert(s.flow.capillary_number == 0);
  scene_free(&s);
}
END_TEST

START_TEST(physical_values_are_kept_in_si_units) {
  Scene s = read_good(MEMBRANE PHYSICAL END, NULL);
  ck_assert(s.flow.is_physical && s.flow.capillary_number == 0);
  ck_assert(s.flow.radius.value == 35e-6 && s.flow.viscosity.value == 1e-3);
  ck_assert(s.flow.shear_rate.value == 20 && s.flow.shear_modulus.value == 0.05);
  scene_free(&s);
}
END_TEST

START_TEST(typing_follows_the_schema_not_the_spelling) {
  Scene s = read_good("schema: 1\n"
                      "name: no\n"
                      "membrane: {law: \"1e3\", parameters: {y: .5, n: \"2\"}}\n"
                      "flow: {kind: simple_shear, capillary_number: 1e3}\n"
                      "time: {end: +10., allow_unstable: no}\n"
                      "fluid: {remove_flux: on}\n",
                      NULL);
  ck_assert_str_eq(s.name, "no");
  ck_assert_str_eq(s.membrane.elastic.law, "1e3");
  ck_assert_str_eq(s.membrane.elastic.parameters[0].name, "y");
  ck_assert(s.membrane.elastic.parameters[0].value.value == 0.5);
  ck_assert(s.membrane.elastic.parameters[1].value.value == 2);
  ck_assert(s.flow.capillary_number == 1000 && s.time.end == 10);
  ck_assert(!s.time.allow_unstable && s.flow.remove_flux);
  scene_free(&s);
}
END_TEST

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

#define LINEAR(gradient)                                                                                     \
  MEMBRANE "flow:\n  kind: linear\n  capillary_number: 1\n  gradient: " gradient "\n" END
#define PATH(path) MEMBRANE "flow:\n  kind: inflation\n  path: " path "\n" END

START_TEST(gradients_and_paths_that_make_no_sense_are_refused) {
  static const BadScene table[] = {
      {LINEAR("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"), "scene.yaml:8:13:", "found trace 3"},
      {LINEAR("[[1, 0, 0], [0, -1, 0]]"), "scene.yaml:8:13:", "three rows of three numbers"},
      {LINEAR("[[1, 0, 0], [0, -1], [0, 0, 0]]"), "scene.yaml:8:25:", "three rows of three numbers"},
      {LINEAR("5"), "scene.yaml:8:13:", "found `5`"},
      {PATH("[]"), "scene.yaml:7:9:", "a list of pairs"},
      {PATH("[[0, 0]]"), "scene.yaml:7:9:", "a list of pairs"},
      {PATH("[[0, 0], [10]]"), "scene.yaml:7:18:", "a list of pairs"},
      {PATH("[[1, 0], [10, 1]]"), "scene.yaml:7:10:", "a path from t = 0 on, found t = 1"},
      {PATH("[[0, 0], [10, 1], [10, 2]]"), "scene.yaml:7:27:", "times that rise"},
      {PATH("[[0, 0], [10, -1]]"), "scene.yaml:7:18:", "alpha above -1"},
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

static void expect_same_law(const SceneLaw *a, const SceneLaw *b) {
  if (a->law || b->law) ck_assert_str_eq(a->law, b->law);
  ck_assert_uint_eq(a->n_parameters, b->n_parameters);
  for (size_t i = 0; i < a->n_parameters; i++) {
    ck_assert_str_eq(a->parameters[i].name, b->parameters[i].name);
    ck_assert_mem_eq(&a->parameters[i].value.value, &b->parameters[i].value.value, sizeof(double));
    ck_assert_mem_eq(a->parameters[i].value.dim, b->parameters[i].value.dim, 4);
    ck_assert_int_eq(a->parameters[i].value.has_unit, b->parameters[i].value.has_unit);
  }
}

/* Prints, reads back and compares, member by member and bit by bit. */
static void expect_round_trip(const Scene *a) {
  Text yaml = {0}, again = {0};
  Error error;
  ck_assert_int_eq(scene_print(a, "law 1.0\nhash 2", &yaml, &error), STATUS_OK);
  ck_assert_int_eq(strncmp(yaml.data, "# law 1.0\n# hash 2\nschema: 1\n", 29), 0);
  Scene b;
  Status status = scene_read_text(&b, "resolved.yaml", yaml.data, yaml.length, NULL, 0, &error);
  ck_assert_msg(status == STATUS_OK, "%s\n%s", error.text, yaml.data);
  ck_assert_str_eq(a->name, b.name);
  ck_assert_mem_eq(&a->mesh, &b.mesh, sizeof a->mesh);
  expect_same_law(&a->membrane.elastic, &b.membrane.elastic);
  expect_same_law(&a->membrane.damage, &b.membrane.damage);
  ck_assert_mem_eq(&a->membrane.d_max, &b.membrane.d_max, sizeof(double));
  ck_assert_int_eq(a->membrane.mass_solver, b.membrane.mass_solver);
  ck_assert_int_eq(a->flow.kind, b.flow.kind);
  ck_assert_mem_eq(&a->flow.capillary_number, &b.flow.capillary_number, sizeof(double));
  ck_assert_mem_eq(a->flow.gradient, b.flow.gradient, sizeof a->flow.gradient);
  ck_assert_uint_eq(a->flow.n_path, b.flow.n_path);
  if (a->flow.n_path) ck_assert_mem_eq(a->flow.path, b.flow.path, a->flow.n_path * sizeof *a->flow.path);
  ck_assert_mem_eq(&a->flow.radius.value, &b.flow.radius.value, sizeof(double));
  ck_assert_mem_eq(&a->flow.viscosity.value, &b.flow.viscosity.value, sizeof(double));
  ck_assert_mem_eq(&a->flow.shear_modulus.value, &b.flow.shear_modulus.value, sizeof(double));
  ck_assert_int_eq(a->flow.remove_flux, b.flow.remove_flux);
  ck_assert_mem_eq(&a->time.end, &b.time.end, sizeof(double));
  ck_assert_mem_eq(&a->time.step, &b.time.step, sizeof(double));
  ck_assert_mem_eq(&a->time.tolerance, &b.time.tolerance, sizeof(double));
  ck_assert_int_eq(a->time.step_is_auto, b.time.step_is_auto);
  ck_assert_mem_eq(&a->output, &b.output, sizeof a->output);
  ck_assert_int_eq(a->fluid_method, b.fluid_method);
  ck_assert_int_eq(scene_print(&b, "law 1.0\nhash 2", &again, &error), STATUS_OK);
  ck_assert_str_eq(yaml.data, again.data);
  text_free(&yaml);
  text_free(&again);
  scene_free(&b);
}

START_TEST(resolved_scenes_read_back_to_the_same_bits) {
  static const char *const texts[] = {
      MEMBRANE SHEAR END,
      MEMBRANE PHYSICAL END,
      MEMBRANE
      "  damage: {law: marigo, parameters: {Y_D: 0.1 N/m, t: 3 ms, r: 1e-3 1/mPa}, d_max: 0.99}\n" SHEAR END,
      LINEAR("[[0.1, 0, 1e-17], [0, 0.2, 0.3333333333333333], [-0.0, 0, -0.30000000000000004]]"),
      PATH("[[0, 0], [0.1, 0.30000000000000004], [10, 0.1]]"),
      MEMBRANE SHEAR "time: {end: 0.1, step: 0.012345678901234567, tolerance: 3.3e-7}\naccuracy: fine\n",
      MEMBRANE SHEAR END "name: \"a: #b \\\" \\\\ \\t\\n {c} \\u00e9\"\n",
      "schema: 1\nmembrane: {law: \"/a b/c.so\"}\n" SHEAR END "name: \"~\"\n",
      "schema: 1\nmembrane: {law: ./x-1.so}\n" SHEAR END "name: \"- 1\"\n",
      MEMBRANE SHEAR END
      "observe: {criteria: [{law: a, parameters: {b: 0.1 N/m}}, {name: -1, law: \"./d e.so\"}]}\n",
  };
  for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
    Scene scene = read_good(texts[i], NULL);
    expect_round_trip(&scene);
    scene_free(&scene);
  }
}
END_TEST

START_TEST(the_scenes_that_ship_are_read) {
  static const struct {
    const char *path, *name;
    FlowKind kind;
    double number, end;
    int subdivisions;
    const char *damage;
  } table[] = {
      {SOURCE_DIR "/configs/shear_reference.yaml", "shear_reference", FLOW_SIMPLE_SHEAR, 0.7, 10, 3,
       "marigo"},
      {SOURCE_DIR "/configs/shear_quick.yaml", "shear_quick", FLOW_SIMPLE_SHEAR, 0.7, 2, 2, "marigo"},
      {SOURCE_DIR "/configs/shear_skalak.yaml", "shear_skalak", FLOW_SIMPLE_SHEAR, 0.6, 8, 3, NULL},
      {SOURCE_DIR "/configs/inflation_monotone.yaml", "inflation_monotone", FLOW_INFLATION, 0, 1, 3,
       "marigo"},
      {SOURCE_DIR "/configs/inflation_cycles.yaml", "inflation_cycles", FLOW_INFLATION, 0, 8, 3, "marigo"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Scene s;
    Error error;
    Status status = scene_read(&s, table[i].path, NULL, 0, &error);
    ck_assert_msg(status == STATUS_OK, "%s", error.text);
    ck_assert_str_eq(s.name, table[i].name);
    ck_assert_int_eq(s.flow.kind, table[i].kind);
    ck_assert(s.flow.capillary_number == table[i].number && s.time.end == table[i].end);
    ck_assert_int_eq(s.mesh.subdivisions, table[i].subdivisions);
    ck_assert_int_eq(s.membrane.has_damage, table[i].damage != NULL);
    if (table[i].damage) {
      ck_assert_str_eq(s.membrane.damage.law, table[i].damage);
      ck_assert(s.membrane.damage.parameters[0].value.value == 0.2); /* Y_D */
      ck_assert(s.membrane.damage.parameters[1].value.value == 2.0); /* Y_C */
    }
    if (table[i].kind == FLOW_INFLATION) /* beyond rupture at 0.9138260 */
      ck_assert(s.flow.path[s.flow.n_path - 1][1] == 0.95);
    expect_round_trip(&s);
    scene_free(&s);
  }
}
END_TEST

START_TEST(a_failed_allocation_anywhere_is_an_error_and_leaks_nothing) {
  const char *text = MEMBRANE "  damage: {law: marigo, parameters: {Y_D: 0.2}}\n" SHEAR END
                              "observe: {criteria: [{law: a, parameters: {b: 1}}, {name: c, law: ./d.so}]}\n";
  const char *set = "flow.capillary_number=0.8";
  Error error;
  Status status = STATUS_MEMORY;
  long n = 0;
  while (status == STATUS_MEMORY && n < 10000) {
    Scene scene;
    Text yaml = {0};
    array_fail_nth(++n);
    status = scene_read_text(&scene, "scene.yaml", text, strlen(text), &set, 1, &error);
    if (status == STATUS_OK) status = scene_print(&scene, NULL, &yaml, &error);
    array_fail_nth(0);
    text_free(&yaml);
    scene_free(&scene);
  }
  ck_assert_msg(status == STATUS_OK, "%ld: %s", n, error.text);
  ck_assert_int_gt(n, 100); /* the walk did meet allocations */
}
END_TEST

int main(void) {
  return suite_run("scene", (SuiteTests){every_key_lands_in_the_scene,
                                         a_short_scene_gets_the_documented_defaults,
                                         accuracy_sets_mesh_and_tolerance_unless_they_are_given,
                                         gradients_of_the_named_flows_are_those_of_their_formulas,
                                         an_inflation_has_a_path_and_no_capillary_number,
                                         physical_values_are_kept_in_si_units,
                                         typing_follows_the_schema_not_the_spelling,
                                         unknown_keys_are_refused_with_the_nearest_name,
                                         missing_keys_are_named_with_the_mapping_that_lacks_them,
                                         keys_that_exclude_each_other_are_refused,
                                         wrong_types_are_refused,
                                         values_out_of_range_are_refused,
                                         gradients_and_paths_that_make_no_sense_are_refused,
                                         quantities_and_parameters_that_make_no_sense_are_refused,
                                         criteria_that_make_no_sense_are_refused,
                                         a_missing_scene_file_is_wrong_input,
                                         resolved_scenes_read_back_to_the_same_bits,
                                         the_scenes_that_ship_are_read,
                                         a_failed_allocation_anywhere_is_an_error_and_leaks_nothing,
                                         NULL});
}
