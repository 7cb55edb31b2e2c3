/* Point forces near one target, kept as offsets y - x from it, summed whenever the pack is full.
 * Lives on the stack of the thread that works on the target; knows no mesh. */
#ifndef CAPSELLA_FLUID_PACK_H
#define CAPSELLA_FLUID_PACK_H

#include "fluid/oseen_kernel.h"

enum { PACK_CAPACITY = 512 };

typedef struct {
  int n;
  double u[3]; /* the sum so far */
  double place[6][PACK_CAPACITY];
  OseenSources points; /* views of `place` */
} PointPack;

void pack_start(PointPack *pack);

/* Makes room for n <= PACK_CAPACITY points at pack->points, places pack->n .. pack->n + n - 1; the caller
 * fills them and raises pack->n. */
void pack_reserve(PointPack *pack, int n);

/* Adds all points still in the pack to pack->u. */
void pack_flush(PointPack *pack);

#endif
