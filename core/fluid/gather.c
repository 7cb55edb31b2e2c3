/* A full list goes through the kernel and starts anew. */
#include "fluid/gather.h"

#include "base/array.h"

#include <string.h>

void gather_start(Gather *gather, const double target[3]) {
  gather->held = NULL;
  gather->target = target;
  gather->n_listed = gather->n_kept = 0;
  for (int c = 0; c < 3; c++) gather->u[c] = 0;
}

static Status hold_room(HeldRuns *held, int n, Error *error) {
  if (held->n + n <= held->room) return STATUS_OK;
  int room = held->room + held->room / 2 + n;
  CoarseRun *run = NULL;
  Status status = ARRAY_NEW(&run, room, error);
  if (status != STATUS_OK) return status;
  if (held->n > 0) memcpy(run, held->run, held->n * sizeof *run);
  array_free(held->run);
  held->run = run;
  held->room = room;
  return STATUS_OK;
}

/* Runs that follow each other become one. */
static void hold(HeldRuns *held, const OseenRun *runs, int n) {
  Error error;
  if (held->status == STATUS_OK) held->status = hold_room(held, n, &error);
  if (held->status != STATUS_OK) return;
  for (int k = 0; k < n; k++) {
    int first = (int)(runs[k].first - held->blocks);
    CoarseRun *last = held->n > 0 ? &held->run[held->n - 1] : NULL;
    if (last && last->first + last->n == first) {
      last->n += runs[k].n;
    } else {
      held->run[held->n++] = (CoarseRun){first, runs[k].n};
    }
  }
}

void gather_flush(Gather *gather) {
  if (gather->held) {
    hold(gather->held, gather->listed, gather->n_listed);
    gather->n_listed = 0;
    return;
  }
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
