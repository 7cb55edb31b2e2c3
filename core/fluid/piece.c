/* Tables and copies. */
#include "fluid/piece.h"

#include "mesh/p2.h"

#include <math.h>
#include <stdbool.h>

/* By the sizes of the coordinates. */
static int compare_sizes(const double *a, const double *b) {
  for (int c = 0; c < 3; c++) {
    if (fabs(a[c]) != fabs(b[c])) return fabs(a[c]) < fabs(b[c]) ? -1 : 1;
  }
  return 0;
}

void piece_turn(const int element[6], const double *X, int turned[6]) {
  int first = -1;
  for (int k = 0; k < 3; k++) {
    const double *corner = X + 3 * element[k];
    bool has_twin = false; /* its mirror image is a corner, too */
    for (int other = 1; other < 3; other++) {
      has_twin = has_twin || compare_sizes(corner, X + 3 * element[(k + other) % 3]) == 0;
    }
    if (has_twin) continue;
    if (first < 0 || compare_sizes(corner, X + 3 * element[first]) < 0) first = k;
  }
  for (int k = 0; k < 6; k++) turned[k] = element[k / 3 * 3 + (k + (first < 0 ? 0 : first)) % 3];
}

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
