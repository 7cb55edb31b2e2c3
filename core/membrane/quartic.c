/* One element at a time: its lanes are the derivatives at the rule points. */
#include "membrane/quartic.h"

#include "base/vector_clones.h"
#include "mesh/quadrature.h"

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
  const int child = element % P4_CHILDREN, first = element - child;
  double a[3][2 * RULE_POINTS] = {{0}};
  for (int m = 0; m < P4_NODES; m++) {
    const double *dN = basis->dN[child][m];
    const double *node = &x[3 * mesh->element[first + basis->place[m].child][basis->place[m].local]];
    for (int c = 0; c < 3; c++)
      for (int k = 0; k < 2 * RULE_POINTS; k++) a[c][k] += dN[k] * node[c];
  }
  for (int c = 0; c < 3; c++)
    for (int k = 0; k < 2 * RULE_POINTS; k++) block->a[k / 2][k % 2][c][lane] = a[c][k];
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
