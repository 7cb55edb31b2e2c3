/* capsella laws, as a user calls it. */
#include "law_scene.h"
#include "suite.h"
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char output[65536]; /* of the last call, errors included */

/* Runs `capsella laws ARGUMENTS`; returns the exit code. */
static int laws_with(const char *plugin_path, const char *arguments) {
  char command[1024];
  ck_assert_int_eq(chdir(BUILD_DIR), 0); /* its name may hold what a shell would not take */
  ck_assert_int_eq(setenv("MLAW_PLUGIN_PATH", plugin_path, 1), 0);
  snprintf(command, sizeof command, "./capsella laws %s 2>&1", arguments);
  FILE *pipe = popen(command, "r");
  ck_assert_ptr_nonnull(pipe);
  output[fread(output, 1, sizeof output - 1, pipe)] = '\0';
  const int status = pclose(pipe);
  ck_assert(WIFEXITED(status));
  return WEXITSTATUS(status);
}

static int laws(const char *arguments) {
  return laws_with("", arguments);
}

static void expect_output(const char *words) {
  ck_assert_msg(strstr(output, words) != NULL, "expected `%s` in:\n%s", words, output);
}

/* A row of the list: these words in this order on one line, however wide the columns are. */
static void expect_row(const char *const words[3]) {
  char copy[sizeof output];
  memcpy(copy, output, sizeof output);
  for (const char *at = strtok(copy, "\n"); at; at = strtok(NULL, "\n")) {
    const char *rest = at;
    int found = 0;
    while (found < 3 && (rest = strstr(rest, words[found]))) found++;
    if (found == 3) return;
  }
  ck_abort_msg("expected a row `%s %s %s` in:\n%s", words[0], words[1], words[2], output);
}

START_TEST(list_gives_kind_id_title_and_file_of_every_law) {
  ck_assert_int_eq(laws("list"), 0);
  expect_row((const char *[]){"energy  neo_hookean ", " Neo-Hookean membrane ", PLUGINS "/neo_hookean.so"});
  expect_row((const char *[]){"energy  skalak ", " Skalak's membrane ", PLUGINS "/skalak.so"});
  expect_row(
      (const char *[]){"damage  marigo ", " Brittle damage with linear hardening ", PLUGINS "/marigo.so"});
  char listed[sizeof output];
  memcpy(listed, output, sizeof output);
  ck_assert_int_eq(laws(""), 0); /* list is the default */
  ck_assert_str_eq(output, listed);
}
END_TEST

START_TEST(show_prints_an_energy_law_with_parameters_and_moduli) {
  ck_assert_int_eq(laws("show skalak"), 0);
  expect_output("skalak: Skalak's membrane\n");
  expect_output("kind       energy\n");
  expect_output("moduli     G_s = 1, K_s = 3 at rest, with defaults\n");
  expect_output("  C (1)  resistance to area change");
  expect_output("default 1, range (-0.5, inf), calibrated in [0, 100000]\n");
}
END_TEST

START_TEST(show_prints_a_damage_law_with_its_channels_and_history) {
  ck_assert_int_eq(laws("show marigo"), 0);
  expect_output("form       explicit");
  expect_output("driven by  Y (energy release rate)\n");
  expect_output("required, range [0, inf)\n");
  ck_assert_int_eq(laws("show ./template/general_damage_law.so"), 0);
  expect_output("driven by  T1 (larger principal tension)\n");
  expect_output("overloaded (s)  time spent beyond the strength; starts at 0\n");
}
END_TEST

START_TEST(show_tells_the_equations_of_a_law_and_makes_a_page_of_it) {
  ck_assert_int_eq(laws("show skalak"), 0);
  expect_output("\n\n    phi = G_s/4 (I1^2 + 2 I1 - 2 I2 + C I2^2)\n");
  ck_assert_int_eq(laws("show skalak --markdown"), 0);
  expect_output("# `skalak`\n\nSkalak's membrane.\n\n    phi = G_s/4");
  expect_output("\n| `C` | 1 | resistance to area change");
  ck_assert_int_eq(laws("show tests/abi/older.so#older_sheet"), 0); /* which says nothing of itself */
  expect_output("ABI 1.0");
  ck_assert_int_eq(laws("list --markdown"), 0);
  expect_output("| [`skalak`](skalak.md) | Skalak's membrane |\n");
}
END_TEST

START_TEST(a_law_that_is_not_there_is_an_input_error_with_the_nearest_name) {
  ck_assert_int_eq(laws("show skalek"), 2);
  expect_output("capsella laws: expected the energy or damage law `skalek`");
  expect_output("did you mean `skalak`?");
}
END_TEST

START_TEST(a_wrong_call_is_an_input_error_with_the_usage) {
  ck_assert_int_eq(laws("shw"), 2);
  expect_output("found 'shw'");
  expect_output("usage: capsella laws");
  ck_assert_int_eq(laws("show"), 2);
  ck_assert_int_eq(laws("show skalak --html"), 2);
  expect_output("usage: capsella laws show");
  ck_assert_int_eq(laws("show --help"), 0);
  ck_assert_int_eq(laws("--help"), 0);
  expect_output("usage: capsella laws");
}
END_TEST

START_TEST(check_prints_each_test_and_ends_with_1_when_one_fails) {
  ck_assert_int_eq(laws("check plugins/skalak.so --only energy/"), 0);
  expect_output("passed    energy/positive-moduli                 skalak: G_s = 1, K_s = 3\n");
  expect_output("plugins/skalak.so: 7 passed, 0 skipped, 0 failed\n");
  ck_assert_int_eq(laws("check tests/broken/prestressed.so --only energy/no-tension-at-rest"), 1);
  expect_output(
      "failed    energy/no-tension-at-rest              prestressed: expected phi_1 + phi_2 = 0 at rest");
  ck_assert_int_eq(laws("check tests/broken/prestressed.so --only energy/no-tension-at-rest --json"), 1);
  expect_output("\"test\": \"no-tension-at-rest\"");
  expect_output("\"outcome\": \"failed\"");
  expect_output("\"failed\": 1");
}
END_TEST

START_TEST(check_of_nothing_is_an_input_error) {
  ck_assert_int_eq(laws("check"), 2);
  ck_assert_int_eq(laws("check nothing.so"), 2);
  expect_output("nothing.so: not a file that can be read");
  ck_assert_int_eq(laws("check plugins/skalak.so --only nonsense"), 2);
  ck_assert_int_eq(laws("check plugins/skalak.so --time-limit soon"), 2);
  expect_output("expected a number of seconds after --time-limit, found 'soon'");
  ck_assert_int_eq(laws("check --help"), 0);
  expect_output("usage: capsella laws check");
}
END_TEST

START_TEST(plot_draws_the_curves_of_either_kind) {
  ck_assert_int_eq(laws("plot skalak --set C=2 -o tests/skalak.svg && cat tests/skalak.svg"), 0);
  expect_output("tests/skalak.svg\n");
  expect_output("<svg");
  expect_output("skalak: G_s = 1, C = 2");
  expect_output("equibiaxial");
  ck_assert_int_eq(laws("plot marigo --set Y_D=0.2 --set Y_C=2 -o tests/marigo.svg && cat tests/marigo.svg"),
                   0);
  expect_output("threshold");
  expect_output("drive Y");
}
END_TEST

START_TEST(plot_names_what_it_cannot_use) {
  ck_assert_int_eq(laws("plot"), 2);
  expect_output("usage: capsella laws plot");
  ck_assert_int_eq(laws("plot marigo"), 2);
  expect_output("expected the parameter Y_D");
  ck_assert_int_eq(laws("plot skalak --set C=-7"), 2);
  expect_output("--set: parameter C of law skalak: expected more than -0.5, found -7");
  ck_assert_int_eq(laws("plot skalak --set C"), 2);
  expect_output("expected PARAMETER=VALUE");
}
END_TEST

START_TEST(new_names_what_it_cannot_use_and_writes_nothing) {
  ck_assert_int_eq(laws("new"), 2);
  expect_output("expected a folder");
  ck_assert_int_eq(laws("new nowhere/tear"), 2);
  expect_output("expected --kind");
  ck_assert_int_eq(laws("new nowhere/tear --kind wood"), 2);
  expect_output("found 'wood'");
  ck_assert_int_eq(laws("new nowhere/Tear-3 --kind damage"), 2);
  expect_output("found 'Tear-3'");
  ck_assert_int_eq(laws("new nowhere/skalak --kind damage"), 2);
  expect_output("the law `skalak` exists, in " PLUGINS "/skalak.so");
  ck_assert_int_eq(access("nowhere", F_OK), -1);
  ck_assert_int_eq(laws("new plugins --kind damage"), 2);
  expect_output("plugins: expected a folder that is not there yet");
  ck_assert_int_eq(laws("new --help"), 0);
  expect_output("usage: capsella laws new");
}
END_TEST

START_TEST(check_speaks_tap) {
  ck_assert_int_eq(laws("check plugins/skalak.so --only energy/ --tap"), 0);
  expect_output("TAP version 14\n1..");
  expect_output("ok 6 - energy/positive-moduli skalak: G_s = 1, K_s = 3\n");
  ck_assert_ptr_null(strstr(output, "not ok"));
  ck_assert_int_eq(laws("check tests/broken/prestressed.so --only energy/no-tension-at-rest --tap"), 1);
  expect_output("TAP version 14\n1..2\nok 1 - load/opens-now-local\n");
  expect_output("not ok 2 - energy/no-tension-at-rest prestressed: expected phi_1 + phi_2 = 0 at rest");
}
END_TEST

START_TEST(a_plugin_that_crashes_costs_its_own_answer_alone) {
  /* Sanitizers end a process in their own way, by an exit code. */
  const bool is_sanitized = system("grep -q __[at]san_init " BUILD_DIR "/capsella") == 0;
  ck_assert_int_ne(laws("show tests/broken/crashes_at_load.so"), 0);
  if (!is_sanitized) {
    expect_output("capsella laws show: tests/broken/crashes_at_load.so crashed (signal ");
    ck_assert_int_ne(laws("plot tests/broken/crashes.so"), 0);
    expect_output("capsella laws plot: tests/broken/crashes.so crashed (signal ");
  }
  /* The faults that opening a file brings to light, and the laws that ship. */
  ck_assert_int_eq(laws_with(BUILD_DIR "/tests/broken", "list"), 0);
  if (!is_sanitized) expect_output("/crashes_at_load.so: crashed (signal ");
  expect_output("/no_entry.so: ");
  expect_output("/hangs_at_load.so: did not come back within 10 s");
  expect_row((const char *[]){"energy  crashes ", "", BUILD_DIR "/tests/broken/crashes.so"});
  expect_row((const char *[]){"energy  skalak ", " Skalak's membrane ", PLUGINS "/skalak.so"});
}
END_TEST

int main(void) {
  return suite_run("command_laws",
                   (SuiteTests){list_gives_kind_id_title_and_file_of_every_law,
                                show_prints_an_energy_law_with_parameters_and_moduli,
                                show_prints_a_damage_law_with_its_channels_and_history,
                                show_tells_the_equations_of_a_law_and_makes_a_page_of_it,
                                a_law_that_is_not_there_is_an_input_error_with_the_nearest_name,
                                a_wrong_call_is_an_input_error_with_the_usage,
                                check_prints_each_test_and_ends_with_1_when_one_fails,
                                check_of_nothing_is_an_input_error, plot_draws_the_curves_of_either_kind,
                                plot_names_what_it_cannot_use,
                                new_names_what_it_cannot_use_and_writes_nothing, check_speaks_tap,
                                a_plugin_that_crashes_costs_its_own_answer_alone, NULL});
}
