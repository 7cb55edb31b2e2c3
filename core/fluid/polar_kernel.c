/* Lanes are rays (apex_points), components (expansion_set) or points (expansion_points).
 *
 * With the position on the opposite edge measured as height * sinh(w), int dS / r over a flat triangle is
 * height * range: the integrand is constant in w, however long and thin the triangle (Khayat & Wilton 2005).
 * What is left for the Gauss points is the smooth rest. */
#include "fluid/polar_kernel.h"

#include "base/vector_clones.h"

#include <math.h>

/* exp(z) as the 16th power of a Taylor polynomial: to 1e-14 for 0 <= z <= 16, that is for triangles up to a
 * thousand times longer than high, and without a branch.  Even and odd terms apart: two short chains. */
static inline double exponential(double z) {
  const double y = z / 16, y2 = y * y;
  double even = 1, odd = 1;
  for (int k = 16; k > 0; k -= 2) {
    even = 1 + even * y2 / (k * (k - 1));
    odd = 1 + odd * y2 / (k * (k + 1));
  }
  double sum = even + y * odd;
  sum *= sum;
  sum *= sum;
  sum *= sum;
  return sum * sum;
}

VECTOR_CLONES
void apex_points(const ApexTriangle *triangle, const PolarGauss *gauss, OffsetPoints *points) {
  double s[POLAR_MAX_ANGULAR], t[POLAR_MAX_ANGULAR], weight[POLAR_MAX_ANGULAR];
  const int n = gauss->n_angular;
  const double a0 = triangle->a[0], a1 = triangle->a[1];
  const double d0 = triangle->b[0] - a0, d1 = triangle->b[1] - a1;
  const double scale = triangle->height_over_edge, foot = triangle->foot_over_edge;
  const double start = triangle->start, range = triangle->range, measure = triangle->area * range * scale;
  for (int i = 0; i < n; i++) {
    double grow = start * exponential(range * gauss->angle[i]), decay = 1 / grow; /* exp(w), exp(-w) */
    double fraction = 0.5 * (grow - decay) * scale - foot;                        /* of the way from a to b */
    s[i] = a0 + fraction * d0;
    t[i] = a1 + fraction * d1;
    weight[i] = gauss->angle_weight[i] * 0.5 * (grow + decay) * measure;
  }
  for (int j = 0; j < gauss->n_radial; j++) {
    const double rho = gauss->radius[j], rho_weight = rho * gauss->radius_weight[j];
    double *restrict out_s = points->s + points->n, *restrict out_t = points->t + points->n;
    double *restrict out_weight = points->weight + points->n;
    for (int i = 0; i < n; i++) {
      out_s[i] = rho * s[i];
      out_t[i] = rho * t[i];
      out_weight[i] = rho_weight * weight[i];
    }
    points->n += n;
  }
}

VECTOR_CLONES
void expansion_set(const double matrix[6][6], const Piece *restrict element, Expansion *restrict expansion) {
  for (int m = 0; m < 6; m++) {
#pragma omp simd
    for (int c = 0; c < PIECE_COMPONENTS; c++) {
      expansion->coefficient[m][c] = matrix[m][0] * element->node[0][c] + matrix[m][1] * element->node[1][c] +
                                     matrix[m][2] * element->node[2][c] + matrix[m][3] * element->node[3][c] +
                                     matrix[m][4] * element->node[4][c] + matrix[m][5] * element->node[5][c];
    }
  }
}

static inline double value(const double e[6][PIECE_COMPONENTS], int c, double s, double t) {
  return e[0][c] + s * (e[1][c] + s * e[3][c] + t * e[4][c]) + t * (e[2][c] + t * e[5][c]);
}

static inline double slope_s(const double e[6][PIECE_COMPONENTS], int c, double s, double t) {
  return e[1][c] + 2 * s * e[3][c] + t * e[4][c];
}

static inline double slope_t(const double e[6][PIECE_COMPONENTS], int c, double s, double t) {
  return e[2][c] + s * e[4][c] + 2 * t * e[5][c];
}

VECTOR_CLONES
void expansion_points(const Expansion *restrict expansion, OffsetView points, OseenBlock *restrict out) {
  const double(*e)[PIECE_COMPONENTS] = expansion->coefficient;
  for (int first = 0; first < points.n; first += OSEEN_LANES, out++) {
#pragma omp simd
    for (int i = 0; i < OSEEN_LANES; i++) {
      double s = points.s[first + i], t = points.t[first + i];
      double a0 = slope_s(e, 0, s, t), a1 = slope_s(e, 1, s, t), a2 = slope_s(e, 2, s, t);
      double b0 = slope_t(e, 0, s, t), b1 = slope_t(e, 1, s, t), b2 = slope_t(e, 2, s, t);
      double n0 = a1 * b2 - a2 * b1, n1 = a2 * b0 - a0 * b2, n2 = a0 * b1 - a1 * b0;
      double area = points.weight[first + i] * sqrt(n0 * n0 + n1 * n1 + n2 * n2);
      out->y[0][i] = value(e, 0, s, t);
      out->y[1][i] = value(e, 1, s, t);
      out->y[2][i] = value(e, 2, s, t);
      out->f[0][i] = area * value(e, 3, s, t);
      out->f[1][i] = area * value(e, 4, s, t);
      out->f[2][i] = area * value(e, 5, s, t);
    }
  }
}
