/* Lanes are components (piece_bisect) or points of the rule (piece_points); the sums over the six nodes are
 * written out so that each loop over lanes vectorises as a whole. */
#include "fluid/piece_kernel.h"

#include "base/vector_clones.h"

#include <math.h>

static inline double squared_edge(const Piece *piece, int i, int j) {
  const double *a = piece->node[i], *b = piece->node[j];
  double d0 = b[0] - a[0], d1 = b[1] - a[1], d2 = b[2] - a[2];
  return d0 * d0 + d1 * d1 + d2 * d2;
}

/* Squared lengths that differ by less count as equal: far more than round-off, and less than any shape. */
static const double LONGER = 1 + 1e-6;
/* Sides alike that are so much longer than the base (16 times, squared) are no tie: halves of the base would
 * be no shorter. */
static const double NEEDLE = 256;

/* Children: (opposite, start, middle) and (opposite, middle, end) of the edge that is cut. */
VECTOR_CLONES
void piece_bisect(const Piece *restrict piece, Piece *restrict first, Piece *restrict second) {
  double l01 = squared_edge(piece, 0, 1), l12 = squared_edge(piece, 1, 2), l20 = squared_edge(piece, 2, 0);
  int start = l01 > LONGER * fmax(l12, l20) || l01 > NEEDLE * l12 ? 0 : 1;
  if (l20 > LONGER * fmax(l01, l12)) start = 2;
  int end = (start + 1) % 3, opposite = (start + 2) % 3;
  const double *a = piece->node[start], *b = piece->node[end], *c = piece->node[opposite];
  const double *m = piece->node[3 + start], *bc = piece->node[3 + end], *ca = piece->node[3 + opposite];
#pragma omp simd
  for (int i = 0; i < PIECE_COMPONENTS; i++) {
    double cut = 0.5 * (bc[i] + ca[i]) + 0.25 * m[i] - 0.125 * (a[i] + b[i]); /* halfway from m to c */
    first->node[0][i] = c[i];
    first->node[1][i] = a[i];
    first->node[2][i] = m[i];
    first->node[3][i] = ca[i];
    first->node[4][i] = 0.375 * a[i] + 0.75 * m[i] - 0.125 * b[i];
    first->node[5][i] = cut;
    second->node[0][i] = c[i];
    second->node[1][i] = m[i];
    second->node[2][i] = b[i];
    second->node[3][i] = cut;
    second->node[4][i] = 0.375 * b[i] + 0.75 * m[i] - 0.125 * a[i];
    second->node[5][i] = bc[i];
  }
}

double piece_reach2(const Piece *piece, double reach, double centroid[3]) {
  for (int c = 0; c < 3; c++) {
    centroid[c] = (piece->node[0][c] + piece->node[1][c] + piece->node[2][c]) / 3;
  }
  double edges2 = squared_edge(piece, 0, 1) + squared_edge(piece, 1, 2) + squared_edge(piece, 2, 0);
  return reach * reach * edges2 / 36;
}

static inline double interpolate(const double N[6][OSEEN_LANES], int lane, const Piece *piece, int c) {
  return N[0][lane] * piece->node[0][c] + N[1][lane] * piece->node[1][c] + N[2][lane] * piece->node[2][c] +
         N[3][lane] * piece->node[3][c] + N[4][lane] * piece->node[4][c] + N[5][lane] * piece->node[5][c];
}

VECTOR_CLONES
void piece_points(const Piece *restrict piece, const PieceRule *restrict rule, OseenBlock *restrict out) {
  for (int block = 0; block < rule->n_blocks; block++) {
    const double(*N)[OSEEN_LANES] = rule->block[block].N;
    const double(*d1)[OSEEN_LANES] = rule->block[block].dN[0], (*d2)[OSEEN_LANES] = rule->block[block].dN[1];
    OseenBlock *points = &out[block];
#pragma omp simd
    for (int i = 0; i < OSEEN_LANES; i++) {
      double a0 = interpolate(d1, i, piece, 0), a1 = interpolate(d1, i, piece, 1);
      double a2 = interpolate(d1, i, piece, 2);
      double b0 = interpolate(d2, i, piece, 0), b1 = interpolate(d2, i, piece, 1);
      double b2 = interpolate(d2, i, piece, 2);
      double n0 = a1 * b2 - a2 * b1, n1 = a2 * b0 - a0 * b2, n2 = a0 * b1 - a1 * b0;
      double area = rule->block[block].weight[i] * sqrt(n0 * n0 + n1 * n1 + n2 * n2);
      points->y[0][i] = interpolate(N, i, piece, 0);
      points->y[1][i] = interpolate(N, i, piece, 1);
      points->y[2][i] = interpolate(N, i, piece, 2);
      points->f[0][i] = area * interpolate(N, i, piece, 3);
      points->f[1][i] = area * interpolate(N, i, piece, 4);
      points->f[2][i] = area * interpolate(N, i, piece, 5);
    }
  }
}
