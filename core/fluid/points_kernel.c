/* Shapes of the loops: lanes are pieces (piece_points) or points (expansion_points), the sums over nodes and
 * coefficients are written out, so that each loop vectorises as a whole. */
#include "fluid/points_kernel.h"

#include "fluid/clones.h"

#include <math.h>

static inline double interpolate(const double N[6], const double node[6][6][PIECE_LANES], int component,
                                 int lane) {
  return N[0] * node[0][component][lane] + N[1] * node[1][component][lane] + N[2] * node[2][component][lane] +
         N[3] * node[3][component][lane] + N[4] * node[4][component][lane] + N[5] * node[5][component][lane];
}

static inline double area_element(const double a[3], const double b[3]) {
  double n0 = a[1] * b[2] - a[2] * b[1], n1 = a[2] * b[0] - a[0] * b[2], n2 = a[0] * b[1] - a[1] * b[0];
  return sqrt(n0 * n0 + n1 * n1 + n2 * n2);
}

TARGET_CLONES
void piece_points(const PieceBatch *batch, int n, const PieceRule *rule, const OseenSources *out, int first) {
  for (int g = 0; g < rule->n; g++) {
    double value[6][PIECE_LANES];
    for (int lane = 0; lane < PIECE_LANES; lane++) {
      double a[3], b[3];
      for (int c = 0; c < 3; c++) {
        a[c] = interpolate(rule->dN[0][g], batch->node, c, lane);
        b[c] = interpolate(rule->dN[1][g], batch->node, c, lane);
      }
      double weight = rule->weight[g] * area_element(a, b);
      for (int c = 0; c < 3; c++) {
        value[c][lane] = interpolate(rule->N[g], batch->node, c, lane);
        value[c + 3][lane] = weight * interpolate(rule->N[g], batch->node, c + 3, lane);
      }
    }
    for (int c = 0; c < 3; c++) {
      double *y = out->y[c] + first + g, *f = out->f[c] + first + g;
      for (int lane = 0; lane < n; lane++) {
        y[lane * rule->n] = value[c][lane];
        f[lane * rule->n] = value[c + 3][lane];
      }
    }
  }
}

TARGET_CLONES
void expansion_points(const PieceExpansion *expansion, int n, const double *s, const double *t,
                      const double *weight, const OseenSources *out, int first) {
  const double(*e)[6] = expansion->coefficient;
  double *restrict y0 = out->y[0] + first, *restrict y1 = out->y[1] + first, *restrict y2 = out->y[2] + first;
  double *restrict f0 = out->f[0] + first, *restrict f1 = out->f[1] + first, *restrict f2 = out->f[2] + first;
  for (int i = 0; i < n; i++) {
    double value[6], a[3], b[3];
    for (int c = 0; c < 6; c++) {
      value[c] =
          e[0][c] + s[i] * (e[1][c] + s[i] * e[3][c] + t[i] * e[4][c]) + t[i] * (e[2][c] + t[i] * e[5][c]);
    }
    for (int c = 0; c < 3; c++) {
      a[c] = e[1][c] + 2 * s[i] * e[3][c] + t[i] * e[4][c];
      b[c] = e[2][c] + s[i] * e[4][c] + 2 * t[i] * e[5][c];
    }
    double area = weight[i] * area_element(a, b);
    y0[i] = value[0];
    y1[i] = value[1];
    y2[i] = value[2];
    f0[i] = area * value[3];
    f1[i] = area * value[4];
    f2[i] = area * value[5];
  }
}
