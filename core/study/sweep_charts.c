#include "study/sweep_charts.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/chart.h"
#include "observe/columns.h"
#include "observe/history.h"
#include "study/entry.h"
#include "study/study_chart.h"
#include "study/table.h"
#include <math.h>

enum { MOST_NAMES = 8, MOST_LINES = 24 };

typedef struct {
  const char *names[MOST_NAMES];
  size_t n;
  const char *over; /* NULL: the longest varied range */
} Request;

/* ---- What is asked for ---- */

static Status read_names(const YamlNode *node, Request *request, Error *error) {
  Status status = STATUS_OK;
  const bool is_list = node->kind == YAML_TREE_LIST;
  request->n = is_list ? node->count : 1;
  if (request->n < 1 || request->n > MOST_NAMES)
    return place_error(&node->place, error, "expected one to %d names for `draw`, found %zu", MOST_NAMES,
                       request->n);
  for (size_t k = 0; k < request->n; k++)
    TRY(entry_text(is_list ? node->items[k] : node, "draw", &request->names[k], error));
cleanup:
  return status;
}

static Status read_request(const YamlNode *node, Request *request, Error *error) {
  static const char *const keys[] = {"draw", "over", NULL};
  Status status;
  const YamlNode *draw;
  *request = (Request){0};
  if (node->kind != YAML_TREE_MAPPING)
    return place_error(&node->place, error, "expected a mapping `{draw: , over: }` in `charts`, found %s",
                       yaml_tree_found(node).text);
  TRY(entry_check_keys(node, keys, NULL, error));
  TRY(entry_find(node, "draw", "what is drawn", &draw, error));
  TRY(read_names(draw, request, error));
  const YamlNode *over = yaml_tree_find(node, "over");
  if (over) TRY(entry_text(over, "over", &request->over, error));
cleanup:
  return status;
}

static Status check_names(const YamlNode *node, const Request *request, Error *error) {
  const char *unknown = request->over && !history_has_column(request->over) ? request->over : NULL;
  for (size_t k = 0; k < request->n && !unknown; k++)
    if (!(request->over ? history_has_column : table_has_figure)(request->names[k]))
      unknown = request->names[k];
  if (!unknown) return STATUS_OK;
  return place_error(&node->place, error, "expected %s, found `%.60s`",
                     request->over ? "columns of history.csv" : "columns of table.csv", unknown);
}

Status sweep_charts_check(const Study *study, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *charts = yaml_tree_find(study->root, "charts");
  if (!charts) return STATUS_OK;
  if (charts->kind != YAML_TREE_LIST)
    return place_error(&charts->place, error, "expected a list for `charts`, found %s",
                       yaml_tree_found(charts).text);
  for (size_t k = 0; k < charts->count; k++) {
    Request request;
    TRY(read_request(charts->items[k], &request, error));
    TRY(check_names(charts->items[k], &request, error));
  }
cleanup:
  return status;
}

/* ---- Figures at the end of the runs ---- */

/* "L1, L2". */
static Status join(const Request *request, const char *separator, Text *text, Error *error) {
  Status status = STATUS_OK;
  for (size_t k = 0; k < request->n; k++)
    TRY(text_append(text, error, "%s%s", k ? separator : "", request->names[k]));
cleanup:
  return status;
}

static Status draw_ends(const StudyRun *run, const int *cases, const Request *request, const char *file,
                        const char *y_label, Error *error) {
  Status status = STATUS_OK;
  Curve curves[MOST_NAMES];
  double *values = NULL;
  const size_t n = run->study->n_points;
  TRY(ARRAY_NEW(&values, request->n * n, error));
  for (size_t k = 0; k < request->n; k++) {
    curves[k] = (Curve){request->n > 1 ? request->names[k] : "", values + k * n};
    for (size_t i = 0; i < n; i++)
      values[k * n + i] = case_number(runner_case(run->runner, cases[i]), request->names[k]);
  }
  TRY(study_chart_write(run, file, y_label, curves, request->n, error));
cleanup:
  array_free(values);
  return status;
}

/* ---- Columns of the histories ---- */

typedef struct {
  const StudyRun *run;
  const Request *request;
  Columns columns[MOST_LINES]; /* of the runs that are drawn: the names, then what they are over */
  size_t n_runs;
  ChartSeries series[MOST_LINES];
  Text label[MOST_LINES];
  size_t n_series;
} Lines;

/* The columns of one run, or none when it has no such history. */
static Status read_history(Lines *lines, const char *folder, Columns *columns, Error *error) {
  Status status;
  Text path = {0};
  const char *names[MOST_NAMES + 1];
  const Request *request = lines->request;
  for (size_t k = 0; k < request->n; k++) names[k] = request->names[k];
  names[request->n] = request->over;
  TRY(file_join(&path, folder, "history.csv", error));
  status = columns_read(columns, path.data, names, request->n + 1, error);
  if (status == STATUS_IO || status == STATUS_INPUT) status = STATUS_OK;
cleanup:
  text_free(&path);
  return status;
}

static bool is_drawable(const Columns *columns, size_t y, size_t x) {
  for (size_t row = 0; row < columns->n_rows; row++)
    if (isfinite(columns->values[y][row]) && isfinite(columns->values[x][row])) return true;
  return false;
}

/* Every second run is dashed, for runs that differ little lie on each other. */
static Status add_run(Lines *lines, const Columns *columns, size_t point, Error *error) {
  Status status = STATUS_OK;
  const Request *request = lines->request;
  const Study *study = lines->run->study;
  for (size_t k = 0; k < request->n; k++) {
    Text *label = &lines->label[lines->n_series];
    if (!is_drawable(columns, k, request->n)) continue;
    TRY(study_chart_label(study, request->n > 1 ? request->names[k] : "", point, study->n_axes, label,
                          error));
    lines->series[lines->n_series++] = (ChartSeries){.label = label->length ? label->data : NULL,
                                                     .x = columns->values[request->n],
                                                     .y = columns->values[k],
                                                     .n = columns->n_rows,
                                                     .color = 1 + (int)(request->n > 1 ? k : lines->n_runs),
                                                     .style = lines->n_runs % 2 ? CHART_DASHES : CHART_LINE};
  }
  lines->n_runs++;
cleanup:
  return status;
}

static Status gather(Lines *lines, const int *cases, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < lines->run->study->n_points; i++) {
    if (lines->n_series + lines->request->n > MOST_LINES) break;
    Columns *columns = &lines->columns[lines->n_runs];
    TRY(read_history(lines, runner_case(lines->run->runner, cases[i])->folder, columns, error));
    if (columns->values) TRY(add_run(lines, columns, i, error));
  }
cleanup:
  return status;
}

static Status draw_lines(const StudyRun *run, const int *cases, const Request *request, const char *file,
                         const char *y_label, Error *error) {
  Status status;
  Text svg = {0};
  Lines *lines = NULL;
  TRY(ARRAY_NEW(&lines, 1, error));
  *lines = (Lines){.run = run, .request = request};
  TRY(gather(lines, cases, error));
  if (lines->n_series == 0) goto cleanup;
  const Chart chart = {.title = run->study->name,
                       .x = {.label = request->over},
                       .y = {.label = y_label},
                       .series = lines->series,
                       .n_series = lines->n_series};
  TRY(chart_print(&chart, &svg, error));
  TRY(study_write(run, file, &svg, error));
cleanup:
  for (size_t k = 0; lines && k < MOST_LINES; k++) {
    columns_free(&lines->columns[k]);
    text_free(&lines->label[k]);
  }
  array_free(lines);
  text_free(&svg);
  return status;
}

/* ---- All ---- */

static Status draw(const StudyRun *run, const int *cases, const Request *request, Error *error) {
  Status status;
  Text file = {0}, y_label = {0};
  TRY(join(request, "_", &file, error));
  if (request->over) TRY(text_append(&file, error, "_over_%s", request->over));
  TRY(text_append(&file, error, ".svg"));
  TRY(join(request, ", ", &y_label, error));
  status = (request->over ? draw_lines : draw_ends)(run, cases, request, file.data, y_label.data, error);
cleanup:
  text_free(&y_label);
  text_free(&file);
  return status;
}

Status sweep_charts_write(const StudyRun *run, const int *cases, Error *error) {
  static const Request usual[] = {{{"d_max"}, 1, NULL}, {{"D12"}, 1, NULL}};
  Status status = STATUS_OK;
  const YamlNode *charts = yaml_tree_find(run->study->root, "charts");
  for (size_t k = 0; !charts && k < sizeof usual / sizeof *usual; k++)
    TRY(draw(run, cases, &usual[k], error));
  for (size_t k = 0; charts && k < charts->count; k++) {
    Request request;
    TRY(read_request(charts->items[k], &request, error));
    TRY(draw(run, cases, &request, error));
  }
cleanup:
  return status;
}
