/* Moving least squares with linear functions of the axes, each scaled to 0 .. 1. */
#include "study/neighbours.h"

#include <math.h>
#include <string.h>

enum { MOST_AXES = 6, MOST_TERMS = MOST_AXES + 1 };

/* Axes beyond the first few do not help to expect anything, but take part in the levels. */
static size_t used_axes(const Study *study) {
  return study->n_axes < MOST_AXES ? study->n_axes : MOST_AXES;
}

static size_t place_along(const Study *study, size_t point, size_t axis) {
  for (size_t a = study->n_axes; a-- > axis + 1;) point /= study->axes[a].n;
  return point % study->axes[axis].n;
}

/* 0 for both ends, 1 for the middle between them, 2 for the middles of the halves, ... */
static int level_along(size_t place, size_t n) {
  size_t low = 0, high = n - 1;
  int level = 0;
  while (place != low && place != high) {
    const size_t middle = (low + high) / 2;
    if (place <= middle) high = middle;
    if (place >= middle) low = middle;
    level++;
  }
  return level;
}

int neighbours_level(const Study *study, size_t point) {
  int level = 0;
  for (size_t a = 0; a < study->n_axes; a++) {
    const int along =
        study->axes[a].is_numeric ? level_along(place_along(study, point, a), study->axes[a].n) : 0;
    if (along > level) level = along;
  }
  return level;
}

bool neighbours_lean(const Study *study, size_t point, size_t other) {
  for (size_t a = 0; a < study->n_axes; a++)
    if (!study->axes[a].is_numeric && place_along(study, point, a) != place_along(study, other, a))
      return false;
  return neighbours_level(study, other) < neighbours_level(study, point);
}

/* Distance along an axis in units of its length. */
static double distance_along(const Study *study, size_t axis, size_t point, size_t other) {
  const Axis *along = &study->axes[axis];
  double least = INFINITY, most = -INFINITY;
  if (!along->is_numeric) return 0;
  for (size_t i = 0; i < along->n; i++) {
    least = fmin(least, along->numbers[i]);
    most = fmax(most, along->numbers[i]);
  }
  const double distance =
      along->numbers[place_along(study, other, axis)] - along->numbers[place_along(study, point, axis)];
  return most > least ? distance / (most - least) : 0;
}

/* Solves the normal equations A c = b, symmetric and not negative, in place; terms without support stay 0. */
static void solve(size_t n, double A[MOST_TERMS][MOST_TERMS], double *b) {
  for (size_t k = 0; k < n; k++) {
    if (!(A[k][k] > 1e-12)) { /* nothing known along this axis */
      b[k] = 0;
      for (size_t i = 0; i < n; i++) A[i][k] = A[k][i] = 0;
      A[k][k] = 1;
      continue;
    }
    for (size_t i = 0; i < n; i++) {
      const double factor = i == k ? 0 : A[i][k] / A[k][k];
      for (size_t j = k; j < n && factor != 0; j++) A[i][j] -= factor * A[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (size_t k = 0; k < n; k++) b[k] /= A[k][k];
}

double neighbours_expect(const Study *study, size_t point, const double *values) {
  double A[MOST_TERMS][MOST_TERMS] = {{0}}, b[MOST_TERMS] = {0};
  const size_t n_terms = used_axes(study) + 1;
  double total = 0;
  for (size_t other = 0; other < study->n_points; other++) {
    if (!isfinite(values[other]) || !neighbours_lean(study, point, other)) continue;
    double term[MOST_TERMS] = {1}, squared = 0;
    for (size_t a = 0; a + 1 < n_terms; a++) {
      term[a + 1] = distance_along(study, a, point, other);
      squared += term[a + 1] * term[a + 1];
    }
    const double weight = 1 / (squared * squared + 1e-8);
    total += weight;
    for (size_t i = 0; i < n_terms; i++) {
      b[i] += weight * term[i] * values[other];
      for (size_t j = 0; j < n_terms; j++) A[i][j] += weight * term[i] * term[j];
    }
  }
  if (total == 0) return NAN;
  for (size_t i = 0; i < n_terms; i++) {
    b[i] /= total;
    for (size_t j = 0; j < n_terms; j++) A[i][j] /= total;
  }
  solve(n_terms, A, b);
  return b[0];
}
