/* Expansion of each element about the node, then the polar rule that fits the metric there. */
#include "fluid/singular.h"

#include "base/array.h"
#include "base/vec3.h"
#include "mesh/p2.h"

#include <math.h>

enum { ANGULAR_STEPS = 3, MORE_ANGLES = 4 };

struct SingularRule {
  bool in_tangent_plane;
  PolarGauss gauss[ANGULAR_STEPS]; /* with n_angular, n_angular + MORE_ANGLES, ... */
  double expand[6][6][6]; /* [local node][coefficient][node]: expansion about a local node from the six */
};

/* |a1 x a2| / (|a1|^2 + |a2|^2) of an element squashed to a line is 0; of an equilateral one, 0.43. */
static const double DEGENERATE = 1e-10;

/* d2/dxi2, d2/dxi deta, d2/deta2 of the shape functions: constants. */
static const double SECOND[3][6] = {{4, 4, 0, -8, 0, 0}, {4, 0, 0, -4, 4, -4}, {4, 0, 4, 0, 0, -8}};

Status singular_new(SingularRule **out, const PolarScheme *scheme, Error *error) {
  Status status = STATUS_OK;
  SingularRule *rule = NULL;
  TRY(ARRAY_NEW(&rule, 1, error));
  rule->in_tangent_plane = scheme->in_tangent_plane;
  for (int i = 0; i < ANGULAR_STEPS; i++) {
    polar_gauss(scheme->n_radial, scheme->n_angular + i * MORE_ANGLES, &rule->gauss[i]);
  }
  for (int local = 0; local < 6; local++) {
    double dN[6][2];
    p2_gradients(p2_node[local][0], p2_node[local][1], dN);
    double(*expand)[6] = rule->expand[local];
    expand[0][local] = 1;
    for (int k = 0; k < 6; k++) {
      expand[1][k] = dN[k][0];
      expand[2][k] = dN[k][1];
      expand[3][k] = SECOND[0][k] / 2;
      expand[4][k] = SECOND[1][k];
      expand[5][k] = SECOND[2][k] / 2;
    }
  }
  *out = rule;
cleanup:
  return status;
}

void singular_free(SingularRule *rule) {
  array_free(rule);
}

/* The element about local node `local`, with positions as seen from there. */
static void expand_element(const SingularRule *rule, const int element[6], int local, const double *x,
                           const double *q, PieceExpansion *expansion) {
  const double *origin = x + 3 * element[local];
  double node[6][6];
  for (int k = 0; k < 6; k++) {
    vec3_subtract(x + 3 * element[k], origin, node[k]);
    for (int c = 0; c < 3; c++) node[k][c + 3] = q[3 * element[k] + c];
  }
  for (int m = 0; m < 6; m++) {
    for (int c = 0; c < 6; c++) {
      double sum = 0;
      for (int k = 0; k < 6; k++) sum += rule->expand[local][m][k] * node[k][c];
      expansion->coefficient[m][c] = sum;
    }
  }
}

/* Ratio of the largest to the smallest stretch of the metric g, against the equilateral triangle. */
static double metric_aspect(const double g[3]) {
  /* In the frame of the equilateral triangle: e1 = a1, e2 = (2 a2 - a1) / sqrt(3). */
  double g11 = g[0], g12 = (2 * g[1] - g[0]) / sqrt(3), g22 = (4 * g[2] - 4 * g[1] + g[0]) / 3;
  double mean = (g11 + g22) / 2, half = hypot((g11 - g22) / 2, g12);
  return sqrt((mean + half) / (mean - half));
}

static const PolarGauss *choose_gauss(const SingularRule *rule, const double g[3]) {
  if (!rule->in_tangent_plane) return &rule->gauss[0];
  double aspect = metric_aspect(g);
  return &rule->gauss[aspect < 2 ? 0 : aspect < 4 ? 1 : 2];
}

static int pack_element(const SingularRule *rule, const int element[6], int local, const double *x,
                        const double *q, PointPack *pack) {
  PieceExpansion expansion;
  expand_element(rule, element, local, x, q, &expansion);
  const double *a1 = expansion.coefficient[1], *a2 = expansion.coefficient[2];
  double g[3] = {vec3_dot(a1, a1), vec3_dot(a1, a2), vec3_dot(a2, a2)}, area[3];
  vec3_cross(a1, a2, area);
  if (!(vec3_norm(area) > DEGENERATE * (g[0] + g[2]))) return -1;

  const double parametric[3] = {1, 0, 1};
  PolarPoint polar[POLAR_MAX_POINTS];
  int n = polar_points(choose_gauss(rule, g), local, rule->in_tangent_plane ? g : parametric, polar);
  double s[POLAR_MAX_POINTS], t[POLAR_MAX_POINTS], weight[POLAR_MAX_POINTS];
  for (int i = 0; i < n; i++) {
    s[i] = polar[i].dxi;
    t[i] = polar[i].deta;
    weight[i] = polar[i].weight;
  }
  pack_reserve(pack, n);
  expansion_points(&expansion, n, s, t, weight, &pack->points, pack->n);
  pack->n += n;
  return n;
}

int singular_pack(const SingularRule *rule, const Mesh *mesh, const double *x, const double *q, int p,
                  PointPack *pack) {
  int total = 0;
  for (int i = mesh->node_start[p]; i < mesh->node_start[p + 1]; i++) {
    int n = pack_element(rule, mesh->element[mesh->node_element[i]], mesh->node_local[i], x, q, pack);
    if (n < 0) return -1;
    total += n;
  }
  return total;
}
