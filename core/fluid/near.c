/* Down the tree of pieces, and below its last level by cutting on the spot. */
#include "fluid/near.h"

#include "fluid/piece.h"

#include <stddef.h>

/* Bisections of an element: pieces 1/2^16 of its length, smaller than any distance that a mesh resolves. */
enum { MAX_DEPTH = 32 };

static bool is_near(const PieceBound *bound, const double target[3]) {
  double r0 = bound->center[0] - target[0], r1 = bound->center[1] - target[1],
         r2 = bound->center[2] - target[2];
  return r0 * r0 + r1 * r1 + r2 * r2 < bound->reach2;
}

/* Piece i of the heap, cut out of the element anew. */
static void cut_out(const PieceTree *tree, int e, int i, const double *x, const double *q, Piece *piece) {
  if (i == 0) {
    piece_load(tree->mesh->element[e], x, q, piece);
    return;
  }
  Piece parent, other;
  cut_out(tree, e, (i - 1) / 2, x, q, &parent);
  if (i % 2) {
    piece_bisect(&parent, piece, &other);
  } else {
    piece_bisect(&parent, &other, piece);
  }
}

/* Cuts a near piece until nothing is near.  Returns the number of points. */
static int cut_on(const PieceTree *tree, const Piece *near, Gather *gather) {
  struct {
    Piece piece;
    int depth;
  } stack[MAX_DEPTH + 2];
  int points = 0, top = 1;
  stack[0].depth = stack[1].depth = 1;
  piece_bisect(near, &stack[1].piece, &stack[0].piece);
  while (top >= 0) {
    Piece piece = stack[top].piece;
    int depth = stack[top].depth;
    PieceBound bound = piece_tree_bound_of(tree, &piece);
    if (depth < MAX_DEPTH && is_near(&bound, gather->target)) {
      piece_bisect(&piece, &stack[top + 1].piece, &stack[top].piece);
      stack[top].depth = stack[top + 1].depth = depth + 1;
      top++;
    } else {
      piece_points(&piece, &tree->rule, gather_reserve(gather, tree->rule.n_blocks));
      points += tree->rule.n;
      top--;
    }
  }
  return points;
}

/* Piece i of element e and all below it. */
static int gather_piece(const PieceTree *tree, int e, int i, const double *x, const double *q,
                        Gather *gather) {
  size_t at = (size_t)e * tree->n_pieces + i;
  if (!is_near(&tree->bound[at], gather->target)) {
    gather_add(gather, &tree->points[at * tree->rule.n_blocks], tree->rule.n_blocks);
    return tree->rule.n;
  }
  if (i < tree->n_cut) {
    int first = gather_piece(tree, e, 2 * i + 1, x, q, gather);
    return first + gather_piece(tree, e, 2 * i + 2, x, q, gather);
  }
  Piece piece;
  cut_out(tree, e, i, x, q, &piece);
  return cut_on(tree, &piece, gather);
}

int near_gather(const PieceTree *tree, int e, const double *x, const double *q, Gather *gather,
                bool *was_near) {
  *was_near = is_near(&tree->bound[(size_t)e * tree->n_pieces], gather->target);
  return gather_piece(tree, e, 0, x, q, gather);
}
