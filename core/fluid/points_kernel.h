/* From curved triangles that carry a load to point forces, many at a time.
 *
 * A "piece" is a P2 triangle with six nodes; component 0..2 of a node is its position, 3..5 the load q there.
 * A point force is f = weight * |a1 x a2| * q, so that sum J f approximates int J q dS. */
#ifndef CAPSELLA_FLUID_POINTS_KERNEL_H
#define CAPSELLA_FLUID_POINTS_KERNEL_H

#include "fluid/oseen_kernel.h"
#include "mesh/quadrature.h"

enum { PIECE_LANES = 8 };

/* Pieces side by side: node[k][component][lane]. */
typedef struct {
  double node[6][6][PIECE_LANES];
} PieceBatch;

/* A rule on the triangle with the P2 shape functions at its points. */
typedef struct {
  int n;
  double weight[TRIANGLE_RULE_MAX];
  double N[TRIANGLE_RULE_MAX][6];
  double dN[2][TRIANGLE_RULE_MAX][6]; /* d/dxi, d/deta */
} PieceRule;

/* Point forces of the first n pieces of the batch: piece i fills rule->n places of `out` from
 * first + i * rule->n on. */
void piece_points(const PieceBatch *batch, int n, const PieceRule *rule, const OseenSources *out, int first);

/* A piece as a polynomial about one of its points, in the parametric offset (s, t) from there:
 * value = c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2 for each of the six components. */
typedef struct {
  double coefficient[6][6]; /* [c0 .. c5][component] */
} PieceExpansion;

/* Point forces at the offsets (s[i], t[i]) with the given weights, to places first .. first + n - 1 of `out`.
 */
void expansion_points(const PieceExpansion *expansion, int n, const double *s, const double *t,
                      const double *weight, const OseenSources *out, int first);

#endif
