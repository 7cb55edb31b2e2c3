/* What the checker says of tables that can be read but should not be: one thing at a time is spoiled in sound
 * ones. */
#include "laws/conformance_test.h"
#include "sound_plugin.h"
#include "suite.h"
#include <string.h>

static Verdict run(const char *name, const Subject *subject) {
  const ConformanceGroup *group = &conformance_description;
  for (size_t i = 0; i < group->n; i++)
    if (strcmp(group->test[i].name, name) == 0) return group->test[i].run(subject);
  ck_abort_msg("no test is called %s", name);
  return verdict_passed();
}

static Subject subject_of(const Sound *s, bool energy) {
  return (Subject){.plugin = &s->plugin,
                   .energy = energy ? &s->energy : NULL,
                   .damage = energy ? NULL : &s->damage,
                   .table = energy ? law_describe_energy(&s->energy) : law_describe_damage(&s->damage)};
}

START_TEST(sound_tables_pass_every_test) {
  Sound sound;
  sound_make(&sound);
  sound.param[1].name = "K_s";
  for (int energy = 0; energy < 2; energy++) {
    const Subject subject = subject_of(&sound, energy);
    for (size_t i = 0; i < conformance_description.n; i++) {
      const Verdict verdict = conformance_description.test[i].run(&subject);
      ck_assert_msg(verdict.outcome == CONFORMANCE_PASSED, "%s: %s", conformance_description.test[i].name,
                    verdict.text);
    }
  }
}
END_TEST

/* The test TEST_NAME fails with these words on the energy law (or the damage law) once EXPRESSION has spoiled
 * `s`.
 */
#define EXPECT_FAILED(test_name, is_energy, expression, words)                                               \
  do {                                                                                                       \
    Sound s;                                                                                                 \
    sound_make(&s);                                                                                          \
    s.param[1].name = "K_s";                                                                                 \
    expression;                                                                                              \
    const Subject subject = subject_of(&s, is_energy);                                                       \
    const Verdict found = run(test_name, &subject);                                                          \
    ck_assert_int_eq(found.outcome, CONFORMANCE_FAILED);                                                     \
    ck_assert_msg(strstr(found.text, words) != NULL, "expected `%s` in `%s`", words, found.text);            \
  } while (0)

START_TEST(ids_are_unique_and_such_as_scenes_can_name) {
  EXPECT_FAILED("ids-unique", true, s.plugin.n_energy = s.plugin.n_damage = 0,
                "at least one law, found none");
  EXPECT_FAILED("ids-unique", true, s.damage.id = "elastic", "expected each id once, found `elastic` twice");
  EXPECT_FAILED("id-well-formed", true, s.energy.id = "My Law", "found `My Law`");
}
END_TEST

START_TEST(nothing_that_a_reader_needs_is_empty_or_twice_there) {
  EXPECT_FAILED("strings-present", true, s.energy.title = "", "expected a title and a source");
  EXPECT_FAILED("strings-present", true, s.param[1].unit = "", "meaning of parameter 1, found an empty one");
  EXPECT_FAILED("strings-present", false, s.var.about = "", "meaning of variable 0, found an empty one");
  EXPECT_FAILED("names-unique", true, s.param[1].name = "G_s",
                "expected each parameter once, found G_s twice");
}
END_TEST

START_TEST(ranges_hold_what_lies_in_them) {
  EXPECT_FAILED("default-inside-hard", true, s.param[0].hi = -1,
                "expected a range with lo < hi, found 0 .. -1");
  EXPECT_FAILED("default-inside-hard", true, s.param[0].value = -1,
                "expected a default inside 0 .. inf, found -1");
  EXPECT_FAILED("default-inside-hard", true, (s.param[0].value = 0, s.param[0].flags = MLAW_OPEN_LO),
                "expected a default inside 0 .. inf, found 0");
  EXPECT_FAILED("default-inside-hard", true, s.param[0].value = NAN, "found nan");
  EXPECT_FAILED("calibrated-inside-hard", true, s.param[0].ok_lo = -1,
                "expected a calibrated range inside 0 .. inf, found -1 .. inf");
  EXPECT_FAILED("start-finite", false, s.var.init = NAN, "variable s: expected a finite start, found nan");
}
END_TEST

START_TEST(units_are_read_and_agree_with_their_exponents) {
  EXPECT_FAILED("unit-agrees-with-exponents", true, s.param[0].unit = "furlong", "G_s: ");
  EXPECT_FAILED(
      "unit-agrees-with-exponents", true, s.param[0].dim[0] = 2,
      "G_s: expected powers of mass, length and time {1, 0, -2, 0} for the unit N/m, found {2, 0, -2, 0}");
  EXPECT_FAILED("unit-agrees-with-exponents", true, s.param[0].unit = "mN/m",
                "G_s: expected an SI unit without prefix, found mN/m");
  EXPECT_FAILED("unit-agrees-with-exponents", false, s.var.dim[3] = 1, "s: expected powers of mass");
}
END_TEST

START_TEST(sizes_and_counts_are_believable) {
  EXPECT_FAILED("sizes-sane", true, s.energy.size = 5000, "expected sizes below 4096 bytes, found law 5000");
  EXPECT_FAILED("sizes-sane", true, s.energy.n_params = 65,
                "at most 64 parameters and 16 variables, found 65 and 0");
}
END_TEST

int main(void) {
  return suite_run("conformance_description",
                   (SuiteTests){sound_tables_pass_every_test, ids_are_unique_and_such_as_scenes_can_name,
                                nothing_that_a_reader_needs_is_empty_or_twice_there,
                                ranges_hold_what_lies_in_them, units_are_read_and_agree_with_their_exponents,
                                sizes_and_counts_are_believable, NULL});
}
