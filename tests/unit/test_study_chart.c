/* Charts of a study: which axis is drawn along, which lines there are, and when there is nothing to draw. */
#include "study/study_chart.h"
#include "study_file.h"
#include "suite.h"
#include <math.h>

static Text svg;

/* Draws `n` curves; whether there is a chart, which is left in `svg`. */
static bool draw(const char *vary, const Curve *curves, size_t n) {
  Study study = study_that_varies(vary);
  const StudyRun run = {.study = &study, .folder = scratch_folder};
  Error error;
  remove(scratch_path("chart.svg"));
  const Status status = study_chart_write(&run, "chart.svg", "D12", curves, n, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  study_free(&study);
  svg.length = 0;
  return file_exists(scratch_path("chart.svg")) &&
         file_read(scratch_path("chart.svg"), 1 << 20, &svg, &error) == STATUS_OK;
}

static int times(const char *words) {
  int n = 0;
  for (const char *at = svg.data; (at = strstr(at, words)); at++) n++;
  return n;
}

START_TEST(the_longest_axis_of_numbers_is_drawn_along_and_the_others_name_lines) {
  static const double values[] = {1, 2, 3, 4, 5, 6};
  const Curve curve = {.name = "", .values = values};
  ck_assert(draw("vary: {time.end: [5, 6], flow.capillary_number: [0.1, 0.2, 0.3]}\n", &curve, 1));
  ck_assert_int_ge(times("flow.capillary_number"), 1);
  ck_assert_int_eq(times("end = 5"), 1);
  ck_assert_int_eq(times("end = 6"), 1);
}
END_TEST

START_TEST(a_line_that_another_covers_is_drawn_once) {
  static const double values[] = {1, 2, 3, 1, 2, 3};
  const Curve curve = {.name = "D", .values = values};
  ck_assert(draw("vary: {time.end: [5, 6], flow.capillary_number: [0.1, 0.2, 0.3]}\n", &curve, 1));
  ck_assert_int_eq(times("D, end = 5"), 1);
  ck_assert_int_eq(times("end = 6"), 0);
}
END_TEST

START_TEST(what_is_not_finite_is_left_out_and_nothing_at_all_makes_no_chart) {
  static const double none[] = {NAN, NAN, INFINITY}, some[] = {NAN, 2, 3};
  const Curve curves[] = {{.name = "none", .values = none}, {.name = "some", .values = some}};
  const char *vary = "vary: {flow.capillary_number: [0.1, 0.2, 0.3]}\n";
  ck_assert(draw(vary, curves, 2));
  ck_assert_int_eq(times(">none"), 0);
  ck_assert(!draw(vary, curves, 1));
}
END_TEST

START_TEST(a_study_without_an_axis_of_two_numbers_has_no_chart) {
  static const double values[] = {1, 2};
  const Curve curve = {.name = "D", .values = values};
  ck_assert(!draw("vary: {flow.capillary_number: [0.1]}\n", &curve, 1));
  ck_assert(!draw("vary: {membrane.law: [neo_hookean, hooke]}\n", &curve, 1));
}
END_TEST

int main(void) {
  if (!scratch_make() || setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1) != 0) return 1;
  const int failed = suite_run(
      "study_chart", (SuiteTests){the_longest_axis_of_numbers_is_drawn_along_and_the_others_name_lines,
                                  a_line_that_another_covers_is_drawn_once,
                                  what_is_not_finite_is_left_out_and_nothing_at_all_makes_no_chart,
                                  a_study_without_an_axis_of_two_numbers_has_no_chart, NULL});
  text_free(&svg);
  scratch_remove();
  return failed;
}
