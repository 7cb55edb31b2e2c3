/* `--set KEY=VALUE`: what it changes in a scene, and that its mistakes name it. */
#include "config/scene.h"
#include "suite.h"
#include <stdio.h>
#include <string.h>

static const char SCENE[] = "schema: 1\n"
                            "membrane: {law: neo_hookean, parameters: {G_s: 1}, damage: {law: other}}\n"
                            "flow: {kind: simple_shear, capillary_number: 0.7}\n"
                            "time: {end: 10}\n";

START_TEST(settings_replace_and_add_in_order) {
  static const char *const sets[] = {"name=first",
                                     "name=second",
                                     "membrane.damage=",
                                     "membrane.damage.law=marigo",
                                     "membrane.damage.parameters.Y_D=0.3",
                                     "time.end=5",
                                     "stop={steady: 1e-6}"};
  Scene s;
  Error error;
  Status status = scene_read_text(&s, "scene.yaml", SCENE, strlen(SCENE), sets, 7, &error);
  ck_assert_msg(status == STATUS_OK, "%s", error.text);
  ck_assert_str_eq(s.name, "second");
  ck_assert_str_eq(s.membrane.damage.law, "marigo");
  ck_assert_str_eq(s.membrane.damage.place.file, "--set membrane.damage.law=marigo");
  ck_assert_int_eq(s.membrane.damage.place.line, 0);
  ck_assert_str_eq(s.membrane.damage.parameters[0].name, "Y_D");
  ck_assert(s.membrane.damage.parameters[0].value.value == 0.3);
  ck_assert(s.time.end == 5 && s.stop.steady == 1e-6);
  scene_free(&s);
}
END_TEST

START_TEST(an_empty_setting_removes_the_key) {
  static const char *const sets[] = {"membrane.damage=", "flow.capillary_number=",
                                     "flow.physical={radius: 1 m, viscosity: 1 Pa.s, shear_rate: 1 1/s}",
                                     "flow.physical.shear_modulus=2 N/m"};
  Scene s;
  Error error;
  ck_assert_int_eq(scene_read_text(&s, "scene.yaml", SCENE, strlen(SCENE), sets, 4, &error), STATUS_OK);
  ck_assert(!s.membrane.has_damage);
  ck_assert(s.flow.is_physical && s.flow.shear_modulus.value == 2);
  scene_free(&s);
}
END_TEST

START_TEST(settings_that_are_wrong_name_themselves) {
  static const struct {
    const char *set, *words;
  } table[] = {
      {"flow.capilary_number=1", "did you mean `flow.capillary_number`?"},
      {"flow.capillary_number=fast", "expected a number above 0 for `flow.capillary_number`, found `fast`"},
      {"flow.capillary_number=-1", "found `-1`"},
      {"flow.capillary_number", "expected KEY=VALUE, found no `=`"},
      {"=1", "expected a key"},
      {"flow.=1", "expected a key"},
      {".flow=1", "expected a key"},
      {"flow..kind=1", "expected a key"},
      {"schema.x=1", "expected a mapping under `schema`, found `1`"},
      {"flow=simple_shear", "expected a mapping for `flow`"},
      {"name=[a", "expected YAML, found a mistake"},
      {"name=*a", "expected a value, found the alias `*a`"},
      {"name=a\n---\nb", "expected one document"},
      {"name=#", "expected a value, found nothing"},
      {"flow.path=[[0, 0], [1, 1]]", "`flow.path` only where `flow.kind` is `inflation`"},
      {"flow.kind=", "expected the key `flow.kind`"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Scene scene;
    Error error;
    Status status = scene_read_text(&scene, "scene.yaml", SCENE, strlen(SCENE), &table[i].set, 1, &error);
    ck_assert_int_eq(status, STATUS_INPUT);
    ck_assert_msg(strstr(error.text, table[i].words) != NULL, "%s", error.text);
    char place[100];
    snprintf(place, sizeof place, "--set %s: ", table[i].set);
    bool is_missing = strcmp(table[i].set, "flow.kind=") == 0; /* the mapping that lacks the key is named */
    ck_assert_msg(is_missing || strncmp(error.text, place, strlen(place)) == 0, "%s", error.text);
  }
}
END_TEST

int main(void) {
  return suite_run("override",
                   (SuiteTests){settings_replace_and_add_in_order, an_empty_setting_removes_the_key,
                                settings_that_are_wrong_name_themselves, NULL});
}
