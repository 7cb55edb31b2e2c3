/* Pieces of the surface: P2 triangles that carry a load, cut in halves and turned into point forces. */
#ifndef CAPSELLA_FLUID_PIECE_KERNEL_H
#define CAPSELLA_FLUID_PIECE_KERNEL_H

#include "fluid/oseen_kernel.h"
#include "mesh/quadrature.h"

/* Position, load q and two zeros: the components of a node fill one vector. */
enum { PIECE_COMPONENTS = 8 };

typedef struct {
  double node[6][PIECE_COMPONENTS]; /* corners 0 1 2, then the middles of edges 01, 12, 20 */
} Piece;

/* A rule on the triangle with the P2 shape functions at its points, in blocks of lanes. */
typedef struct {
  int n, n_blocks;
  struct {
    double weight[OSEEN_LANES];
    double N[6][OSEEN_LANES];
    double dN[2][6][OSEEN_LANES]; /* d/dxi, d/deta */
  } block[(TRIANGLE_RULE_MAX + OSEEN_LANES - 1) / OSEEN_LANES];
} PieceRule;

/* Cuts the longest edge at its middle node; the base, which is opposite to corner 0, unless one of the sides
 * is longer than both other edges by more than round-off.  The halves are P2 pieces of the same surface,
 * exactly.  Corner 0 of both is the one opposite to the cut, so that from the mirror image of a piece, with
 * corners 1 and 2 exchanged, come the mirror images of its halves, the second one first. */
void piece_bisect(const Piece *piece, Piece *first, Piece *second);

/* Centroid of the corners, and the square of `reach` times the radius of gyration of the flat triangle of the
 * corners about it, which is the root of (sum of squared edges) / 36. */
double piece_reach2(const Piece *piece, double reach, double centroid[3]);

/* Point forces f = weight |a1 x a2| q at the points of the rule, so that sum J f approximates int J q dS:
 * rule->n_blocks blocks. */
void piece_points(const Piece *piece, const PieceRule *rule, OseenBlock *out);

#endif
