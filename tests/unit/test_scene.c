/* Scenes: what is read, and that resolved.yaml reads back. */
#include "base/array.h"
#include "base/file.h"
#include "config/scene.h"
#include "scene_texts.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

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
      "  mesh: {subdivisions: 4, rotation: {axis: [1, 2, 3], angle: 0.5}, jitter: 0.1, seed: 7}\n"
      "membrane:\n"
      "  law: skalak\n"
      "  parameters: {G_s: 1, C: 10}\n"
      "  damage: {law: ./my.so#acme.creep, parameters: {tau: 2 s}, d_max: 0.9, nonlocal: {length: 0.25}}\n"
      "  mass_solver: umfpack\n"
      "  interpolation: quartic\n"
      "flow: {kind: linear, capillary_number: 0.3, gradient: [[0, 0, 2], [0, 0, 0], [1, 0, 0]],\n"
      "       strength: [[0, 1], [2, -1]], period: 3}\n"
      "start: {axes: [1.1, 1, 0.9], noise: 1e-6, seed: 8}\n"
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
  ck_assert(s.mesh.jitter == 0.1 && s.mesh.seed == 7);
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
  ck_assert_int_eq(s.observe.criteria[0].law.place.line, 17);
  ck_assert_str_eq(s.observe.criteria[1].name, "b");
  ck_assert_str_eq(s.observe.criteria[1].law.law, "./x.so#y.z");
  ck_assert_uint_eq(s.observe.criteria[1].law.n_parameters, 0);
  ck_assert_int_eq(s.membrane.mass_solver, MASS_UMFPACK);
  ck_assert_int_eq(s.membrane.interpolation, INTERPOLATION_QUARTIC);
  ck_assert_int_eq(s.flow.kind, FLOW_LINEAR);
  ck_assert_int_eq(s.flow.place.line, 12);
  ck_assert(s.flow.capillary_number == 0.3 && !s.flow.is_physical);
  ck_assert(s.flow.gradient[0][2] == 2 && s.flow.gradient[2][0] == 1 && s.flow.gradient[1][1] == 0);
  ck_assert_uint_eq(s.flow.n_strength, 2);
  ck_assert(s.flow.strength[1][0] == 2 && s.flow.strength[1][1] == -1 && s.flow.period == 3);
  ck_assert(s.start.axes[0] == 1.1 && s.start.axes[1] == 1 && s.start.axes[2] == 0.9);
  ck_assert(s.start.noise == 1e-6 && s.start.seed == 8);
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
  ck_assert(s.mesh.rotation_angle == 0 && s.mesh.jitter == 0);
  ck_assert_uint_eq(s.flow.n_strength, 1);
  ck_assert(s.flow.strength[0][1] == 1 && s.flow.period == 0);
  ck_assert(s.start.axes[0] == 1 && s.start.axes[1] == 1 && s.start.axes[2] == 1 && s.start.noise == 0);
  ck_assert(!s.membrane.has_damage);
  ck_assert_ptr_null(s.membrane.damage.law);
  ck_assert_int_eq(s.membrane.mass_solver, MASS_PCG);
  ck_assert_int_eq(s.membrane.interpolation, INTERPOLATION_QUADRATIC);
  ck_assert_int_eq(s.time.integrator, INTEGRATOR_RKC3);
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
  ck_assert_int_eq(a->membrane.interpolation, b.membrane.interpolation);
  ck_assert_int_eq(a->flow.kind, b.flow.kind);
  ck_assert_mem_eq(&a->flow.capillary_number, &b.flow.capillary_number, sizeof(double));
  ck_assert_mem_eq(a->flow.gradient, b.flow.gradient, sizeof a->flow.gradient);
  ck_assert_mem_eq(&a->start, &b.start, sizeof a->start);
  ck_assert_uint_eq(a->flow.n_strength, b.flow.n_strength);
  if (a->flow.n_strength)
    ck_assert_mem_eq(a->flow.strength, b.flow.strength, a->flow.n_strength * sizeof *a->flow.strength);
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
      MEMBRANE SHEAR "  strength: [[0, 0.1], [0.30000000000000004, -1]]\n" END
                     "start: {axes: [0.1, 3, 1e-3]}\n",
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
  return suite_run(
      "scene", (SuiteTests){every_key_lands_in_the_scene, a_short_scene_gets_the_documented_defaults,
                            accuracy_sets_mesh_and_tolerance_unless_they_are_given,
                            gradients_of_the_named_flows_are_those_of_their_formulas,
                            an_inflation_has_a_path_and_no_capillary_number,
                            physical_values_are_kept_in_si_units, typing_follows_the_schema_not_the_spelling,
                            resolved_scenes_read_back_to_the_same_bits, the_scenes_that_ship_are_read,
                            a_failed_allocation_anywhere_is_an_error_and_leaks_nothing, NULL});
}
