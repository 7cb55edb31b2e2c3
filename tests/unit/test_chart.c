/* Charts as SVG documents: what is drawn where, in pixels that follow from the axes alone. */
#include "observe/chart.h"

#include "markup.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static Text printed(const Chart *chart) {
  Error error;
  Text svg = {0};
  ck_assert_msg(chart_print(chart, &svg, &error) == STATUS_OK, "%s", error.text);
  ck_assert(markup_is_nested(svg.data));
  return svg;
}

static int occurrences(const Text *text, const char *word) {
  int count = 0;
  for (const char *at = text->data; (at = strstr(at, word)); at++) count++;
  return count;
}

/* Prints the chart and looks for words that stand there so often. */
static void check_count(const Chart *chart, const char *word, int expected) {
  Text svg = printed(chart);
  const int found = occurrences(&svg, word);
  ck_assert_msg(found == expected, "%s: %d times, expected %d", word, found, expected);
  text_free(&svg);
}

static const double ramp_x[] = {0, 1, 2, 3, 4}, ramp_y[] = {0, 10, 20, 30, 40};
static const ChartSeries ramp = {.label = "ramp", .x = ramp_x, .y = ramp_y, .n = 5};

static Chart chart_of(const ChartSeries *series, size_t n) {
  return (Chart){.series = series, .n_series = n};
}

START_TEST(axes_title_and_series_are_labelled) {
  Chart chart = chart_of(&ramp, 1);
  chart.title = "run time & error";
  chart.x.label = "CPU seconds";
  chart.y.label = "error < 1";
  check_count(&chart, ">run time &amp; error<", 1);
  check_count(&chart, ">CPU seconds<", 1);
  check_count(&chart, ">error &lt; 1<", 1);
  check_count(&chart, ">ramp<", 1);
}
END_TEST

START_TEST(a_linear_axis_has_even_ticks_from_end_to_end) {
  const Chart chart = chart_of(&ramp, 1);
  const char *const ticks[] = {">1<", ">2<", ">3<", ">4<", ">10<", ">20<", ">30<", ">40<"};
  for (size_t k = 0; k < sizeof ticks / sizeof *ticks; k++) check_count(&chart, ticks[k], 1);
  check_count(&chart, ">0<", 2);
}
END_TEST

START_TEST(a_straight_line_is_straight) {
  /* From corner to corner of the plot: 520 by 340 pixels from (74, 16). */
  const Chart chart = chart_of(&ramp, 1);
  check_count(&chart, "d=\"M74.0 356.0L204.0 271.0L334.0 186.0L464.0 101.0L594.0 16.0\"", 1);
}
END_TEST

START_TEST(a_power_law_is_straight_on_logarithmic_axes) {
  const double x[] = {1, 10, 100, 1000, 1e4}, y[] = {1, 1e-2, 1e-4, 1e-6, 1e-8};
  const ChartSeries series = {.x = x, .y = y, .n = 5};
  Chart chart = chart_of(&series, 1);
  chart.x.logarithmic = chart.y.logarithmic = true;
  check_count(&chart, "d=\"M74.0 16.0L204.0 101.0L334.0 186.0L464.0 271.0L594.0 356.0\"", 1);
  check_count(&chart, ">10000<", 1);
  check_count(&chart, ">-8</tspan>", 1);
}
END_TEST

START_TEST(a_short_logarithmic_axis_still_has_ticks) {
  const double x[] = {1, 2, 3}, y[] = {3, 30, 40};
  const ChartSeries series = {.x = x, .y = y, .n = 3};
  Chart chart = chart_of(&series, 1);
  chart.x.logarithmic = chart.y.logarithmic = true;
  check_count(&chart, ">1.4<", 0); /* 1 to 5 in whole steps */
  check_count(&chart, ">3<", 1);
  check_count(&chart, ">20<", 1); /* 2 to 50 with 5, 10, 20 */
  check_count(&chart, ">50<", 1);
}
END_TEST

START_TEST(a_value_that_cannot_be_shown_breaks_the_line) {
  const double x[] = {0, 1, 2, 3, 4}, y[] = {0, 10, NAN, 30, 40}, of_zero[] = {1, 10, 0, 10, 1};
  const ChartSeries with_nan = {.x = x, .y = y, .n = 5}, with_zero = {.x = x, .y = of_zero, .n = 5};
  Chart chart = chart_of(&with_nan, 1);
  check_count(&chart, "d=\"M74.0 356.0L204.0 271.0M464.0 101.0L594.0 16.0\"", 1);
  chart = chart_of(&with_zero, 1);
  chart.y.logarithmic = true;
  check_count(&chart, "d=\"M74.0 356.0L204.0 16.0M464.0 16.0L594.0 356.0\"", 1);
}
END_TEST

START_TEST(points_on_one_pixel_are_drawn_once) {
  double x[1000], y[1000];
  for (int i = 0; i < 1000; i++) x[i] = y[i] = i < 500 ? 0 : 1;
  const ChartSeries series = {.x = x, .y = y, .n = 1000};
  const Chart chart = chart_of(&series, 1);
  check_count(&chart, "d=\"M74.0 356.0L594.0 16.0\"", 1);
}
END_TEST

START_TEST(marks_outside_a_given_range_are_left_out) {
  ChartSeries series = ramp;
  series.style = CHART_MARKS;
  series.label = NULL;
  Chart chart = chart_of(&series, 1);
  check_count(&chart, "class=\"mark\"", 5);
  chart.x.minimum = 0.5;
  chart.x.maximum = 3;
  check_count(&chart, "class=\"mark\"", 3);
}
END_TEST

START_TEST(a_highlighted_point_has_a_ring_and_its_words_do_not_cover_other_words) {
  const ChartPoint points[] = {{2, 20, "here"}, {2.02, 20.2, "there"}, {9, 9, "outside"}};
  Chart chart = chart_of(&ramp, 1);
  chart.x.maximum = 4;
  chart.points = points;
  chart.n_points = 3;
  Text svg = printed(&chart);
  ck_assert_int_eq(occurrences(&svg, "class=\"ring\""), 2);
  ck_assert_int_eq(occurrences(&svg, "cx=\"334.0\" cy=\"186.0\""), 1);
  double here[2], there[2];
  const char *at = strstr(strstr(svg.data, "class=\"ring\""), "<text");
  ck_assert_int_eq(sscanf(at, "<text x=\"%lf\" y=\"%lf\"", &here[0], &here[1]), 2);
  at = strstr(at + 1, "<text");
  ck_assert_int_eq(sscanf(at, "<text x=\"%lf\" y=\"%lf\"", &there[0], &there[1]), 2);
  ck_assert(fabs(here[0] - there[0]) > 36 || fabs(here[1] - there[1]) > 13); /* four letters, a line */
  text_free(&svg);
}
END_TEST

START_TEST(colours_and_marks_are_by_place_unless_given) {
  ChartSeries series[9];
  for (int s = 0; s < 9; s++) series[s] = (ChartSeries){.x = ramp_x, .y = ramp_y, .n = 5};
  series[8].color = 3;
  const Chart chart = chart_of(series, 9);
  check_count(&chart, "<g class=\"c1\">", 2); /* the first and the eighth */
  check_count(&chart, "<g class=\"c3\">", 2);
  check_count(&chart, "<g class=\"c7\">", 1);
}
END_TEST

START_TEST(a_single_point_is_drawn_in_the_middle) {
  const double x = 3, y = 1e-4;
  const ChartSeries series = {.x = &x, .y = &y, .n = 1, .style = CHART_MARKS};
  Chart chart = chart_of(&series, 1);
  chart.y.logarithmic = true; /* 2e-5 to 5e-4 around 1e-4: one decade and 0.4, the point half way */
  check_count(&chart, "class=\"mark\" transform=\"translate(334.0 186.0)\"", 1);
}
END_TEST

START_TEST(a_dark_scheme_is_followed) {
  const Chart chart = chart_of(&ramp, 1);
  check_count(&chart, "@media(prefers-color-scheme:dark)", 1);
}
END_TEST

START_TEST(nothing_to_draw_is_refused) {
  Error error;
  Text svg = {0};
  const double x[] = {1, 2}, y[] = {NAN, -1};
  const ChartSeries series = {.x = x, .y = y, .n = 2};
  Chart chart = chart_of(&series, 1);
  chart.y.logarithmic = true;
  ck_assert_int_eq(chart_print(&chart, &svg, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "chart: expected a point to draw, found none");
  chart = chart_of(&ramp, 1);
  chart.x.logarithmic = true;
  chart.x.maximum = 4;
  ck_assert_int_eq(chart_print(&chart, &svg, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "chart: the axis x cannot show 0 to 4");
  text_free(&svg);
}
END_TEST

int main(void) {
  return suite_run(
      "chart",
      (SuiteTests){axes_title_and_series_are_labelled, a_linear_axis_has_even_ticks_from_end_to_end,
                   a_straight_line_is_straight, a_power_law_is_straight_on_logarithmic_axes,
                   a_short_logarithmic_axis_still_has_ticks, a_value_that_cannot_be_shown_breaks_the_line,
                   points_on_one_pixel_are_drawn_once, marks_outside_a_given_range_are_left_out,
                   a_highlighted_point_has_a_ring_and_its_words_do_not_cover_other_words,
                   colours_and_marks_are_by_place_unless_given, a_single_point_is_drawn_in_the_middle,
                   a_dark_scheme_is_followed, nothing_to_draw_is_refused, NULL});
}
