#include "membrane/point_cells.h"

#include "base/array.h"
#include <math.h>

/* Cells are no smaller than the reach, and not many more than points. */
static void lay_out(PointCells *cells, int n, const double *X, double reach) {
  double high[3], longest = 0;
  for (int c = 0; c < 3; c++) {
    cells->low[c] = high[c] = X[c];
    for (int i = 1; i < n; i++) {
      cells->low[c] = fmin(cells->low[c], X[3 * i + c]);
      high[c] = fmax(high[c], X[3 * i + c]);
    }
    longest = fmax(longest, high[c] - cells->low[c]);
  }
  cells->size = fmax(reach, longest / cbrt(n));
  for (int c = 0; c < 3; c++) cells->count[c] = 1 + (int)((high[c] - cells->low[c]) / cells->size);
}

/* Of the cell along an axis, from -1 (all before the first) to the number of cells (behind the last). */
static int place_along(const PointCells *cells, int c, double x) {
  return (int)fmin(fmax(floor((x - cells->low[c]) / cells->size), -1), cells->count[c]);
}

static int row_of(const PointCells *cells, int a, int b) {
  return (a * cells->count[1] + b) * cells->count[2];
}

static int cell_of(const PointCells *cells, const double X[3]) {
  int at[3];
  for (int c = 0; c < 3; c++) at[c] = place_along(cells, c, X[c]);
  return row_of(cells, at[0], at[1]) + at[2];
}

Status point_cells_new(PointCells *cells, int n, const double *X, double reach, Error *error) {
  Status status = STATUS_OK;
  *cells = (PointCells){0};
  lay_out(cells, n, X, reach);
  const int n_cells = cells->count[0] * cells->count[1] * cells->count[2];
  TRY(ARRAY_NEW(&cells->start, n_cells + 2, error));
  TRY(ARRAY_NEW(&cells->point, n, error));
  int *next = cells->start + 1; /* of each cell, while points are put in */
  for (int i = 0; i < n; i++) next[cell_of(cells, X + 3 * i) + 1]++;
  for (int k = 0; k < n_cells; k++) next[k + 1] += next[k];
  for (int i = 0; i < n; i++) cells->point[next[cell_of(cells, X + 3 * i)]++] = i;
cleanup:
  if (status != STATUS_OK) point_cells_free(cells);
  return status;
}

void point_cells_free(PointCells *cells) {
  array_free(cells->start);
  array_free(cells->point);
  *cells = (PointCells){0};
}

int point_cells_near(const PointCells *cells, const double place[3], PointRun run[POINT_RUNS]) {
  int n = 0, low[3], high[3];
  for (int c = 0; c < 3; c++) {
    const int at = place_along(cells, c, place[c]);
    low[c] = at > 0 ? at - 1 : 0;
    high[c] = at + 1 < cells->count[c] ? at + 1 : cells->count[c] - 1;
    if (low[c] > high[c]) return 0;
  }
  for (int a = low[0]; a <= high[0]; a++)
    for (int b = low[1]; b <= high[1]; b++) {
      const int row = row_of(cells, a, b);
      run[n++] = (PointRun){cells->start[row + low[2]], cells->start[row + high[2] + 1]};
    }
  return n;
}
