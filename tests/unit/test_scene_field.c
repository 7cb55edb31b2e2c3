/* Fields in a scene: what is read, how it is printed, and what is refused where. */
#include "base/array.h"
#include "config/scene.h"
#include "suite.h"
#include <stdio.h>
#include <string.h>

#define SCENE(field)                                                                                         \
  "schema: 1\nmembrane:\n  law: a\n  parameters: {E: " field "}\nflow: {kind: simple_shear, "                \
  "capillary_number: 1}\ntime: {end: 1}\n"

static Status read_text(Scene *scene, const char *text, Error *error) {
  return scene_read_text(scene, "scene.yaml", text, strlen(text), NULL, 0, error);
}

static const SceneField *read_good(Scene *scene, const char *text) {
  Error error;
  const Status status = read_text(scene, text, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  ck_assert_uint_eq(scene->membrane.elastic.n_parameters, 1);
  ck_assert_ptr_nonnull(scene->membrane.elastic.parameters[0].field);
  return scene->membrane.elastic.parameters[0].field;
}

START_TEST(a_spot_has_a_centre_a_radius_and_two_values) {
  Scene s;
  const SceneField *f = read_good(&s, SCENE("{around: [1, -2, .5], radius: 0.3, inside: 2 N/m, outside: 4}"));
  ck_assert_int_eq(f->kind, FIELD_AROUND);
  ck_assert(!f->around_P);
  ck_assert_double_eq(f->center[1], -2);
  ck_assert_double_eq(f->radius, 0.3);
  ck_assert(f->inside.has_unit && f->inside.value == 2 && f->outside.value == 4);
  scene_free(&s);
  ck_assert(read_good(&s, SCENE("{outside: 1, inside: 2, radius: 1, around: P}"))->around_P);
  scene_free(&s);
}
END_TEST

START_TEST(scatter_has_a_distribution_a_seed_and_perhaps_a_correlation) {
  Scene s;
  const SceneField *f = read_good(&s, SCENE("{seed: 7, weibull: {mean: 2, modulus: 8}, correlation: 0.2}"));
  ck_assert_int_eq(f->kind, FIELD_WEIBULL);
  ck_assert(f->seed == 7 && f->correlation == 0.2 && f->modulus == 8 && f->mean.value == 2);
  scene_free(&s);
  f = read_good(&s, SCENE("{uniform: {from: -1, to: 3}, seed: 999999999999999}"));
  ck_assert_int_eq(f->kind, FIELD_UNIFORM);
  ck_assert(f->seed == 999999999999999 && f->correlation == 0 && f->from.value == -1 && f->to.value == 3);
  scene_free(&s);
}
END_TEST

START_TEST(every_kind_reads_back_as_printed) {
  static const char *const fields[] = {
      SCENE("{around: P, radius: 0.1, inside: 1, outside: 0.3}"),
      SCENE("{around: [0.1, 0.2, 0.3], radius: 1e-3, inside: 35 mN/m, outside: 1 N/m}"),
      SCENE("{file: \"my \\\"own\\\" file\", times: 0.1, hash: 0123456789abcdef}"),
      SCENE("{file: a.txt}"),
      SCENE("{weibull: {scale: 0.7, modulus: 3.3}, seed: 0}"),
      SCENE("{weibull: {mean: 0.7, modulus: 3.3}, seed: 1, correlation: 0.17}"),
      SCENE("{normal: {mean: 0.7, deviation: 0.1}, seed: 2}"),
      SCENE("{log_normal: {mean: 0.7, deviation: 0.1}, seed: 3}"),
      SCENE("{uniform: {from: 0.7, to: 0.9}, seed: 4}"),
  };
  for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
    Scene first, second;
    Error error;
    Text once = {0}, twice = {0};
    read_good(&first, fields[i]);
    ck_assert_int_eq(scene_print(&first, NULL, &once, &error), STATUS_OK);
    const SceneField *a = first.membrane.elastic.parameters[0].field, *b = read_good(&second, once.data);
    ck_assert_int_eq(scene_print(&second, NULL, &twice, &error), STATUS_OK);
    ck_assert_str_eq(once.data, twice.data);
    ck_assert_int_eq(a->kind, b->kind);
    ck_assert(a->seed == b->seed && a->correlation == b->correlation && a->modulus == b->modulus);
    ck_assert(a->radius == b->radius && a->hash == b->hash && a->has_hash == b->has_hash);
    if (a->file) ck_assert_str_eq(a->file, b->file);
    text_free(&once);
    text_free(&twice);
    scene_free(&first);
    scene_free(&second);
  }
}
END_TEST

START_TEST(what_is_no_field_is_refused_with_its_place) {
  static const struct {
    const char *scene, *message;
  } table[] = {
      {SCENE("{}"), "scene.yaml:4:19: expected one of `around`, `file`, `weibull`"},
      {SCENE("{arround: P}"), "scene.yaml:4:20: expected a known key, found `membrane.parameters.E.arround` "
                              "(did you mean `around`?)"},
      {SCENE("{around: Q, radius: 1, inside: 1, outside: 1}"),
       "scene.yaml:4:28: expected `P` or a list of three numbers for `membrane.parameters.E.around`, found "
       "`Q`"},
      {SCENE("{around: [0, 1], radius: 1, inside: 1, outside: 1}"),
       "scene.yaml:4:28: expected `P` or a list"},
      {SCENE("{around: P, radius: 0, inside: 1, outside: 1}"), "scene.yaml:4:39: expected a number above 0"},
      {SCENE("{around: P, radius: 1 m, inside: 1, outside: 1}"),
       "scene.yaml:4:39: expected a number above 0"},
      {SCENE("{around: P, radius: 1, inside: 1}"),
       "scene.yaml:4:19: expected the key `membrane.parameters.E.outside` (a number or a quantity), found "
       "none"},
      {SCENE("{around: P, radius: 1, inside: 1, outside: x}"), "expected a number, found `x` for"},
      {SCENE("{around: P, radius: 1, inside: 1, outside: 1, seed: 3}"),
       "expected a known key, found `membrane.parameters.E.seed`"},
      {SCENE("{file: [a]}"), "scene.yaml:4:26: expected the path of a file"},
      {SCENE("{file: a, hash: 12}"), "expected 16 hexadecimal digits"},
      {SCENE("{weibull: 3, seed: 1}"),
       "scene.yaml:4:29: expected a mapping for `membrane.parameters.E.weibull`, found `3`"},
      {SCENE("{weibull: {mean: 1, modulus: 2}}"), "expected the key `membrane.parameters.E.seed`"},
      {SCENE("{weibull: {mean: 1, modulus: 2}, seed: -1}"), "expected a whole number of at most 15 digits"},
      {SCENE("{weibull: {mean: 1, modulus: 2}, seed: 1, corelation: 1}"), "(did you mean `correlation`?)"},
      {SCENE("{weibull: {mean: 1, modulus: 2}, seed: 1, correlation: -1}"),
       "expected a number of at least 0 for `membrane.parameters.E.correlation`"},
      {SCENE("{weibull: {mean: 1, scale: 1, modulus: 2}, seed: 1}"), "E.weibull.scale`, found both"},
      {SCENE("{weibull: {modulus: 2}, seed: 1}"), "E.weibull.scale`, found none"},
      {SCENE("{normal: {mean: 1, deviaton: 2}, seed: 1}"),
       "scene.yaml:4:38: expected a known key, found `membrane.parameters.E.normal.deviaton` (did you mean "
       "`deviation`?)"},
      {SCENE("{normal: {mean: 1, deviation: 2}, weibull: {}, seed: 1}"),
       "expected a known key, found `membrane.parameters.E.normal`"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Scene s;
    Error error;
    ck_assert_msg(read_text(&s, table[i].scene, &error) == STATUS_INPUT, "accepted: %s", table[i].scene);
    ck_assert_msg(strstr(error.text, table[i].message), "expected %s, found %s", table[i].message,
                  error.text);
  }
}
END_TEST

START_TEST(the_manual_names_every_key_of_a_field) {
  static const char *const keys[] = {"around",    "radius", "inside", "outside", "file",
                                     "times",     "hash",   "mean",   "scale",   "modulus",
                                     "deviation", "from",   "to",     "seed",    "correlation"};
  Text manual = {0};
  Error error;
  ck_assert_int_eq(scene_print_manual(&manual, &error), STATUS_OK);
  for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
    char cell[40];
    snprintf(cell, sizeof cell, "| `%s` |", keys[i]);
    ck_assert_msg(strstr(manual.data, cell), "no row for %s", keys[i]);
  }
  text_free(&manual);
}
END_TEST

START_TEST(reading_and_printing_survive_every_failing_allocation) {
  static const char text[] = SCENE("{weibull: {mean: 2, modulus: 8}, seed: 7, correlation: 0.2}");
  Status status = STATUS_MEMORY;
  for (long n = 1; status == STATUS_MEMORY; n++) {
    Scene s;
    Error error;
    Text yaml = {0};
    array_fail_nth(n);
    status = read_text(&s, text, &error);
    if (status == STATUS_OK) {
      status = scene_print(&s, NULL, &yaml, &error);
      scene_free(&s);
    }
    array_fail_nth(0);
    text_free(&yaml);
  }
  ck_assert_int_eq(status, STATUS_OK);
}
END_TEST

int main(void) {
  return suite_run("scene_field",
                   (SuiteTests){a_spot_has_a_centre_a_radius_and_two_values,
                                scatter_has_a_distribution_a_seed_and_perhaps_a_correlation,
                                every_kind_reads_back_as_printed, what_is_no_field_is_refused_with_its_place,
                                the_manual_names_every_key_of_a_field,
                                reading_and_printing_survive_every_failing_allocation, NULL});
}
