/* Tables and picture of run time against error, from a grid made up by hand. */
#include "benchmark/work_page.h"

#include "markup.h"
#include "suite.h"
#include <string.h>

/* Three meshes, two tolerances each; each finer mesh is ten times dearer and more accurate. */
static void make_grid(WorkPrecision *work) {
  static const double times[] = {1, 2};
  const RunState state = {.D12 = 0.5, .L = {3, 1, 2}};
  double dear = 1;
  *work = (WorkPrecision){.n = 6, .reference = {.knobs = {4, "quadratic", "fast", "rkc3", "1e-5"}}};
  for (int k = 0; k < 6; k++) {
    work->point[k] = (WorkPoint){.knobs = {1 + k / 2, "quadratic", "fast", "rkc3", k % 2 ? "1e-4" : "1e-2"},
                                 .run = {.times = times, .n_times = 2, .cpu_seconds = 0.1 * dear},
                                 .error = {.shape = 2e-2 / dear},
                                 .space = 1e-2 / dear,
                                 .time = (k % 2 ? 1e-4 : 2e-2) / dear,
                                 .is_on_front = true};
    work->point[k].run.state[0] = work->point[k].run.state[1] = state;
    dear *= k % 2 ? 5 : 2;
  }
  work->reference.run = work->point[0].run;
}

static void check_holds(const Text *text, const char *words) {
  ck_assert_msg(strstr(text->data, words) != NULL, "expected '%s' in:\n%s", words, text->data);
}

START_TEST(the_cheapest_choice_is_told_for_each_aim) {
  Error error;
  Text text = {0};
  WorkPrecision work;
  make_grid(&work);
  ck_assert_int_eq(work_print_choices(&work, &text, &error), STATUS_OK);
  check_holds(&text, "| 1 % | 80 | quadratic | fast | rkc3 1e-4 | 0.200 |");
  check_holds(&text, "| 0.1 % | 320 | quadratic | fast | rkc3 1e-4 | 2.000 |");
  check_holds(&text, "| 0.01 % | 1280 | quadratic | fast | rkc3 1e-4 | 20.000 |");
  work.n = 4;
  text_free(&text);
  ck_assert_int_eq(work_print_choices(&work, &text, &error), STATUS_OK);
  check_holds(&text, "| 0.01 % | not reached |");
  text_free(&text);
}
END_TEST

START_TEST(every_point_is_a_row_with_its_dominating_part) {
  Error error;
  Text text = {0};
  WorkPrecision work;
  make_grid(&work);
  ck_assert_int_eq(work_print_grid(&work, &text, &error), STATUS_OK);
  check_holds(&text, "| 1.0e-02 | 0.0e+00 | 2.0e-02 | time | front |");
  check_holds(&text, "| 5.0e-03 | 0.0e+00 | 5.0e-05 | space | front |");
  check_holds(&text, "the reference");
  text_free(&text);
}
END_TEST

START_TEST(each_mesh_is_a_row_and_each_time_a_column) {
  Error error;
  Text text = {0};
  WorkPrecision work;
  make_grid(&work);
  ck_assert_int_eq(work_print_meshes(&work, &text, &error), STATUS_OK);
  check_holds(&text, "| elements | D12 and d_max at t = 1 | D12 and d_max at t = 2 |\n|---|---|---|\n");
  check_holds(&text, "| 80 | 0.500000, 0.00000 | 0.500000, 0.00000 |\n| 320 |");
  text_free(&text);
}
END_TEST

START_TEST(the_picture_shows_meshes_front_aims_and_another_run) {
  Error error;
  Text svg = {0};
  WorkPrecision work;
  make_grid(&work);
  RunCost other = work.point[0].run;
  other.label = "another run";
  other.state[1].D12 = 0.6;
  ck_assert_int_eq(work_print_picture(&work, "a title", &other, &svg, &error), STATUS_OK);
  ck_assert(markup_is_nested(svg.data));
  const char *const words[] = {">a title<",
                               ">fast, 320 elements<",
                               ">fast, 1280 elements<",
                               ">another run<",
                               ">Pareto front<",
                               ">1 %<",
                               ">0.1 %<",
                               ">0.01 %<"};
  for (size_t k = 0; k < sizeof words / sizeof *words; k++) check_holds(&svg, words[k]);
  ck_assert_ptr_null(strstr(svg.data, "rk2 at its limit")); /* there is none in this grid */
  text_free(&svg);
}
END_TEST

int main(void) {
  return suite_run("work_page", (SuiteTests){the_cheapest_choice_is_told_for_each_aim,
                                             every_point_is_a_row_with_its_dominating_part,
                                             each_mesh_is_a_row_and_each_time_a_column,
                                             the_picture_shows_meshes_front_aims_and_another_run, NULL});
}
