#include "membrane/surface_average.h"

#include "base/array.h"
#include "membrane/point_cells.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* What a row is made from. */
typedef struct {
  const double *X; /* [n][3] */
  const Symmetry *symmetry;
  double length;
  const PointCells *cells;
} Neighbourhood;

/* Weight of the image of point j under operation s in the mean at point i; 0 when it is not near. */
static double weight_of_image(const Neighbourhood *near, int i, int j, int s) {
  const double *sign = near->symmetry->operation[s].sign;
  double r2 = 0;
  for (int c = 0; c < 3; c++) {
    const double distance = near->X[3 * i + c] - sign[c] * near->X[3 * j + c];
    r2 += distance * distance;
  }
  const double w = fmax(1 - r2 / (near->length * near->length), 0);
  return w * w;
}

/* Of point j and all its images. */
static double weight_of(const Neighbourhood *near, int i, int j) {
  double sum = 0;
  for (int s = 0; s < near->symmetry->n_operations; s++) sum += weight_of_image(near, i, j, s);
  return sum;
}

/* Whether s is the first operation whose image of point j is near point i. */
static bool is_first(const Neighbourhood *near, int i, int j, int s) {
  if (!(weight_of_image(near, i, j, s) > 0)) return false;
  while (s-- > 0)
    if (weight_of_image(near, i, j, s) > 0) return false;
  return true;
}

/* The points whose images are near point i, each once, into `found` unless that is NULL: their number.  A
 * point's image is as far from i as the point from the image of i, operations being their own inverses. */
static size_t find_neighbours(const Neighbourhood *near, int i, int *found) {
  size_t count = 0;
  PointRun run[POINT_RUNS];
  for (int s = 0; s < near->symmetry->n_operations; s++) {
    double image[3];
    for (int c = 0; c < 3; c++) image[c] = near->symmetry->operation[s].sign[c] * near->X[3 * i + c];
    const int n_runs = point_cells_near(near->cells, image, run);
    for (int r = 0; r < n_runs; r++)
      for (int k = run[r].begin; k < run[r].end; k++) {
        const int j = near->cells->point[k];
        if (!is_first(near, i, j, s)) continue;
        if (found) found[count] = j;
        count++;
      }
  }
  return count;
}

static int by_number(const void *a, const void *b) {
  const int i = *(const int *)a, j = *(const int *)b;
  return (i > j) - (i < j);
}

/* By rising numbers, so that sums do not depend on the cells. */
static void fill_row(SurfaceAverage *average, const Neighbourhood *near, int i, const double *dS0) {
  const size_t begin = average->start[i], end = average->start[i + 1];
  double sum = 0;
  find_neighbours(near, i, average->point + begin);
  qsort(average->point + begin, end - begin, sizeof *average->point, by_number);
  for (size_t k = begin; k < end; k++) {
    const int j = average->point[k];
    average->weight[k] = weight_of(near, i, j) * dS0[j];
    sum += average->weight[k];
  }
  for (size_t k = begin; k < end; k++) average->weight[k] /= sum;
}

Status surface_average_new(SurfaceAverage *average, int n, const double *X, const double *dS0,
                           const Symmetry *symmetry, double length, Error *error) {
  Status status = STATUS_OK;
  PointCells cells = {0};
  const Neighbourhood near = {.X = X, .symmetry = symmetry, .length = length, .cells = &cells};
  *average = (SurfaceAverage){.n = n};
  TRY(ARRAY_NEW(&average->start, n + 1, error));
  TRY(point_cells_new(&cells, n, X, length, error));
#pragma omp parallel for schedule(static)
  for (int i = 0; i < n; i++) average->start[i + 1] = find_neighbours(&near, i, NULL);
  for (int i = 0; i < n; i++) average->start[i + 1] += average->start[i];
  TRY(ARRAY_NEW(&average->point, average->start[n], error));
  TRY(ARRAY_NEW(&average->weight, average->start[n], error));
#pragma omp parallel for schedule(static)
  for (int i = 0; i < n; i++) fill_row(average, &near, i, dS0);
cleanup:
  point_cells_free(&cells);
  if (status != STATUS_OK) surface_average_free(average);
  return status;
}

void surface_average_free(SurfaceAverage *average) {
  array_free(average->start);
  array_free(average->point);
  array_free(average->weight);
  *average = (SurfaceAverage){0};
}

void surface_average_apply(const SurfaceAverage *average, const double *f, double *mean) {
  for (int i = 0; i < average->n; i++) {
    double sum = 0;
    for (size_t k = average->start[i]; k < average->start[i + 1]; k++)
      sum += average->weight[k] * f[average->point[k]];
    mean[i] = sum;
  }
}
