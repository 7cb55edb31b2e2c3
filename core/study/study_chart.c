#include "study/study_chart.h"

#include "base/array.h"
#include "observe/chart.h"
#include <math.h>
#include <string.h>

enum { MOST_SERIES = 24 };

typedef struct {
  const Study *study;
  size_t axis, stride; /* that is drawn along; its step in the number of a point */
  size_t n;            /* values along it */
  double *y;           /* [MOST_SERIES][n] */
  Text label[MOST_SERIES];
  ChartSeries series[MOST_SERIES];
  size_t n_series;
} Drawing;

static bool find_axis(Drawing *drawing) {
  const Study *study = drawing->study;
  for (size_t a = 0, stride = study->n_points; a < study->n_axes; a++) {
    const Axis *axis = &study->axes[a];
    stride /= axis->n;
    if (!axis->is_numeric || axis->n <= drawing->n || axis->n < 2) continue;
    drawing->axis = a;
    drawing->stride = stride;
    drawing->n = axis->n;
  }
  return drawing->n > 0;
}

static const char *last_name(const char *key) {
  const char *dot = strrchr(key, '.');
  return dot ? dot + 1 : key;
}

/* "Y_C = 2", or "no damage" where the key is removed. */
static Status describe(const Axis *axis, size_t value, Text *label, Error *error) {
  const char *name = last_name(axis->key), *text = axis->values[value].value,
             *separator = label->length ? ", " : "";
  return *text ? text_append(label, error, "%s%s = %s", separator, name, text)
               : text_append(label, error, "%sno %s", separator, name);
}

Status study_chart_label(const Study *study, const char *name, size_t point, size_t skipped, Text *label,
                         Error *error) {
  Status status = text_append(label, error, "%s", name);
  size_t stride = study->n_points;
  for (size_t a = 0; a < study->n_axes && status == STATUS_OK; a++) {
    const Axis *axis = &study->axes[a];
    stride /= axis->n;
    if (a != skipped && axis->n > 1) status = describe(axis, point / stride % axis->n, label, error);
  }
  return status;
}

/* A line that another one covers is not drawn twice. */
static bool is_drawn(const Drawing *drawing, const double *y) {
  for (size_t i = 0; i < drawing->n_series; i++)
    if (memcmp(drawing->series[i].y, y, drawing->n * sizeof *y) == 0) return true;
  return false;
}

/* The line through the points that share all but the place along the axis with `first`. */
static Status add_series(Drawing *drawing, const Curve *curve, size_t first, Error *error) {
  const size_t k = drawing->n_series;
  double *y = drawing->y + k * drawing->n;
  bool any = false;
  for (size_t i = 0; i < drawing->n; i++) {
    y[i] = curve->values[first + i * drawing->stride];
    any = any || isfinite(y[i]);
  }
  if (!any || is_drawn(drawing, y)) return STATUS_OK;
  const Status status =
      study_chart_label(drawing->study, curve->name, first, drawing->axis, &drawing->label[k], error);
  drawing->series[drawing->n_series++] =
      (ChartSeries){.label = drawing->label[k].length ? drawing->label[k].data : NULL,
                    .x = drawing->study->axes[drawing->axis].numbers,
                    .y = y,
                    .n = drawing->n,
                    .style = CHART_LINE_AND_MARKS};
  return status;
}

static bool is_first(const Drawing *drawing, size_t point) {
  return point / drawing->stride % drawing->n == 0;
}

Status study_chart_write(const StudyRun *run, const char *file, const char *y_label, const Curve *curves,
                         size_t n, Error *error) {
  Status status = STATUS_OK;
  Text svg = {0};
  Drawing drawing = {.study = run->study};
  if (!find_axis(&drawing)) return STATUS_OK;
  TRY(ARRAY_NEW(&drawing.y, MOST_SERIES * drawing.n, error));
  for (size_t c = 0; c < n; c++)
    for (size_t point = 0; point < run->study->n_points && drawing.n_series < MOST_SERIES; point++)
      if (is_first(&drawing, point)) TRY(add_series(&drawing, &curves[c], point, error));
  if (drawing.n_series == 0) goto cleanup;
  const Chart chart = {.title = run->study->name,
                       .x = {.label = run->study->axes[drawing.axis].key},
                       .y = {.label = y_label},
                       .series = drawing.series,
                       .n_series = drawing.n_series};
  TRY(chart_print(&chart, &svg, error));
  TRY(study_write(run, file, &svg, error));
cleanup:
  for (size_t i = 0; i < MOST_SERIES; i++) text_free(&drawing.label[i]);
  array_free(drawing.y);
  text_free(&svg);
  return status;
}
