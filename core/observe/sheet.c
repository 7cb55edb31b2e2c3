#include "observe/sheet.h"

#include "base/array.h"
#include "base/vec3.h"
#include "observe/outline.h"
#include "observe/palette.h"
#include "observe/projection.h"
#include "observe/svg.h"
#include <math.h>

enum {
  PANEL = 200, /* pixels of the width of one map */
  LINE = 22,   /* height of a heading */
  AIR = 8,     /* below a map */
  BAR_WIDTH = 90,
  NARROWEST = 430, /* has room for the words above a row */
  CUTS = 2,        /* of an element's edge */
  BANDS = 16,
  GRAIN = 5, /* units of a pixel in which outlines are drawn */
};
static const double FILLING = 0.96; /* part of a panel's width that the largest capsule takes at most */

/* ---- The frame ---- */

static const SheetPanel *panel_of(const Sheet *sheet, size_t row, size_t column) {
  return &sheet->panels[row * sheet->n_columns + column];
}

static Status check_panel(const SheetPanel *panel, Error *error) {
  for (int k = 0; k < panel->mesh->n_nodes; k++)
    if (!isfinite(vec3_norm(panel->x + 3 * k)) || !isfinite(panel->field[k]))
      return error_set(error, STATUS_INPUT,
                       "maps: expected finite positions and fields, found others at node %d", k);
  return STATUS_OK;
}

static void center_of(const SheetPanel *panel, double center[3]) {
  for (int i = 0; i < 3; i++) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int k = 0; k < panel->mesh->n_nodes; k++) {
      low = fmin(low, panel->x[3 * k + i]);
      high = fmax(high, panel->x[3 * k + i]);
    }
    center[i] = 0.5 * (low + high);
  }
}

/* Pixels per length. */
static double scale_of(const Sheet *sheet) {
  double half_width = 0;
  for (size_t p = 0; p < sheet->n_rows * sheet->n_columns; p++) {
    const SheetPanel *panel = &sheet->panels[p];
    double center[3];
    center_of(panel, center);
    for (int k = 0; k < panel->mesh->n_nodes; k++)
      half_width = fmax(half_width, vec3_distance(panel->x + 3 * k, center));
  }
  return 0.5 * FILLING * PANEL / half_width;
}

/* Pixels that the tallest map of a row takes, and some air. */
static Status height_of(const Sheet *sheet, size_t row, double scale, double *height, Error *error) {
  double half = 0.3 * PANEL; /* the colour bar needs some */
  for (size_t c = 0; c < sheet->n_columns; c++) {
    const SheetPanel *panel = panel_of(sheet, row, c);
    Projection projection;
    double center[3], arm[3];
    const Status status = projection_make(&projection, panel->view.toward, panel->view.up, error);
    if (status != STATUS_OK) return status;
    center_of(panel, center);
    for (int k = 0; k < panel->mesh->n_nodes; k++) {
      vec3_subtract(panel->x + 3 * k, center, arm);
      half = fmax(half, scale * fabs(vec3_dot(arm, projection.up)));
    }
  }
  *height = ceil(2 * half) + AIR;
  return STATUS_OK;
}

/* The range given, else that of the fields of the row; widened where it is no more than round-off. */
static SheetRow with_range(const Sheet *sheet, size_t row) {
  SheetRow result = sheet->rows[row];
  if (!(result.maximum > result.minimum)) {
    result.minimum = HUGE_VAL;
    result.maximum = -HUGE_VAL;
    for (size_t c = 0; c < sheet->n_columns; c++) {
      const SheetPanel *panel = panel_of(sheet, row, c);
      for (int k = 0; k < panel->mesh->n_nodes; k++) {
        result.minimum = fmin(result.minimum, panel->field[k]);
        result.maximum = fmax(result.maximum, panel->field[k]);
      }
    }
  }
  const double size = fmax(fabs(result.minimum), fabs(result.maximum));
  if (result.maximum - result.minimum <= 1e-9 * size || size == 0) result.maximum += fmax(size, 1);
  return result;
}

/* ---- Maps ---- */

/* Band 0 is all that is seen, with a line around it; each further one covers what is above its level. */
static Status print_bands(const Piece *pieces, size_t count, const SheetRow *row, double scale, Text *svg,
                          Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  const double step = (row->maximum - row->minimum) / BANDS;
  for (int band = 0; band < BANDS; band++) {
    double rgb[3];
    path.length = 0;
    TRY(outline_print(pieces, count, band ? row->minimum + band * step : -INFINITY, GRAIN * scale, &path,
                      error));
    if (path.length == 0) break;
    palette_color((band + 0.5) / BANDS, rgb);
    TRY(text_append(svg, error, "<path fill=\"#%02lx%02lx%02lx\"%s d=\"%s\"/>\n", lround(rgb[0]),
                    lround(rgb[1]), lround(rgb[2]), band ? "" : " stroke=\"#000\" stroke-width=\"6\"",
                    path.data));
  }
cleanup:
  text_free(&path);
  return status;
}

static Status print_panel(const SheetPanel *panel, const SheetRow *row, double scale, Text *svg,
                          Error *error) {
  Status status;
  Projection projection;
  Piece *pieces = NULL;
  size_t count;
  double center[3];
  center_of(panel, center);
  TRY(projection_make(&projection, panel->view.toward, panel->view.up, error));
  TRY(projection_pieces(&projection, panel->mesh, panel->x, panel->field, center, CUTS, &pieces, &count,
                        error));
  TRY(print_bands(pieces, count, row, scale, svg, error));
cleanup:
  array_free(pieces);
  return status;
}

/* ---- Around them ---- */

static Status print_bar(const SheetRow *row, double height, Text *svg, Error *error) {
  enum { LEFT = 12, WIDTH = 14, TOP = 4 };
  Status status;
  const double length = height - AIR - 2 * TOP, range = row->maximum - row->minimum,
               step = svg_tick_step(range, 4);
  TRY(text_append(svg, error,
                  "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%g\" fill=\"url(#map)\" "
                  "stroke=\"#333\"/>\n",
                  LEFT, TOP, WIDTH, length));
  for (double k = ceil(row->minimum / step - 1e-9); k * step <= row->maximum + 1e-9 * range; k++) {
    const double y = TOP + length * (row->maximum - k * step) / range;
    TRY(text_append(svg, error, "<path stroke=\"#333\" d=\"M%d %.1fh5\"/>\n", LEFT + WIDTH, y));
    TRY(svg_number(svg, LEFT + WIDTH + 9, y + 4, "start", fabs(k) < 1e-6 ? 0 : k * step, error));
  }
cleanup:
  return status;
}

/* One row below `top`. */
static Status print_row(const Sheet *sheet, size_t r, double scale, double top, double height, Text *svg,
                        Error *error) {
  Status status;
  const SheetRow row = with_range(sheet, r);
  TRY(svg_label(svg, 8, top + LINE - 6, "start", row.label, error));
  for (size_t c = 0; c < sheet->n_columns; c++) {
    TRY(text_append(svg, error, "<g transform=\"translate(%zu %g) scale(%g)\">\n", c * PANEL + PANEL / 2,
                    top + LINE + 0.5 * (height - AIR), 1.0 / GRAIN));
    TRY(print_panel(panel_of(sheet, r, c), &row, scale, svg, error));
    TRY(text_append(svg, error, "</g>\n"));
  }
  TRY(text_append(svg, error, "<g transform=\"translate(%zu %g)\">\n", sheet->n_columns * PANEL, top + LINE));
  TRY(print_bar(&row, height, svg, error));
  TRY(text_append(svg, error, "</g>\n"));
cleanup:
  return status;
}

static Status print_rows(const Sheet *sheet, double *bottom, Text *svg, Error *error) {
  Status status = STATUS_OK;
  const double scale = scale_of(sheet);
  *bottom = LINE;
  for (size_t r = 0; r < sheet->n_rows; r++) {
    double height;
    TRY(height_of(sheet, r, scale, &height, error));
    TRY(print_row(sheet, r, scale, *bottom, height, svg, error));
    *bottom += LINE + height;
  }
cleanup:
  return status;
}

Status sheet_print(const Sheet *sheet, Text *svg, Error *error) {
  Status status = STATUS_OK;
  Text rows = {0};
  double height;
  const size_t needed = sheet->n_columns * PANEL + BAR_WIDTH, width = needed < NARROWEST ? NARROWEST : needed;
  for (size_t p = 0; p < sheet->n_rows * sheet->n_columns; p++) TRY(check_panel(&sheet->panels[p], error));
  TRY(print_rows(sheet, &height, &rows, error));
  TRY(text_append(
      svg, error,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %zu %g\" width=\"%zu\" height=\"%g\">\n"
      "<style>text{font:13px sans-serif;fill:#222;stroke:none}</style>\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
      width, height, width, height));
  TRY(palette_gradient("map", svg, error));
  for (size_t c = 0; c < sheet->n_columns; c++)
    TRY(svg_label(svg, ((double)c + 0.5) * PANEL, LINE - 6, "middle", sheet->columns[c], error));
  TRY(text_append(svg, error, "%s</svg>\n", rows.data ? rows.data : ""));
cleanup:
  text_free(&rows);
  return status;
}
