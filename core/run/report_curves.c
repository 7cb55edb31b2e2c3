/* One chart for each group of columns, two in a row.  A chart is a document of its own, which may stand in
 * another. */
#include "run/report_curves.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/chart.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- history.csv ---- */

typedef struct {
  Text text;
  const char *header;
  size_t n_rows, n_columns;
  double *values; /* [n_columns][n_rows] */
} Columns;

static size_t count_of(const char *text, char letter, char end) {
  size_t count = 0;
  for (; *text && *text != end; text++) count += *text == letter;
  return count;
}

static Status columns_load(Columns *history, const char *folder, Error *error) {
  enum { MOST = 1 << 28 };
  Status status = STATUS_OK;
  Text path = {0};
  TRY(file_join(&path, folder, "history.csv", error));
  TRY(file_read(path.data, MOST, &history->text, error));
  const char *at = history->header = history->text.data;
  history->n_columns = count_of(at, ',', '\n') + 1;
  const size_t lines = count_of(at, '\n', '\0');
  history->n_rows = lines > 0 ? lines - 1 : 0;
  if (history->n_rows == 0)
    TRY(error_set(error, STATUS_IO, "%s: expected rows of figures, found none", path.data));
  TRY(ARRAY_NEW(&history->values, history->n_rows * history->n_columns, error));
  for (size_t row = 0; row < history->n_rows; row++) {
    at = strchr(at, '\n') + 1;
    const char *cell = at;
    for (size_t column = 0; column < history->n_columns; column++) {
      char *end;
      history->values[column * history->n_rows + row] = strtod(cell, &end);
      cell = end + (*end == ',');
    }
  }
cleanup:
  text_free(&path);
  return status;
}

/* The values of a column, or NULL. */
static double *column_of(const Columns *history, const char *name) {
  const size_t length = strlen(name);
  const char *at = history->header;
  for (size_t column = 0; column < history->n_columns; column++, at += strcspn(at, ",\n") + 1)
    if (strcspn(at, ",\n") == length && strncmp(at, name, length) == 0)
      return history->values + column * history->n_rows;
  return NULL;
}

/* ---- charts ---- */

enum { LINES_MAX = 3 };

/* `columns` and their labels, over time. */
typedef struct {
  const char *title, *column[LINES_MAX], *label[LINES_MAX];
} Panel;

static const Panel panels_of_flow[] = {
    {"Taylor deformation D12", {"D12"}, {NULL}},
    {"inclination, degrees", {"beta"}, {NULL}},
    {"axes of the ellipsoid of inertia / a", {"L1", "L2", "L3"}, {"L1", "L2", "L3"}},
    {"area strain", {"area_strain"}, {NULL}},
    {"largest damage", {"d_max"}, {NULL}},
    {"energies / (G_s a^2)", {"elastic_energy", "dissipated_energy"}, {"elastic", "dissipated"}},
};
static const Panel panels_of_inflation[] = {
    {"pressure difference p a / G_s", {"p"}, {NULL}},
    {"imposed inflation", {"alpha"}, {NULL}},
    {"largest tension T1 / G_s", {"T1_max"}, {NULL}},
    {"area strain", {"area_strain"}, {NULL}},
    {"largest damage", {"d_max"}, {NULL}},
    {"energies / (G_s a^2)", {"elastic_energy", "dissipated_energy"}, {"elastic", "dissipated"}},
};
enum { PANELS = 6, IN_A_ROW = 2, PANEL_WIDTH = 780, PANEL_HEIGHT = 440 };

static Status print_panel(const Columns *history, const Panel *panel, Text *svg, Error *error) {
  Status status;
  ChartSeries series[LINES_MAX];
  size_t n = 0;
  const double *t = column_of(history, "t");
  for (; n < LINES_MAX && panel->column[n]; n++) {
    const double *y = column_of(history, panel->column[n]);
    if (!t || !y)
      TRY(error_set(error, STATUS_IO, "expected a column %s, found none", t ? panel->column[n] : "t"));
    series[n] = (ChartSeries){.label = panel->label[n],
                              .x = t,
                              .y = y,
                              .n = history->n_rows,
                              .style = n == 1 ? CHART_DASHES : CHART_LINE};
  }
  const Chart chart = {.title = panel->title,
                       .x = {.label = "t", .minimum = t[0], .maximum = t[history->n_rows - 1]},
                       .series = series,
                       .n_series = n};
  TRY(chart_print(&chart, svg, error));
cleanup:
  return status;
}

static Status print_panels(const Columns *history, const Panel *panels, Text *svg, Error *error) {
  Status status;
  const int width = IN_A_ROW * PANEL_WIDTH, height = PANELS / IN_A_ROW * PANEL_HEIGHT;
  TRY(text_append(svg, error,
                  "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" "
                  "height=\"%d\">\n<g class=\"chart\"><rect class=\"ground\" width=\"100%%\" "
                  "height=\"100%%\"/></g>\n",
                  width, height, width, height));
  for (int k = 0; k < PANELS; k++) {
    TRY(text_append(svg, error, "<g transform=\"translate(%d %d)\">\n", k % IN_A_ROW * PANEL_WIDTH,
                    k / IN_A_ROW * PANEL_HEIGHT));
    TRY(print_panel(history, &panels[k], svg, error));
    TRY(text_append(svg, error, "</g>\n"));
  }
  TRY(text_append(svg, error, "</svg>\n"));
cleanup:
  return status;
}

static void to_degrees(const Columns *history) {
  double *beta = column_of(history, "beta");
  for (size_t k = 0; beta && k < history->n_rows; k++) beta[k] *= 45 / atan(1);
}

Status report_curves(const char *folder, Text *svg, Error *error) {
  Status status;
  Columns history = {0};
  TRY(columns_load(&history, folder, error));
  to_degrees(&history);
  status =
      print_panels(&history, column_of(&history, "p") ? panels_of_inflation : panels_of_flow, svg, error);
  if (status != STATUS_OK) error_prefix(error, "%s/history.csv: ", folder);
cleanup:
  array_free(history.values);
  text_free(&history.text);
  return status;
}
