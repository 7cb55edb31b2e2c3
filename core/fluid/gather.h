/* The point forces that act on one target: a list of runs of blocks, some made for this target and kept here,
 * the others where they are.  Summed whenever the list is full.  Lives on the stack; knows no mesh. */
#ifndef CAPSELLA_FLUID_GATHER_H
#define CAPSELLA_FLUID_GATHER_H

#include "base/status.h"
#include "fluid/coarse_kernel.h"
#include "fluid/oseen_kernel.h"

enum { GATHER_LISTED = 512, GATHER_KEPT = 48 };

/* Where runs of blocks[] go that are to be summed later, and more than once. */
typedef struct {
  const OseenBlock *blocks;
  int n, room;
  CoarseRun *run; /* [n] */
  Status status;  /* STATUS_MEMORY when the list could not grow */
} HeldRuns;

typedef struct {
  HeldRuns *held; /* NULL: runs are summed at once */
  const double *target;
  double u[3]; /* the sum so far */
  int n_listed, n_kept;
  OseenRun listed[GATHER_LISTED];
  OseenBlock kept[GATHER_KEPT];
} Gather;

void gather_start(Gather *gather, const double target[3]);

/* Room for n <= GATHER_LISTED runs at the end of the list, of blocks that stay as they are until the list is
 * summed.  gather_used says how many of them were filled in. */
OseenRun *gather_room(Gather *gather, int n);
void gather_used(Gather *gather, int n);

/* Room for n <= GATHER_KEPT blocks, already added, to be filled in before the next call. */
OseenBlock *gather_reserve(Gather *gather, int n);

/* Sums what is listed into gather->u, or adds it to gather->held. */
void gather_flush(Gather *gather);

#endif
