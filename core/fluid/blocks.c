/* Spheres about the spheres of the elements. */
#include "fluid/blocks.h"

#include "base/array.h"
#include "base/vec3.h"

#include <math.h>

/* Keeps a block's sphere outside of its elements' in spite of round-off. */
static const double WIDEN = 1 + 1e-12;

Status blocks_new(Blocks *blocks, int n_elements, Error *error) {
  Status status = STATUS_OK;
  *blocks = (Blocks){.n = (n_elements + BLOCK_ELEMENTS - 1) / BLOCK_ELEMENTS};
  for (int c = 0; c < 3; c++) TRY(ARRAY_NEW(&blocks->center[c], blocks->n, error));
  TRY(ARRAY_NEW(&blocks->reach2, blocks->n, error));
cleanup:
  return status;
}

void blocks_free(Blocks *blocks) {
  for (int c = 0; c < 3; c++) array_free(blocks->center[c]);
  array_free(blocks->reach2);
}

void blocks_update(Blocks *blocks, int b, const PieceTree *tree, int first, int last) {
  double center[3] = {0, 0, 0}, reach = 0;
  for (int e = first; e < last; e++) {
    const PieceBound *bound = &tree->bound[(size_t)e * tree->n_pieces];
    for (int c = 0; c < 3; c++) center[c] += bound->center[c] / (last - first);
  }
  for (int e = first; e < last; e++) {
    const PieceBound *bound = &tree->bound[(size_t)e * tree->n_pieces];
    reach = fmax(reach, vec3_distance(center, bound->center) + sqrt(bound->reach2));
  }
  for (int c = 0; c < 3; c++) blocks->center[c][b] = center[c];
  blocks->reach2[b] = WIDEN * reach * reach;
}

void blocks_scan(const Blocks *blocks, const double target[3], int first, int n, int *far) {
  const double *restrict c0 = blocks->center[0] + first, *restrict c1 = blocks->center[1] + first;
  const double *restrict c2 = blocks->center[2] + first, *restrict reach2 = blocks->reach2 + first;
  const double x0 = target[0], x1 = target[1], x2 = target[2];
  for (int i = 0; i < n; i++) {
    double r0 = c0[i] - x0, r1 = c1[i] - x1, r2 = c2[i] - x2;
    far[i] = r0 * r0 + r1 * r1 + r2 * r2 > reach2[i];
  }
}
