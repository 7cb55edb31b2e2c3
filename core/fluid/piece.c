/* Tables and copies. */
#include "fluid/piece.h"

#include "mesh/p2.h"

void piece_load(const int element[6], const double *x, const double *q, Piece *piece) {
  for (int k = 0; k < 6; k++) {
    const double *position = x + 3 * element[k], *load = q + 3 * element[k];
    double *node = piece->node[k];
    for (int c = 0; c < 3; c++) {
      node[c] = position[c];
      node[c + 3] = load[c];
    }
    node[6] = node[7] = 0;
  }
}

void piece_rule(PieceRule *rule, int n) {
  const TriangleRule *points = triangle_rule(n);
  rule->n = n;
  rule->n_blocks = (n + OSEEN_LANES - 1) / OSEEN_LANES;
  for (int i = 0; i < rule->n_blocks * OSEEN_LANES; i++) {
    int block = i / OSEEN_LANES, lane = i % OSEEN_LANES;
    const double *point = points->point[i < n ? i : 0];
    double N[6], dN[6][2];
    p2_values(point[0], point[1], N);
    p2_gradients(point[0], point[1], dN);
    rule->block[block].weight[lane] = i < n ? points->weight[i] : 0;
    for (int k = 0; k < 6; k++) {
      rule->block[block].N[k][lane] = N[k];
      for (int c = 0; c < 2; c++) rule->block[block].dN[c][k][lane] = dN[k][c];
    }
  }
}
