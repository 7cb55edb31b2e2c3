/* What opening a plugin checks of its tables: one thing at a time is spoiled in a sound one. */
#include "laws/plugin.h"
#include "sound_plugin.h"
#include "suite.h"
#include <string.h>

START_TEST(sound_tables_pass) {
  Sound sound;
  Error error;
  sound_make(&sound);
  ck_assert_int_eq(plugin_check(&sound.plugin, &error), STATUS_OK);
}
END_TEST

/* EXPRESSION spoils the sound plugin `s`. */
#define EXPECT_REFUSED(expression, words)                                                                    \
  do {                                                                                                       \
    Sound s;                                                                                                 \
    Error error = {.text = "nothing"};                                                                       \
    sound_make(&s);                                                                                          \
    expression;                                                                                              \
    ck_assert_int_eq(plugin_check(&s.plugin, &error), STATUS_INPUT);                                         \
    ck_assert_msg(strstr(error.text, words) != NULL, "expected `%s` in `%s`", words, error.text);            \
  } while (0)

START_TEST(a_plugin_names_itself_and_lists_what_it_counts) {
  EXPECT_REFUSED(s.plugin.author = NULL, "the plugin's id, version, license and author must be given");
  EXPECT_REFUSED(s.plugin.energy = NULL, "plugin `test` counts laws but has no table of them");
  EXPECT_REFUSED(s.plugin.damage = NULL, "plugin `test` counts laws but has no table of them");
  EXPECT_REFUSED(s.energy_list[0] = NULL,
                 "an energy law's descriptor is absent or shorter than that of ABI 1.0");
  EXPECT_REFUSED(s.damage_list[0] = NULL,
                 "a damage law's descriptor is absent or shorter than that of ABI 1.0");
  EXPECT_REFUSED(s.energy.size = 16, "an energy law's descriptor is absent or shorter");
  EXPECT_REFUSED(s.damage.size = 16, "a damage law's descriptor is absent or shorter");
}
END_TEST

START_TEST(a_law_names_itself_its_parameters_and_its_variables) {
  EXPECT_REFUSED(s.energy.id = NULL, "energy law `?`: id, title and source must be given");
  EXPECT_REFUSED(s.damage.source = NULL, "damage law `slip`: id, title and source must be given");
  EXPECT_REFUSED(s.param[1].unit = NULL, "law `elastic`: parameter 1 has no name, unit or description");
  EXPECT_REFUSED(s.var.about = NULL, "law `slip`: variable 0 has no name, unit or description");
}
END_TEST

START_TEST(entries_that_cannot_be_read_where_they_stand_are_refused) {
  EXPECT_REFUSED(s.energy.params = NULL, "law `elastic`: 2 parameters of 72 bytes each cannot be read");
  EXPECT_REFUSED(s.energy.param_size = 40, "law `elastic`: 2 parameters of 40 bytes each cannot be read");
  EXPECT_REFUSED(s.energy.param_size += 4, "law `elastic`: 2 parameters of 76 bytes each cannot be read");
  EXPECT_REFUSED(s.damage.vars = NULL, "law `slip`: 1 variables of 40 bytes each cannot be read");
  EXPECT_REFUSED(s.damage.var_size = 39, "law `slip`: 1 variables of 39 bytes each cannot be read");
  EXPECT_REFUSED(s.damage.var_size = 41, "law `slip`: 1 variables of 41 bytes each cannot be read");
}
END_TEST

START_TEST(a_law_computes_something_of_one_kind_from_channels_that_there_are) {
  EXPECT_REFUSED(s.energy.eval = NULL, "energy law `elastic` has no eval");
  EXPECT_REFUSED(s.damage.needs |= 1u << MLAW_N_CHANNELS, "damage law `slip` needs channels (mask 0xa0)");
  EXPECT_REFUSED(s.damage.update = NULL,
                 "damage law `slip` must give either threshold and evolution, or update");
  EXPECT_REFUSED(
      (s.damage.update = NULL, s.damage.threshold = s.damage.evolution = sound_step),
      "damage law `slip` is of the explicit kind: it needs the channel Y alone and has no variables");
  EXPECT_REFUSED(s.damage.threshold = sound_step, "damage law `slip` is of both kinds");
}
END_TEST

int main(void) {
  return suite_run("plugin_tables",
                   (SuiteTests){sound_tables_pass, a_plugin_names_itself_and_lists_what_it_counts,
                                a_law_names_itself_its_parameters_and_its_variables,
                                entries_that_cannot_be_read_where_they_stand_are_refused,
                                a_law_computes_something_of_one_kind_from_channels_that_there_are, NULL});
}
