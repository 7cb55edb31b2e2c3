/* A full list goes through the kernel and starts anew. */
#include "fluid/gather.h"

void gather_start(Gather *gather, const double target[3]) {
  gather->target = target;
  gather->n_listed = gather->n_kept = 0;
  for (int c = 0; c < 3; c++) gather->u[c] = 0;
}

void gather_flush(Gather *gather) {
  oseen_sum(gather->listed, gather->n_listed, gather->target, gather->u);
  gather->n_listed = gather->n_kept = 0;
}

OseenRun *gather_room(Gather *gather, int n) {
  if (gather->n_listed + n > GATHER_LISTED) gather_flush(gather);
  return &gather->listed[gather->n_listed];
}

void gather_used(Gather *gather, int n) {
  gather->n_listed += n;
}

OseenBlock *gather_reserve(Gather *gather, int n) {
  if (gather->n_kept + n > GATHER_KEPT) gather_flush(gather);
  OseenRun *run = gather_room(gather, 1);
  OseenBlock *blocks = &gather->kept[gather->n_kept];
  *run = (OseenRun){blocks, n};
  gather_used(gather, 1);
  gather->n_kept += n;
  return blocks;
}
