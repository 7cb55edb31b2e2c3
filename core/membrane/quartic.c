/* One element at a time: its lanes are the derivatives at the rule points. */
#include "membrane/quartic.h"

#include "base/vector_clones.h"
#include "mesh/quadrature.h"

#include <string.h>

void quartic_fill(QuarticBasis *basis) {
  const TriangleRule *rule = triangle_rule(RULE_POINTS);
  p4_places(basis->place);
  for (int child = 0; child < P4_CHILDREN; child++)
    for (int g = 0; g < RULE_POINTS; g++) {
      double dN[P4_NODES][2];
      p4_gradients(child, rule->point[g][0], rule->point[g][1], dN);
      for (int m = 0; m < P4_NODES; m++)
        for (int alpha = 0; alpha < 2; alpha++) basis->dN[child][m][2 * g + alpha] = dN[m][alpha];
    }
}

VECTOR_CLONES
void quartic_base_vectors(const QuarticBasis *basis, const Mesh *mesh, int element, const double *x, int lane,
                          ElementBlock *block) {
  enum { DERIVATIVES = 2 * RULE_POINTS };
  const int child = element % P4_CHILDREN, first = element - child;
  const double(*restrict dN)[DERIVATIVES] = basis->dN[child];
  double node[P4_NODES][3], a[3][DERIVATIVES];
  for (int m = 0; m < P4_NODES; m++) {
    const P4Place place = basis->place[m];
    memcpy(node[m], &x[3 * mesh->element[first + place.child][place.local]], sizeof node[m]);
  }
  for (int c = 0; c < 3; c++) {
#pragma omp simd
    for (int k = 0; k < DERIVATIVES; k++) {
      double sum = 0;
      for (int m = 0; m < P4_NODES; m++) sum += dN[m][k] * node[m][c];
      a[c][k] = sum;
    }
  }
  for (int g = 0; g < RULE_POINTS; g++)
    for (int c = 0; c < 3; c++) {
      block->a[g][0][c][lane] = a[c][2 * g];
      block->a[g][1][c][lane] = a[c][2 * g + 1];
    }
}

void quartic_force(const QuarticBasis *basis, int element, int lane, const ElementBlock *block,
                   double force[P4_NODES][3]) {
  for (int m = 0; m < P4_NODES; m++)
    for (int c = 0; c < 3; c++) {
      const double *dN = basis->dN[element % P4_CHILDREN][m];
      force[m][c] = 0;
      for (int k = 0; k < 2 * RULE_POINTS; k++) force[m][c] += dN[k] * block->t[k / 2][k % 2][c][lane];
    }
}
