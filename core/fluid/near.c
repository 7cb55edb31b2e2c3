/* Bisection of the longest edge; a half of a P2 piece is again a P2 piece, whose nodes are exact. */
#include "fluid/near.h"

#include "base/vec3.h"

#include <string.h>

/* Halvings of a piece: 1/2^16 of its length after twice as many, where the far rule is good enough for a
 * target that lies on the piece but for its very place. */
enum { MAX_DEPTH = 32 };

typedef struct {
  double node[6][6];
  int depth;
} Piece;

/* Squared distance of the origin from the segment a + s (b - a). */
static double segment_distance2(const double a[3], const double b[3]) {
  double edge[3], point[3];
  vec3_subtract(b, a, edge);
  double s = -vec3_dot(a, edge) / vec3_dot(edge, edge);
  s = s < 0 ? 0 : s > 1 ? 1 : s;
  for (int i = 0; i < 3; i++) point[i] = a[i] + s * edge[i];
  return vec3_dot(point, point);
}

/* Squared distance of the origin from the flat triangle a b c. */
static double triangle_distance2(const double a[3], const double b[3], const double c[3]) {
  double ab[3], ac[3], normal[3], side[3];
  vec3_subtract(b, a, ab);
  vec3_subtract(c, a, ac);
  vec3_cross(ab, ac, normal);
  /* (x cross y) . normal has the sign of the sub-triangle's area as seen from the origin's foot. */
  vec3_cross(a, b, side);
  double outside_ab = vec3_dot(side, normal);
  vec3_cross(b, c, side);
  double outside_bc = vec3_dot(side, normal);
  vec3_cross(c, a, side);
  double outside_ca = vec3_dot(side, normal);
  if (outside_ab >= 0 && outside_bc >= 0 && outside_ca >= 0) {
    double height = vec3_dot(a, normal);
    return height * height / vec3_dot(normal, normal);
  }
  double distance2 = segment_distance2(a, b);
  return fmin(distance2, fmin(segment_distance2(b, c), segment_distance2(c, a)));
}

static double edge_length2(const double a[3], const double b[3]) {
  double edge[3];
  vec3_subtract(b, a, edge);
  return vec3_dot(edge, edge);
}

/* The longest edge (0: corners 0 1, 1: 1 2, 2: 2 0) and its squared length. */
static int longest_edge(const double a[3], const double b[3], const double c[3], double *length2) {
  const double l[3] = {edge_length2(a, b), edge_length2(b, c), edge_length2(c, a)};
  int edge = l[1] > l[0] ? 1 : 0;
  if (l[2] > l[edge]) edge = 2;
  *length2 = l[edge];
  return edge;
}

bool near_is_near(const double a[3], const double b[3], const double c[3], double factor) {
  double length2;
  longest_edge(a, b, c, &length2);
  return triangle_distance2(a, b, c) < factor * factor * length2;
}

/* Cuts at the middle of an edge.  Children: (start, middle, opposite) and (middle, end, opposite). */
static void bisect(const Piece *parent, int edge, Piece *first, Piece *second) {
  int start = edge, end = (edge + 1) % 3, opposite = (edge + 2) % 3;
  const double *a = parent->node[start], *b = parent->node[end], *c = parent->node[opposite];
  const double *m = parent->node[3 + start], *bc = parent->node[3 + end], *ca = parent->node[3 + opposite];
  for (int i = 0; i < 6; i++) {
    double cut = (bc[i] + ca[i]) / 2 + m[i] / 4 - (a[i] + b[i]) / 8; /* middle of the cut from m to c */
    first->node[0][i] = a[i];
    first->node[1][i] = second->node[0][i] = m[i];
    second->node[1][i] = b[i];
    first->node[2][i] = second->node[2][i] = c[i];
    first->node[3][i] = 0.375 * a[i] + 0.75 * m[i] - 0.125 * b[i];
    second->node[3][i] = 0.375 * b[i] + 0.75 * m[i] - 0.125 * a[i];
    first->node[4][i] = second->node[5][i] = cut;
    first->node[5][i] = ca[i];
    second->node[4][i] = bc[i];
  }
  first->depth = second->depth = parent->depth + 1;
}

/* Leaves waiting for a full batch. */
typedef struct {
  PieceBatch batch;
  int n, total;
} Leaves;

static void flush_leaves(Leaves *leaves, const PieceRule *rule, PointPack *pack) {
  int points = leaves->n * rule->n;
  pack_reserve(pack, points);
  piece_points(&leaves->batch, leaves->n, rule, &pack->points, pack->n);
  pack->n += points;
  leaves->total += points;
  leaves->n = 0;
}

static void add_leaf(Leaves *leaves, const Piece *piece, const PieceRule *rule, PointPack *pack) {
  for (int k = 0; k < 6; k++) {
    for (int c = 0; c < 6; c++) leaves->batch.node[k][c][leaves->n] = piece->node[k][c];
  }
  if (++leaves->n == PIECE_LANES) flush_leaves(leaves, rule, pack);
}

int near_pack(const NearRule *near, const double node[6][6], PointPack *pack) {
  Piece stack[MAX_DEPTH + 2];
  Leaves leaves = {0};
  memcpy(stack[0].node, node, sizeof stack[0].node);
  stack[0].depth = 0;
  for (int top = 0; top >= 0;) {
    Piece piece = stack[top--];
    const double *a = piece.node[0], *b = piece.node[1], *c = piece.node[2];
    double length2;
    int edge = longest_edge(a, b, c, &length2);
    bool cut = piece.depth < MAX_DEPTH && triangle_distance2(a, b, c) < near->factor * near->factor * length2;
    if (cut) {
      bisect(&piece, edge, &stack[top + 2], &stack[top + 1]);
      top += 2;
    } else {
      add_leaf(&leaves, &piece, &near->rule, pack);
    }
  }
  flush_leaves(&leaves, &near->rule, pack);
  return leaves.total;
}
