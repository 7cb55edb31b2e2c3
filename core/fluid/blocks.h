/* Blocks of consecutive elements with bounding spheres: finds the few that may be near a target, so that all
 * others can be summed in long index ranges.  Nothing is kept from one evaluation to the next. */
#ifndef CAPSELLA_FLUID_BLOCKS_H
#define CAPSELLA_FLUID_BLOCKS_H

#include "fluid/piece_tree.h"

/* The children of an element have four consecutive numbers. */
enum { BLOCK_ELEMENTS = 4 };

typedef struct {
  int n;             /* blocks */
  double *center[3]; /* [n] each */
  double *reach2;    /* [n] squared: a target farther away is near no element of the block */
} Blocks;

Status blocks_new(Blocks *blocks, int n_elements, Error *error);
void blocks_free(Blocks *blocks);

/* Block b about the elements first .. last - 1 of the tree. */
void blocks_update(Blocks *blocks, int b, const PieceTree *tree, int first, int last);

/* far[i] = 1 when block first + i cannot be near the target, else 0, for i < n. */
void blocks_scan(const Blocks *blocks, const double target[3], int first, int n, int *far);

#endif
