#include "observe/chart.h"

#include "base/array.h"
#include "observe/svg.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Pixels. */
enum {
  PLOT_WIDTH = 520,
  PLOT_HEIGHT = 340,
  LEFT = 74,   /* of the plot: tick labels and the label of y */
  RIGHT = 24,  /* of the plot, before the legend */
  ABOVE = 16,  /* the plot, and TITLE more with a title */
  BELOW = 56,  /* tick labels and the label of x */
  TITLE = 24,  /* height of a line of text in the title and the legend */
  SAMPLE = 30, /* width of a sample of a series in the legend */
  LETTER = 8,  /* the width of a letter, at most on average */
};
enum { COLORS = 7, MARKS = 6, TICKS_MAX = 64 };

typedef struct {
  bool logarithmic;
  double low, high; /* of the axis; logarithms on a logarithmic one */
  double pixel, pixels;
} Scale;

typedef struct {
  Scale x, y;
  double top; /* of the plot */
} Frame;

typedef struct {
  double left, top, right, bottom;
} Box;

/* Colours after Okabe and Ito; lighter on a dark ground. */
static const char STYLE[] =
    "<style>\n"
    ".chart{font:13px sans-serif}\n"
    ".chart .ground{fill:#fff}\n"
    ".chart text{fill:#222;stroke:none}\n"
    ".chart .note text{paint-order:stroke;stroke:#fff;stroke-width:4}\n"
    ".chart .axis{stroke:#444;fill:none}\n"
    ".chart .grid{stroke:#e2e2e2;fill:none}\n"
    ".chart .ring{stroke:#222;stroke-width:1.5;fill:none}\n"
    ".chart .line{stroke:currentColor;stroke-width:2;stroke-linejoin:round;fill:none}\n"
    ".chart .mark{fill:currentColor;stroke:#fff;stroke-width:.8}\n"
    ".chart .c1{color:#0072b2}.chart .c2{color:#d55e00}.chart .c3{color:#009e73}.chart .c4{color:#cc79a7}\n"
    ".chart .c5{color:#e69f00}.chart .c6{color:#56b4e9}.chart .c7{color:#666}\n"
    "@media(prefers-color-scheme:dark){\n"
    ".chart .ground{fill:#16181c}\n"
    ".chart text{fill:#e4e4e4}\n"
    ".chart .note text{stroke:#16181c}\n"
    ".chart .axis{stroke:#aaa}\n"
    ".chart .grid{stroke:#33373d}\n"
    ".chart .ring{stroke:#eee}\n"
    ".chart .mark{stroke:#16181c}\n"
    ".chart .c1{color:#3f9fe0}.chart .c2{color:#f0793a}.chart .c3{color:#25c196}.chart .c4{color:#e39fc4}\n"
    ".chart .c5{color:#f2b535}.chart .c6{color:#9bd8ff}.chart .c7{color:#aaa}\n"
    "}\n"
    "</style>\n";

/* Around (0, 0): circle, square, diamond, triangle, triangle upside down, cross. */
static const char *const mark_paths[MARKS] = {"M-4.5 0a4.5 4.5 0 1 1 9 0a4.5 4.5 0 1 1-9 0z",
                                              "M-4-4h8v8h-8z",
                                              "M0-5.5l5.5 5.5l-5.5 5.5l-5.5-5.5z",
                                              "M0-5.2l5 8.7h-10z",
                                              "M0 5.2l5-8.7h-10z",
                                              "M-5-2h3v-3h4v3h3v4h-3v3h-4v-3h-3z"};

static int color_of(const ChartSeries *series, size_t place) {
  return 1 + (series->color ? series->color - 1 : (int)place) % COLORS;
}
static const char *mark_of(const ChartSeries *series, size_t place) {
  return mark_paths[(series->mark ? series->mark - 1 : (int)place) % MARKS];
}
static bool has_line(const ChartSeries *series) {
  return series->style != CHART_MARKS;
}
static bool has_marks(const ChartSeries *series) {
  return series->style == CHART_MARKS || series->style == CHART_LINE_AND_MARKS;
}

/* --- scales --- */

/* NAN: a value that the axis cannot show. */
static double position(bool logarithmic, double value) {
  if (!isfinite(value) || (logarithmic && !(value > 0))) return NAN;
  return logarithmic ? log10(value) : value;
}
static double pixel_of(const Scale *scale, double value) {
  const double fraction = (position(scale->logarithmic, value) - scale->low) / (scale->high - scale->low);
  return scale->pixel + fraction * scale->pixels;
}
/* With a little room for round-off at the ends. */
static bool is_within(const Scale *scale, double value) {
  const double at = position(scale->logarithmic, value), room = 1e-9 * (scale->high - scale->low);
  return at >= scale->low - room && at <= scale->high + room; /* false for NAN */
}

static void widen(double *low, double *high, double value) {
  if (isnan(value)) return;
  *low = fmin(*low, value);
  *high = fmax(*high, value);
}

/* Of the points that can be shown on both axes. */
static void range_of_data(const Chart *chart, bool of_x, double *low, double *high) {
  const bool log_x = chart->x.logarithmic, log_y = chart->y.logarithmic;
  *low = HUGE_VAL;
  *high = -HUGE_VAL;
  for (size_t s = 0; s < chart->n_series; s++)
    for (size_t i = 0; i < chart->series[s].n; i++) {
      const double x = position(log_x, chart->series[s].x[i]), y = position(log_y, chart->series[s].y[i]);
      if (!isnan(x) && !isnan(y)) widen(low, high, of_x ? x : y);
    }
  for (size_t p = 0; p < chart->n_points; p++)
    widen(low, high, of_x ? position(log_x, chart->points[p].x) : position(log_y, chart->points[p].y));
}

/* Outward to whole steps; on a logarithmic axis to 1, 2 or 5 times a power of ten. */
static void round_outward(bool logarithmic, double *low, double *high) {
  if (*high - *low <= 1e-9 * fmax(fabs(*low), fabs(*high))) { /* one value, or round-off */
    const double half = logarithmic ? 0.5 : *low == 0 ? 0.5 : 0.5 * fabs(*low);
    *low -= half;
    *high += half;
  }
  if (!logarithmic) {
    const double step = svg_tick_step(*high - *low, 5);
    *low = step * floor(*low / step + 1e-9);
    *high = step * ceil(*high / step - 1e-9);
    return;
  }
  static const double parts[] = {0, 0.30102999566398120, 0.69897000433601880, 1};
  const double below = floor(*low), above = floor(*high);
  int i = 3, k = 0;
  while (below + parts[i] > *low + 1e-9) i--;
  while (above + parts[k] < *high - 1e-9) k++;
  *low = below + parts[i];
  *high = above + parts[k];
}

static Status scale_of(const Chart *chart, bool of_x, Scale *scale, Error *error) {
  const ChartAxis *axis = of_x ? &chart->x : &chart->y;
  scale->logarithmic = axis->logarithmic;
  if (axis->minimum < axis->maximum) {
    scale->low = position(axis->logarithmic, axis->minimum);
    scale->high = position(axis->logarithmic, axis->maximum);
    if (isnan(scale->low) || isnan(scale->high))
      return error_set(error, STATUS_INPUT, "chart: the axis %s cannot show %g to %g", of_x ? "x" : "y",
                       axis->minimum, axis->maximum);
    return STATUS_OK;
  }
  range_of_data(chart, of_x, &scale->low, &scale->high);
  if (!(scale->low <= scale->high))
    return error_set(error, STATUS_INPUT, "chart: expected a point to draw, found none");
  round_outward(axis->logarithmic, &scale->low, &scale->high);
  return STATUS_OK;
}

/* --- ticks --- */

typedef struct {
  double value[TICKS_MAX];
  bool is_labelled[TICKS_MAX];
  int n;
} Ticks;

static void add_tick(Ticks *ticks, const Scale *scale, double value, bool is_labelled) {
  if (ticks->n == TICKS_MAX || !is_within(scale, value)) return;
  ticks->value[ticks->n] = value;
  ticks->is_labelled[ticks->n++] = is_labelled;
}

static void add_even_ticks(Ticks *ticks, const Scale *scale, double low, double high) {
  const double step = svg_tick_step(high - low, 5);
  for (double k = ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
    add_tick(ticks, scale, k * step, true);
}

/* Below one decade even steps; up to two also 2 and 5 are labelled; beyond seven not every power. */
static void find_ticks(const Scale *scale, Ticks *ticks) {
  const double decades = scale->high - scale->low;
  ticks->n = 0;
  if (!scale->logarithmic) {
    add_even_ticks(ticks, scale, scale->low, scale->high);
  } else if (decades < 1) {
    add_even_ticks(ticks, scale, pow(10, scale->low), pow(10, scale->high));
  } else {
    const int stride = (int)ceil(decades / 7);
    for (int power = (int)floor(scale->low); power <= scale->high + 1e-9; power++)
      for (int digit = 1; digit < (decades < 7 ? 10 : 2); digit++)
        add_tick(ticks, scale, digit * pow(10, power),
                 digit == 1 ? power % stride == 0 : decades <= 2 && (digit == 2 || digit == 5));
  }
}

static Status print_axes(const Chart *chart, const Frame *frame, Text *svg, Error *error) {
  Status status;
  Ticks x, y;
  const double left = LEFT, top = frame->top, bottom = top + PLOT_HEIGHT;
  find_ticks(&frame->x, &x);
  find_ticks(&frame->y, &y);
  TRY(text_append(svg, error, "<path class=\"grid\" d=\""));
  for (int k = 0; k < x.n; k++)
    if (x.is_labelled[k])
      TRY(text_append(svg, error, "M%.1f %gv%d", pixel_of(&frame->x, x.value[k]), top, PLOT_HEIGHT));
  for (int k = 0; k < y.n; k++)
    if (y.is_labelled[k])
      TRY(text_append(svg, error, "M%g %.1fh%d", left, pixel_of(&frame->y, y.value[k]), PLOT_WIDTH));
  TRY(text_append(svg, error, "\"/>\n<path class=\"axis\" d=\"M%g %gh%dv%dh-%dz", left, top, PLOT_WIDTH,
                  PLOT_HEIGHT, PLOT_WIDTH));
  for (int k = 0; k < x.n; k++)
    TRY(text_append(svg, error, "M%.1f %gv%d", pixel_of(&frame->x, x.value[k]), bottom,
                    x.is_labelled[k] ? -6 : -3));
  for (int k = 0; k < y.n; k++)
    TRY(text_append(svg, error, "M%g %.1fh%d", left, pixel_of(&frame->y, y.value[k]),
                    y.is_labelled[k] ? 6 : 3));
  TRY(text_append(svg, error, "\"/>\n"));
  for (int k = 0; k < x.n; k++)
    if (x.is_labelled[k])
      TRY(svg_number(svg, pixel_of(&frame->x, x.value[k]), bottom + 19, "middle", x.value[k], error));
  for (int k = 0; k < y.n; k++)
    if (y.is_labelled[k])
      TRY(svg_number(svg, left - 8, pixel_of(&frame->y, y.value[k]) + 4.5, "end", y.value[k], error));
  if (chart->x.label)
    TRY(svg_label(svg, left + 0.5 * PLOT_WIDTH, bottom + 43, "middle", chart->x.label, error));
  if (chart->y.label) {
    TRY(text_append(svg, error, "<g transform=\"translate(18 %g)rotate(-90)\">", top + 0.5 * PLOT_HEIGHT));
    TRY(svg_label(svg, 0, 0, "middle", chart->y.label, error));
    TRY(text_append(svg, error, "</g>\n"));
  }
cleanup:
  return status;
}

/* --- series --- */

/* The inner document cuts off what leaves the plot.  Points that fall on the tenth of a pixel of the one
 * before are not repeated. */
static Status print_line(const ChartSeries *series, const Frame *frame, Text *svg, Error *error) {
  Status status;
  char last[64] = "";
  bool is_broken = true;
  TRY(text_append(svg, error, "<svg x=\"%d\" y=\"%g\" width=\"%d\" height=\"%d\" viewBox=\"%d %g %d %d\">",
                  LEFT, frame->top, PLOT_WIDTH, PLOT_HEIGHT, LEFT, frame->top, PLOT_WIDTH, PLOT_HEIGHT));
  TRY(text_append(svg, error, "<path class=\"line\"%s d=\"",
                  series->style == CHART_DASHES ? " stroke-dasharray=\"7 5\"" : ""));
  for (size_t i = 0; i < series->n; i++) {
    const double x = pixel_of(&frame->x, series->x[i]), y = pixel_of(&frame->y, series->y[i]);
    char point[64];
    if (isnan(x) || isnan(y)) {
      is_broken = true;
      continue;
    }
    snprintf(point, sizeof point, "%.1f %.1f", x, y);
    if (is_broken || strcmp(point, last) != 0)
      TRY(text_append(svg, error, "%c%s", is_broken ? 'M' : 'L', point));
    memcpy(last, point, sizeof last);
    is_broken = false;
  }
  TRY(text_append(svg, error, "\"/></svg>\n"));
cleanup:
  return status;
}

static Status print_mark(const char *path, double x, double y, Text *svg, Error *error) {
  return text_append(svg, error, "<path class=\"mark\" transform=\"translate(%.1f %.1f)\" d=\"%s\"/>\n", x, y,
                     path);
}

static Status print_series(const ChartSeries *series, size_t place, const Frame *frame, Text *svg,
                           Error *error) {
  Status status;
  TRY(text_append(svg, error, "<g class=\"c%d\">\n", color_of(series, place)));
  if (has_line(series)) TRY(print_line(series, frame, svg, error));
  for (size_t i = 0; has_marks(series) && i < series->n; i++)
    if (is_within(&frame->x, series->x[i]) && is_within(&frame->y, series->y[i]))
      TRY(print_mark(mark_of(series, place), pixel_of(&frame->x, series->x[i]),
                     pixel_of(&frame->y, series->y[i]), svg, error));
  TRY(text_append(svg, error, "</g>\n"));
cleanup:
  return status;
}

/* --- highlighted points --- */

static size_t length_of(const char *utf8) {
  size_t letters = 0;
  for (const char *s = utf8; *s; s++) letters += ((unsigned char)*s & 0xC0) != 0x80;
  return letters;
}

static bool overlap(const Box *a, const Box *b) {
  return a->left < b->right && b->left < a->right && a->top < b->bottom && b->top < a->bottom;
}

/* How much a label hides there: other labels most, then points, then what sticks out of the plot. */
static double crowding(const Chart *chart, const Frame *frame, const Box *label, const Box *others,
                       size_t n_others) {
  double sum = 0;
  for (size_t k = 0; k < n_others; k++) sum += overlap(label, &others[k]) ? 20 : 0;
  for (size_t s = 0; s < chart->n_series; s++)
    for (size_t i = 0; i < chart->series[s].n; i++) {
      const double x = pixel_of(&frame->x, chart->series[s].x[i]),
                   y = pixel_of(&frame->y, chart->series[s].y[i]);
      const Box mark = {x - 4, y - 4, x + 4, y + 4};
      sum += overlap(label, &mark) ? 3 : 0;
    }
  const Box plot = {LEFT, frame->top, LEFT + PLOT_WIDTH, frame->top + PLOT_HEIGHT};
  const bool is_inside = label->left >= plot.left && label->right <= plot.right && label->top >= plot.top &&
                         label->bottom <= plot.bottom;
  return sum + (is_inside ? 0 : 100);
}

/* Of eight places around the point the least crowded one. */
static Box place_label(const Chart *chart, const Frame *frame, double x, double y, double width,
                       const Box *others, size_t n_others) {
  enum { HEIGHT = 15, GAP = 9 };
  static const int around[8][2] = {{1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}};
  Box best = {0};
  double least = HUGE_VAL;
  for (int k = 0; k < 8; k++) {
    const int right = around[k][0], down = around[k][1];
    const double left = right > 0 ? x + GAP : right < 0 ? x - GAP - width : x - 0.5 * width;
    const double top = y - 0.5 * HEIGHT + down * (right ? 0.6 * HEIGHT : HEIGHT + 2);
    const Box box = {left, top, left + width, top + HEIGHT};
    const double sum = crowding(chart, frame, &box, others, n_others);
    if (sum < least) {
      least = sum;
      best = box;
    }
  }
  return best;
}

static Status print_points(const Chart *chart, const Frame *frame, Text *svg, Error *error) {
  Status status;
  Box *boxes = NULL;
  size_t n_boxes = 0;
  TRY(ARRAY_NEW(&boxes, chart->n_points, error));
  TRY(text_append(svg, error, "<g class=\"note\">\n"));
  for (size_t p = 0; p < chart->n_points; p++) {
    const ChartPoint *point = &chart->points[p];
    if (!is_within(&frame->x, point->x) || !is_within(&frame->y, point->y)) continue;
    const double x = pixel_of(&frame->x, point->x), y = pixel_of(&frame->y, point->y);
    TRY(text_append(svg, error, "<circle class=\"ring\" cx=\"%.1f\" cy=\"%.1f\" r=\"8\"/>\n", x, y));
    if (!point->label) continue;
    const double width = (double)(LETTER * length_of(point->label));
    const Box box = place_label(chart, frame, x, y, width, boxes, n_boxes);
    boxes[n_boxes++] = box;
    TRY(svg_label(svg, 0.5 * (box.left + box.right), box.bottom - 3, "middle", point->label, error));
  }
  TRY(text_append(svg, error, "</g>\n"));
cleanup:
  array_free(boxes);
  return status;
}

/* --- the legend --- */

/* 0: no series has a label. */
static double legend_width(const Chart *chart) {
  size_t letters = 0;
  for (size_t s = 0; s < chart->n_series; s++)
    if (chart->series[s].label && length_of(chart->series[s].label) > letters)
      letters = length_of(chart->series[s].label);
  return letters ? (double)(SAMPLE + 8 + LETTER * letters) : 0;
}

static int legend_rows(const Chart *chart) {
  int rows = 0;
  for (size_t s = 0; s < chart->n_series; s++) rows += chart->series[s].label != NULL;
  return rows;
}

static Status print_legend(const Chart *chart, const Frame *frame, Text *svg, Error *error) {
  Status status = STATUS_OK;
  const double left = LEFT + PLOT_WIDTH + RIGHT;
  double y = frame->top + 10;
  for (size_t s = 0; s < chart->n_series; s++) {
    const ChartSeries *series = &chart->series[s];
    if (!series->label) continue;
    TRY(text_append(svg, error, "<g class=\"c%d\">\n", color_of(series, s)));
    if (has_line(series))
      TRY(text_append(svg, error, "<path class=\"line\"%s d=\"M%g %gh%d\"/>\n",
                      series->style == CHART_DASHES ? " stroke-dasharray=\"7 5\"" : "", left, y, SAMPLE));
    if (has_marks(series)) TRY(print_mark(mark_of(series, s), left + 0.5 * SAMPLE, y, svg, error));
    TRY(text_append(svg, error, "</g>\n"));
    TRY(svg_label(svg, left + SAMPLE + 8, y + 4.5, "start", series->label, error));
    y += TITLE;
  }
cleanup:
  return status;
}

/* --- the document --- */

static Status frame_of(const Chart *chart, Frame *frame, Error *error) {
  Status status;
  TRY(scale_of(chart, true, &frame->x, error));
  TRY(scale_of(chart, false, &frame->y, error));
  frame->top = ABOVE + (chart->title ? TITLE : 0);
  frame->x.pixel = LEFT;
  frame->x.pixels = PLOT_WIDTH;
  frame->y.pixel = frame->top + PLOT_HEIGHT;
  frame->y.pixels = -PLOT_HEIGHT;
cleanup:
  return status;
}

static Status open_document(const Chart *chart, const Frame *frame, Text *svg, Error *error) {
  Status status;
  const double legend = TITLE * legend_rows(chart), plot = PLOT_HEIGHT + BELOW;
  const double width = LEFT + PLOT_WIDTH + RIGHT + legend_width(chart);
  const double height = frame->top + fmax(plot, legend + ABOVE);
  TRY(text_append(svg, error,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" role=\"img\" "
                  "viewBox=\"0 0 %g %g\" width=\"%g\" height=\"%g\">\n",
                  width, height, width, height));
  TRY(text_append(svg, error, "%s", STYLE));
  TRY(text_append(svg, error, "<rect class=\"ground\" width=\"100%%\" height=\"100%%\"/>\n"));
  if (chart->title) TRY(svg_label(svg, LEFT + 0.5 * PLOT_WIDTH, 24, "middle", chart->title, error));
cleanup:
  return status;
}

Status chart_print(const Chart *chart, Text *svg, Error *error) {
  Status status;
  Frame frame;
  TRY(frame_of(chart, &frame, error));
  TRY(open_document(chart, &frame, svg, error));
  TRY(print_axes(chart, &frame, svg, error));
  for (size_t s = 0; s < chart->n_series; s++) TRY(print_series(&chart->series[s], s, &frame, svg, error));
  if (chart->n_points > 0) TRY(print_points(chart, &frame, svg, error));
  TRY(print_legend(chart, &frame, svg, error));
  TRY(text_append(svg, error, "</svg>\n"));
cleanup:
  return status;
}
