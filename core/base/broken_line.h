/* A function of time that is linear between points and constant before the first and behind the last. */
#ifndef CAPSELLA_BASE_BROKEN_LINE_H
#define CAPSELLA_BASE_BROKEN_LINE_H

#include <math.h>
#include <stddef.h>

typedef struct {
  const double (*point)[2]; /* [n] (t, value), t rising; somebody else's */
  size_t n;                 /* at least 1 */
} BrokenLine;

/* Index of the point where the piece that holds t begins, of at least two points; a corner belongs to the
 * piece behind it. */
static inline size_t broken_line_piece(BrokenLine line, double t) {
  size_t k = 0;
  while (k + 2 < line.n && line.point[k + 1][0] <= t) k++;
  return k;
}

static inline double broken_line_value(BrokenLine line, double t) {
  if (line.n == 1) return line.point[0][1];
  const double(*p)[2] = line.point + broken_line_piece(line, t);
  const double u = (t - p[0][0]) / (p[1][0] - p[0][0]);
  return p[0][1] + fmin(fmax(u, 0), 1) * (p[1][1] - p[0][1]);
}

/* Slope of the piece that holds t, of at least two points. */
static inline double broken_line_slope(BrokenLine line, double t) {
  const double(*p)[2] = line.point + broken_line_piece(line, t);
  return (p[1][1] - p[0][1]) / (p[1][0] - p[0][0]);
}

/* The first corner behind t; INFINITY when there is none. */
static inline double broken_line_corner(BrokenLine line, double t) {
  for (size_t k = 0; k < line.n; k++)
    if (line.point[k][0] > t) return line.point[k][0];
  return INFINITY;
}

#endif
