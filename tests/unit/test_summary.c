/* summary.json: the keys of the interface, all of them, in order, and null where there is nothing. */
#include "observe/summary.h"

#include "base/file.h"
#include "scratch.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static const char *const keys[] = {"status",
                                   "t",
                                   "D12",
                                   "beta",
                                   "L1",
                                   "L2",
                                   "L3",
                                   "area_strain",
                                   "volume_error",
                                   "volume_error_max",
                                   "d_max",
                                   "d_max_location",
                                   "Y_max",
                                   "t_c",
                                   "t_l",
                                   "rupture",
                                   "energy_error_max",
                                   "step_error_max",
                                   "film_min",
                                   "wrinkle_amplitude_max",
                                   "unstable_steps",
                                   "steps",
                                   "rejected_steps",
                                   "evaluations",
                                   "stage_evaluations",
                                   "wall_seconds",
                                   "threads",
                                   "elements",
                                   "nodes",
                                   "skipped"};

static Summary ruptured(void) {
  static const char *const skipped[] = {"fluid: an inflation has none", "double layer: \"no\" contrast"};
  return (Summary){.status = OUTCOME_RUPTURED,
                   .t = 4.25,
                   .D12 = 0.57,
                   .beta = 0.3,
                   .d_max = 1,
                   .d_max_location = {{0, 1, 0}, {0, 1.25, 0}},
                   .t_c = 0.9,
                   .t_l = 4.25,
                   .has_rupture = true,
                   .rupture = {{0, 1, 0}, {0, 1.25, 0}, 0.5, 89.5},
                   .damaged_area_fraction = 0.25,
                   .steps = 85,
                   .evaluations = 600,
                   .stage_evaluations = 510,
                   .elements = 1280,
                   .nodes = 2562,
                   .skipped = skipped,
                   .n_skipped = 2};
}

/* The text after `"key": ` at the outer level (two spaces deep). */
static const char *value_of(const Text *text, const char *key) {
  char start[64];
  snprintf(start, sizeof start, "\n  \"%s\": ", key);
  const char *found = strstr(text->data, start);
  ck_assert_msg(found != NULL, "%s is missing", key);
  return found + strlen(start);
}

static bool has_value(const Text *text, const char *key, const char *value) {
  return strncmp(value_of(text, key), value, strlen(value)) == 0;
}

START_TEST(every_key_of_the_interface_is_there_in_order_and_no_other) {
  Error error;
  Text text = {0};
  const Summary summary = ruptured();
  ck_assert_int_eq(summary_print(&summary, &text, &error), STATUS_OK);
  const char *last = text.data;
  for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
    const char *found = value_of(&text, keys[k]);
    ck_assert_msg(found > last, "%s is out of order", keys[k]);
    last = found;
  }
  size_t outer_keys = 0;
  for (const char *line = text.data; (line = strstr(line, "\n  \"")); line++) outer_keys++;
  ck_assert_uint_eq(outer_keys, sizeof keys / sizeof *keys);
  text_free(&text);
}
END_TEST

START_TEST(a_rupture_tells_where_and_how) {
  Error error;
  Text text = {0};
  const Summary summary = ruptured();
  ck_assert_int_eq(summary_print(&summary, &text, &error), STATUS_OK);
  ck_assert(has_value(&text, "status", "\"ruptured\","));
  ck_assert(has_value(&text, "t_l", "4.25,"));
  ck_assert(has_value(&text, "d_max_location", "{\n    \"X\": [0, 1, 0],\n    \"x\": [0, 1.25, 0]\n  },"));
  ck_assert(has_value(&text, "rupture",
                      "{\n    \"X\": [0, 1, 0],\n    \"x\": [0, 1.25, 0],\n"
                      "    \"angle_to_vorticity_deg\": 0.5,\n    \"angle_to_major_axis_deg\": 89.5,\n"
                      "    \"damaged_area_fraction\": 0.25\n  },"));
  ck_assert(has_value(&text, "skipped",
                      "[\n    \"fluid: an inflation has none\",\n"
                      "    \"double layer: \\\"no\\\" contrast\"\n  ]"));
  text_free(&text);
}
END_TEST

START_TEST(what_there_is_not_is_null_and_never_nan) {
  Error error;
  Text text = {0};
  const Summary summary = {.status = OUTCOME_END,
                           .beta = NAN,
                           .d_max = 0,
                           .t_c = NAN,
                           .t_l = NAN,
                           .energy_error_max = NAN,
                           .step_error_max = NAN,
                           .film_min = NAN,
                           .wrinkle_amplitude_max = NAN};
  ck_assert_int_eq(summary_print(&summary, &text, &error), STATUS_OK);
  const char *const without[] = {
      "beta",     "d_max_location",       "t_c", "t_l", "rupture", "energy_error_max", "step_error_max",
      "film_min", "wrinkle_amplitude_max"};
  for (size_t k = 0; k < sizeof without / sizeof *without; k++)
    ck_assert_msg(has_value(&text, without[k], "null,"), "%s", without[k]);
  ck_assert(has_value(&text, "skipped", "[]\n}"));
  ck_assert_ptr_null(strstr(text.data, "nan"));
  text_free(&text);
}
END_TEST

START_TEST(outcomes_have_the_names_of_the_interface) {
  ck_assert_str_eq(outcome_name(OUTCOME_STEADY), "steady");
  ck_assert_str_eq(outcome_name(OUTCOME_END), "end");
  ck_assert_str_eq(outcome_name(OUTCOME_RUPTURED), "ruptured");
  ck_assert_str_eq(outcome_name(OUTCOME_FAILED), "failed");
  ck_assert_str_eq(outcome_name(OUTCOME_INTERRUPTED), "interrupted");
}
END_TEST

START_TEST(the_file_holds_what_is_printed) {
  Error error;
  Text printed = {0}, written = {0};
  const Summary summary = ruptured();
  ck_assert_int_eq(summary_print(&summary, &printed, &error), STATUS_OK);
  ck_assert_int_eq(summary_write(&summary, scratch_path("summary.json"), &error), STATUS_OK);
  ck_assert_int_eq(file_read(scratch_path("summary.json"), 1 << 20, &written, &error), STATUS_OK);
  ck_assert_str_eq(printed.data, written.data);
  ck_assert_int_eq(summary_write(&summary, scratch_path("no/summary.json"), &error), STATUS_IO);
  text_free(&printed);
  text_free(&written);
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  int result =
      suite_run("summary",
                (SuiteTests){every_key_of_the_interface_is_there_in_order_and_no_other,
                             a_rupture_tells_where_and_how, what_there_is_not_is_null_and_never_nan,
                             outcomes_have_the_names_of_the_interface, the_file_holds_what_is_printed, NULL});
  scratch_remove();
  return result;
}
