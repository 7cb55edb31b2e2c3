#include "membrane/surface_average.h"

#include "base/array.h"
#include <math.h>

/* Weight of point j and all its images in the mean at point i; 0 when none is near. */
static double weight_of(const double *X, int i, int j, const Symmetry *symmetry, double length) {
  double sum = 0;
  for (int s = 0; s < symmetry->n_operations; s++) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
      const double distance = X[3 * i + c] - symmetry->operation[s].sign[c] * X[3 * j + c];
      r2 += distance * distance;
    }
    const double w = fmax(1 - r2 / (length * length), 0);
    sum += w * w;
  }
  return sum;
}

static size_t count_neighbours(const double *X, int n, int i, const Symmetry *symmetry, double length) {
  size_t count = 0;
  for (int j = 0; j < n; j++) count += weight_of(X, i, j, symmetry, length) > 0;
  return count;
}

static void fill_row(SurfaceAverage *average, int i, const double *X, const double *dS0,
                     const Symmetry *symmetry, double length) {
  size_t k = average->start[i];
  double sum = 0;
  for (int j = 0; j < average->n; j++) {
    const double w = weight_of(X, i, j, symmetry, length) * dS0[j];
    if (!(w > 0)) continue;
    average->point[k] = j;
    average->weight[k++] = w;
    sum += w;
  }
  for (k = average->start[i]; k < average->start[i + 1]; k++) average->weight[k] /= sum;
}

Status surface_average_new(SurfaceAverage *average, int n, const double *X, const double *dS0,
                           const Symmetry *symmetry, double length, Error *error) {
  Status status = STATUS_OK;
  *average = (SurfaceAverage){.n = n};
  TRY(ARRAY_NEW(&average->start, n + 1, error));
#pragma omp parallel for schedule(static)
  for (int i = 0; i < n; i++) average->start[i + 1] = count_neighbours(X, n, i, symmetry, length);
  for (int i = 0; i < n; i++) average->start[i + 1] += average->start[i];
  TRY(ARRAY_NEW(&average->point, average->start[n], error));
  TRY(ARRAY_NEW(&average->weight, average->start[n], error));
#pragma omp parallel for schedule(static)
  for (int i = 0; i < n; i++) fill_row(average, i, X, dS0, symmetry, length);
cleanup:
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
