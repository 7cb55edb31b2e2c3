/* The P2 shape functions, written in the barycentric coordinates L0 = 1 - xi - eta, L1 = xi, L2 = eta. */
#include "mesh/p2.h"

#include <string.h>

const double p2_node[6][2] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}};

void p2_values(double xi, double eta, double N[6]) {
  double L0 = 1.0 - xi - eta;
  N[0] = L0 * (2.0 * L0 - 1.0);
  N[1] = xi * (2.0 * xi - 1.0);
  N[2] = eta * (2.0 * eta - 1.0);
  N[3] = 4.0 * L0 * xi;
  N[4] = 4.0 * xi * eta;
  N[5] = 4.0 * eta * L0;
}

void p2_gradients(double xi, double eta, double dN[6][2]) {
  double L0 = 1.0 - xi - eta;
  const double gradient[6][2] = {
      {1.0 - 4.0 * L0, 1.0 - 4.0 * L0}, {4.0 * xi - 1.0, 0.0}, {0.0, 4.0 * eta - 1.0},
      {4.0 * (L0 - xi), -4.0 * xi},     {4.0 * eta, 4.0 * xi}, {-4.0 * eta, 4.0 * (L0 - eta)},
  };
  memcpy(dN, gradient, sizeof gradient);
}

P2Table p2_table(const TriangleRule *rule) {
  P2Table table = {.n = rule->n};
  for (int g = 0; g < rule->n; g++) {
    table.weight[g] = rule->weight[g];
    p2_values(rule->point[g][0], rule->point[g][1], table.N[g]);
    p2_gradients(rule->point[g][0], rule->point[g][1], table.dN[g]);
  }
  return table;
}
