#include "benchmark/work_page.h"

#include "observe/chart.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
  double limit;
  const char *label;
} AIMS[] = {{1e-2, "1 %"}, {1e-3, "0.1 %"}, {1e-4, "0.01 %"}};
enum { N_AIMS = sizeof AIMS / sizeof *AIMS };

static int elements_of(const WorkKnobs *knobs) {
  return 20 << 2 * knobs->subdivisions;
}

/* --- tables --- */

static Status print_row(const WorkPoint *point, Text *markdown, Error *error) {
  const WorkKnobs *knobs = &point->knobs;
  return text_append(markdown, error, " %d | %s | %s | %s %s | %.3f | %.3f | %lld | %.1e | %.1e | %.1e |",
                     elements_of(knobs), knobs->interpolation, knobs->method, knobs->integrator,
                     knobs->tolerance, point->run.cpu_seconds, point->run.seconds, point->run.evaluations,
                     point->error.shape, point->error.D12, point->error.d_max);
}

Status work_print_choices(const WorkPrecision *work, Text *markdown, Error *error) {
  Status status;
  TRY(text_append(
      markdown, error,
      "| shape within | elements | interpolation | method | integrator | CPU s | seconds | evaluations | "
      "error of "
      "shape | of D12 | of d_max | mostly |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n"));
  for (int k = 0; k < N_AIMS; k++) {
    const WorkPoint *best = work_cheapest(work->point, work->n, offsetof(WorkError, shape), AIMS[k].limit);
    TRY(text_append(markdown, error, "| %s |", AIMS[k].label));
    if (best) {
      TRY(print_row(best, markdown, error));
      TRY(text_append(markdown, error, " %s |\n", work_dominating(best)));
    } else {
      TRY(text_append(markdown, error, " not reached | | | | | | | | | | |\n"));
    }
  }
cleanup:
  return status;
}

Status work_print_grid(const WorkPrecision *work, Text *markdown, Error *error) {
  Status status;
  TRY(text_append(markdown, error,
                  "| elements | interpolation | method | integrator | CPU s | seconds | evaluations | error "
                  "of shape | of D12 "
                  "| of d_max | by space | by quadrature | by time | mostly | "
                  "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n"));
  for (int k = 0; k < work->n; k++) {
    const WorkPoint *point = &work->point[k];
    TRY(text_append(markdown, error, "|"));
    TRY(print_row(point, markdown, error));
    TRY(text_append(markdown, error, " %.1e | %.1e | %.1e | %s | %s |\n", point->space, point->quadrature,
                    point->time, work_dominating(point), point->is_on_front ? "front" : ""));
  }
  TRY(text_append(markdown, error, "|"));
  TRY(print_row(&work->reference, markdown, error));
  TRY(text_append(markdown, error, " | | | | the reference |\n"));
cleanup:
  return status;
}

/* The most accurate run on a mesh: the last of method `fast`. */
static const WorkPoint *best_on_mesh(const WorkPrecision *work, int subdivisions) {
  if (work->reference.knobs.subdivisions == subdivisions) return &work->reference;
  const WorkPoint *best = NULL;
  for (int k = 0; k < work->n; k++)
    if (work->point[k].knobs.subdivisions == subdivisions &&
        strcmp(work->point[k].knobs.interpolation, "quadratic") == 0 &&
        strcmp(work->point[k].knobs.method, "fast") == 0)
      best = &work->point[k];
  return best;
}

Status work_print_meshes(const WorkPrecision *work, Text *markdown, Error *error) {
  Status status;
  const RunCost *any = &work->reference.run;
  TRY(text_append(markdown, error, "| elements |"));
  for (size_t i = 0; i < any->n_times; i++)
    TRY(text_append(markdown, error, " D12 and d_max at t = %g |", any->times[i]));
  TRY(text_append(markdown, error, "\n|---|"));
  for (size_t i = 0; i < any->n_times; i++) TRY(text_append(markdown, error, "---|"));
  TRY(text_append(markdown, error, "\n"));
  for (int level = 1; level <= work->reference.knobs.subdivisions; level++) {
    const WorkPoint *best = best_on_mesh(work, level);
    TRY(text_append(markdown, error, "| %d |", elements_of(&best->knobs)));
    for (size_t i = 0; i < any->n_times; i++)
      TRY(text_append(markdown, error, " %.6f, %.5f |", best->run.state[i].D12, best->run.state[i].d_max));
    TRY(text_append(markdown, error, "\n"));
  }
cleanup:
  return status;
}

/* --- the picture --- */

enum { MAX_SERIES = 24, MAX_VALUES = 4 * WORK_POINTS };

/* Series under construction; values stand one after the other in x and y. */
typedef struct {
  ChartSeries series[MAX_SERIES];
  char label[MAX_SERIES][64];
  size_t n_series, n_values;
  double x[MAX_VALUES], y[MAX_VALUES];
} Plot;

static void open_series(Plot *plot, const char *label, ChartStyle style, int color, int mark) {
  ChartSeries *series = &plot->series[plot->n_series];
  snprintf(plot->label[plot->n_series], sizeof plot->label[0], "%s", label);
  *series = (ChartSeries){.label = plot->label[plot->n_series],
                          .x = plot->x + plot->n_values,
                          .y = plot->y + plot->n_values,
                          .style = style,
                          .color = color,
                          .mark = mark};
  plot->n_series++;
}

static void add_value(Plot *plot, double x, double y) {
  plot->x[plot->n_values] = x;
  plot->y[plot->n_values++] = y;
  plot->series[plot->n_series - 1].n++;
}

static void add_point(Plot *plot, const WorkPoint *point) {
  add_value(plot, point->run.cpu_seconds, work_counted(point, point->error.shape));
}

/* A series that got no value is taken back. */
static void close_series(Plot *plot) {
  if (plot->series[plot->n_series - 1].n == 0) plot->n_series--;
}

static bool is_of(const WorkKnobs *knobs, int level, const WorkScheme *scheme) {
  return knobs->subdivisions == level && strcmp(knobs->method, scheme->method) == 0 &&
         strcmp(knobs->interpolation, scheme->interpolation) == 0 && strcmp(knobs->integrator, "rkc3") == 0;
}

static void plot_tolerances(const WorkPrecision *work, Plot *plot) {
  static const int marks[WORK_SCHEMES] = {1, 2, 3, 5};
  for (int level = 1; level < work->reference.knobs.subdivisions; level++)
    for (int m = 0; m < WORK_SCHEMES; m++) {
      const WorkScheme *scheme = &work_schemes[m];
      const bool is_quartic = strcmp(scheme->interpolation, "quartic") == 0;
      char label[64];
      snprintf(label, sizeof label, "%s, %d elements", is_quartic ? "quartic" : scheme->method,
               20 << 2 * level);
      open_series(plot, label, CHART_LINE_AND_MARKS, level, marks[m]);
      for (int k = 0; k < work->n; k++)
        if (is_of(&work->point[k].knobs, level, scheme)) add_point(plot, &work->point[k]);
      close_series(plot);
    }
}

static void plot_rk2(const WorkPrecision *work, Plot *plot) {
  open_series(plot, "rk2 at its limit", CHART_MARKS, 7, 6);
  for (int k = 0; k < work->n; k++)
    if (strcmp(work->point[k].knobs.integrator, "rk2") == 0) add_point(plot, &work->point[k]);
  close_series(plot);
}

static int compare_points(const void *a, const void *b) {
  const double x = (*(const WorkPoint *const *)a)->run.cpu_seconds,
               y = (*(const WorkPoint *const *)b)->run.cpu_seconds;
  return (x > y) - (x < y);
}

static void plot_front(const WorkPrecision *work, Plot *plot) {
  const WorkPoint *front[WORK_POINTS];
  size_t n = 0;
  for (int k = 0; k < work->n; k++)
    if (work->point[k].is_on_front) front[n++] = &work->point[k];
  qsort(front, n, sizeof *front, compare_points);
  open_series(plot, "Pareto front", CHART_DASHES, 7, 0);
  for (size_t k = 0; k < n; k++) add_point(plot, front[k]);
  close_series(plot);
}

Status work_print_picture(const WorkPrecision *work, const char *title, const RunCost *other, Text *svg,
                          Error *error) {
  Plot plot = {0};
  ChartPoint aims[N_AIMS];
  size_t n_aims = 0;
  plot_tolerances(work, &plot);
  plot_rk2(work, &plot);
  if (other) {
    const RunState *reference = &work->reference.run.state[work->reference.run.n_times - 1];
    open_series(&plot, other->label, CHART_MARKS, 5, 4);
    add_value(&plot, other->cpu_seconds, work_error(&other->state[other->n_times - 1], reference).shape);
  }
  plot_front(work, &plot);
  for (int k = 0; k < N_AIMS; k++) {
    const WorkPoint *best = work_cheapest(work->point, work->n, offsetof(WorkError, shape), AIMS[k].limit);
    if (best)
      aims[n_aims++] =
          (ChartPoint){best->run.cpu_seconds, work_counted(best, best->error.shape), AIMS[k].label};
  }
  const Chart chart = {.title = title,
                       .x = {.label = "CPU seconds", .logarithmic = true},
                       .y = {.label = "error of the shape", .logarithmic = true},
                       .series = plot.series,
                       .n_series = plot.n_series,
                       .points = aims,
                       .n_points = n_aims};
  return chart_print(&chart, svg, error);
}
