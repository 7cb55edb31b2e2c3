/* The point forces near one target: a list of blocks, some made for this target and kept here, the others
 * pointed to where they are, summed whenever the list is full.  Lives on the stack; knows no mesh. */
#ifndef CAPSELLA_FLUID_GATHER_H
#define CAPSELLA_FLUID_GATHER_H

#include "fluid/oseen_kernel.h"

enum { GATHER_LISTED = 256, GATHER_KEPT = 48 };

typedef struct {
  const double *target;
  double u[3]; /* the sum so far */
  int n_listed, n_kept;
  const OseenBlock *listed[GATHER_LISTED];
  OseenBlock kept[GATHER_KEPT];
} Gather;

void gather_start(Gather *gather, const double target[3]);

/* Adds n blocks that stay where they are until gather_flush. */
void gather_add(Gather *gather, const OseenBlock *blocks, int n);

/* Room for n <= GATHER_KEPT blocks, already added, to be filled in before the next call. */
OseenBlock *gather_reserve(Gather *gather, int n);

/* Sums what is listed into gather->u. */
void gather_flush(Gather *gather);

#endif
