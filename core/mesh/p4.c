/* With barycentric coordinates L0 + L1 + L2 = 1, the shape function of the node at L = (k, i, j)/4 is
 * f_k(L0) f_i(L1) f_j(L2), where f_n(L) vanishes at 0, 1/4 .. (n - 1)/4 and is 1 at n/4. */
#include "mesh/p4.h"

#include "mesh/p2.h"

enum { ORDER = 4 };

/* Corners of the children in halves of the parent's (xi, eta), in the order of the halving (mesh.c). */
static const int CHILD[P4_CHILDREN][3][2] = {
    {{0, 0}, {1, 0}, {0, 1}}, {{1, 0}, {2, 0}, {1, 1}}, {{0, 1}, {1, 1}, {0, 2}}, {{1, 0}, {1, 1}, {0, 1}}};

/* Coordinate c of a child's point in its parent. */
static double in_parent(int child, double xi, double eta, int c) {
  const int(*corner)[2] = CHILD[child];
  return 0.5 * ((1 - xi - eta) * corner[0][c] + xi * corner[1][c] + eta * corner[2][c]);
}

/* Index of the node at xi = i/4, eta = j/4: rows of eta, of 5, 4, 3, 2 and 1 nodes. */
static int node_at(int i, int j) {
  return j * (ORDER + 1) - j * (j - 1) / 2 + i;
}

void p4_places(P4Place place[P4_NODES]) {
  for (int child = P4_CHILDREN - 1; child >= 0; child--)
    for (int local = 0; local < 6; local++) {
      const double *point = p2_node[local];
      const double i = ORDER * in_parent(child, point[0], point[1], 0),
                   j = ORDER * in_parent(child, point[0], point[1], 1);
      place[node_at((int)i, (int)j)] =
          (P4Place){.child = (unsigned char)child, .local = (unsigned char)local}; /* i, j are whole */
    }
}

/* f_n(L) and its derivative. */
static void factor(int n, double L, double *value, double *slope) {
  *value = 1;
  *slope = 0;
  for (int m = 0; m < n; m++) {
    *slope = (*slope * (ORDER * L - m) + *value * ORDER) / (m + 1);
    *value *= (ORDER * L - m) / (m + 1);
  }
}

void p4_gradients(int child, double xi, double eta, double dN[P4_NODES][2]) {
  const int(*corner)[2] = CHILD[child];
  const double L[3] = {1 - in_parent(child, xi, eta, 0) - in_parent(child, xi, eta, 1),
                       in_parent(child, xi, eta, 0), in_parent(child, xi, eta, 1)};
  for (int j = 0; j <= ORDER; j++)
    for (int i = 0; i + j <= ORDER; i++) {
      double f[3], df[3];
      factor(ORDER - i - j, L[0], &f[0], &df[0]);
      factor(i, L[1], &f[1], &df[1]);
      factor(j, L[2], &f[2], &df[2]);
      const double along0 = df[0] * f[1] * f[2];
      const double along_xi = f[0] * df[1] * f[2] - along0, along_eta = f[0] * f[1] * df[2] - along0;
      for (int alpha = 0; alpha < 2; alpha++) /* the child's edges 01 and 02 in its parent */
        dN[node_at(i, j)][alpha] = 0.5 * (along_xi * (corner[1 + alpha][0] - corner[0][0]) +
                                          along_eta * (corner[1 + alpha][1] - corner[0][1]));
    }
}
