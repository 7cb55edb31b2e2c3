/* Heaps of pieces, element after element. */
#include "fluid/piece_tree.h"

#include "base/array.h"
#include "fluid/piece.h"

/* On a capsule of moderate aspect few targets need more than three bisections; near.c goes on from there. */
enum { TREE_DEPTH = 3, MAX_PIECES = (2 << TREE_DEPTH) - 1 };

Status piece_tree_new(PieceTree *tree, const Mesh *mesh, int rule_points, double reach, Error *error) {
  Status status = STATUS_OK;
  int depth = reach > 0 ? TREE_DEPTH : 0;
  *tree = (PieceTree){.mesh = mesh, .reach2_over_gyration2 = reach * reach};
  tree->n_pieces = (2 << depth) - 1;
  tree->n_cut = tree->n_pieces / 2;
  piece_rule(&tree->rule, rule_points);
  size_t n = (size_t)mesh->n_elements * tree->n_pieces;
  TRY(ARRAY_NEW(&tree->bound, n, error));
  TRY(ARRAY_NEW(&tree->points, n * tree->rule.n_blocks, error));
cleanup:
  return status;
}

void piece_tree_free(PieceTree *tree) {
  array_free(tree->bound);
  array_free(tree->points);
}

PieceBound piece_tree_bound_of(const PieceTree *tree, const Piece *piece) {
  PieceBound bound;
  double gyration2;
  piece_extent(piece, bound.center, &gyration2);
  bound.reach2 = tree->reach2_over_gyration2 * gyration2;
  return bound;
}

void piece_tree_update(PieceTree *tree, int e, const double *x, const double *q) {
  Piece piece[MAX_PIECES];
  size_t first = (size_t)e * tree->n_pieces;
  piece_load(tree->mesh->element[e], x, q, &piece[0]);
  for (int i = 0; i < tree->n_pieces; i++) {
    if (i < tree->n_cut) piece_bisect(&piece[i], &piece[2 * i + 1], &piece[2 * i + 2]);
    tree->bound[first + i] = piece_tree_bound_of(tree, &piece[i]);
    piece_points(&piece[i], &tree->rule, &tree->points[(first + i) * tree->rule.n_blocks]);
  }
}
