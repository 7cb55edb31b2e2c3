#include "study/level_curve.h"

#include "base/array.h"
#include <math.h>
#include <string.h>

static Status grow(LevelCurve *curve, Error *error) {
  Status status = STATUS_OK;
  double *x = NULL, *y = NULL;
  const size_t capacity = curve->capacity ? 2 * curve->capacity : 16;
  TRY(ARRAY_NEW(&x, capacity, error));
  TRY(ARRAY_NEW(&y, capacity, error));
  if (curve->n) {
    memcpy(x, curve->x, curve->n * sizeof *x);
    memcpy(y, curve->y, curve->n * sizeof *y);
  }
  array_free(curve->x);
  array_free(curve->y);
  curve->x = x;
  curve->y = y;
  curve->capacity = capacity;
  return STATUS_OK;
cleanup:
  array_free(x);
  return status;
}

Status level_curve_add(LevelCurve *curve, double x, double y, Error *error) {
  size_t i = 0;
  while (i < curve->n && curve->x[i] < x) i++;
  const bool is_new = i == curve->n || curve->x[i] != x;
  if (is_new && curve->n == curve->capacity) {
    const Status status = grow(curve, error);
    if (status != STATUS_OK) return status;
  }
  if (is_new) {
    memmove(curve->x + i + 1, curve->x + i, (curve->n - i) * sizeof *curve->x);
    memmove(curve->y + i + 1, curve->y + i, (curve->n - i) * sizeof *curve->y);
    curve->n++;
  }
  curve->x[i] = x;
  curve->y[i] = y;
  return STATUS_OK;
}

void level_curve_free(LevelCurve *curve) {
  array_free(curve->x);
  array_free(curve->y);
  *curve = (LevelCurve){0};
}

/* ln x as a function of ln y by Newton's divided differences: the line through samples a and b, and what the
 * parabola through c adds to it, at ln(level). */
static double line(const LevelCurve *curve, size_t a, size_t b, double level) {
  const double xa = log(curve->x[a]), xb = log(curve->x[b]), ya = log(curve->y[a]), yb = log(curve->y[b]);
  return xa + (xb - xa) * (log(level) - ya) / (yb - ya);
}

static double bend(const LevelCurve *curve, size_t a, size_t b, size_t c, double level) {
  const double xa = log(curve->x[a]), xb = log(curve->x[b]), xc = log(curve->x[c]);
  const double ya = log(curve->y[a]), yb = log(curve->y[b]), yc = log(curve->y[c]), y = log(level);
  const double slope_ab = (xb - xa) / (yb - ya), slope_bc = (xc - xb) / (yc - yb);
  return (slope_bc - slope_ab) / (yc - ya) * (y - ya) * (y - yb);
}

/* The sample next to the interval whose quantity is nearer to the level; n when there is none that rises. */
static size_t third_sample(const LevelCurve *curve, size_t a, double level) {
  const size_t n = curve->n;
  const bool has_left = a > 0 && curve->y[a - 1] < curve->y[a];
  const bool has_right = a + 2 < n && curve->y[a + 2] > curve->y[a + 1];
  if (!has_left && !has_right) return n;
  if (!has_left) return a + 2;
  if (!has_right) return a - 1;
  return level / curve->y[a - 1] < curve->y[a + 2] / level ? a - 1 : a + 2;
}

LevelCrossing level_curve_cross(const LevelCurve *curve, double level) {
  LevelCrossing crossing = {NAN, NAN, NAN, NAN};
  size_t b = 0;
  while (b < curve->n && curve->y[b] < level) b++;
  if (b < curve->n) crossing.high = curve->x[b];
  if (b > 0) crossing.low = curve->x[b - 1];
  if (b == 0 || b == curve->n) return crossing;
  const size_t a = b - 1, c = third_sample(curve, a, level);
  const double straight = exp(line(curve, a, b, level));
  if (c == curve->n) {
    crossing.x = straight;
    crossing.error = 0.5 * (crossing.high - crossing.low);
    return crossing;
  }
  const double bent = exp(line(curve, a, b, level) + bend(curve, a, b, c, level));
  crossing.x = fmin(fmax(bent, crossing.low), crossing.high);
  crossing.error = fabs(crossing.x - straight);
  return crossing;
}
