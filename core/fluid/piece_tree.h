/* The first bisections of every element, with the point forces of each piece: made once for an evaluation and
 * used by all targets near enough to need them. */
#ifndef CAPSELLA_FLUID_PIECE_TREE_H
#define CAPSELLA_FLUID_PIECE_TREE_H

#include "base/status.h"
#include "fluid/piece_kernel.h"
#include "mesh/mesh.h"

/* A target nearer to the centre than the reach is near the piece: the rule is not good enough for it. */
typedef struct {
  double center[3], reach2; /* reach squared */
} PieceBound;

/* Pieces of an element are numbered as in a heap: 0 is the element, the halves of i are 2 i + 1, 2 i + 2. */
typedef struct {
  const Mesh *mesh;
  double reach2_over_gyration2;
  int n_pieces, n_cut; /* of an element; pieces 0 .. n_cut - 1 have their halves in the tree */
  PieceRule rule;
  PieceBound *bound;  /* [n_elements][n_pieces] */
  OseenBlock *points; /* [n_elements][n_pieces][rule.n_blocks] */
} PieceTree;

/* `reach` in radii of gyration; 0: nothing is near and nothing is cut. */
Status piece_tree_new(PieceTree *tree, const Mesh *mesh, int rule_points, double reach, Error *error);
void piece_tree_free(PieceTree *tree);

/* Element e at positions x with load q, both [n_nodes][3]. */
void piece_tree_update(PieceTree *tree, int e, const double *x, const double *q);

PieceBound piece_tree_bound_of(const PieceTree *tree, const Piece *piece);

#endif
