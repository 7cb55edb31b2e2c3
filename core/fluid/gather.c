/* A full list goes through the kernel and starts anew. */
#include "fluid/gather.h"

void gather_start(Gather *gather, const double target[3]) {
  gather->target = target;
  gather->n_listed = gather->n_kept = 0;
  for (int c = 0; c < 3; c++) gather->u[c] = 0;
}

void gather_flush(Gather *gather) {
  oseen_sum_blocks(gather->listed, gather->n_listed, gather->target, gather->u);
  gather->n_listed = gather->n_kept = 0;
}

void gather_add(Gather *gather, const OseenBlock *blocks, int n) {
  if (gather->n_listed + n > GATHER_LISTED) gather_flush(gather);
  for (int i = 0; i < n; i++) gather->listed[gather->n_listed++] = &blocks[i];
}

OseenBlock *gather_reserve(Gather *gather, int n) {
  if (gather->n_kept + n > GATHER_KEPT || gather->n_listed + n > GATHER_LISTED) gather_flush(gather);
  OseenBlock *blocks = &gather->kept[gather->n_kept];
  gather_add(gather, blocks, n);
  gather->n_kept += n;
  return blocks;
}
