/* The sum of oseen_kernel.h in single precision: twice to three times as many pairs in the same time. */
#ifndef CAPSELLA_FLUID_COARSE_KERNEL_H
#define CAPSELLA_FLUID_COARSE_KERNEL_H

#include "fluid/oseen_kernel.h"

typedef struct {
  float y[3][OSEEN_LANES], f[3][OSEEN_LANES];
} CoarseBlock;

/* Blocks that stand one after the other. */
typedef struct {
  int first, n;
} CoarseRun;

void coarse_round(const OseenBlock *from, int n, CoarseBlock *to);

/* u += sum of J(x, y) f over n runs of blocks, to 1e-6. */
void coarse_sum(const CoarseBlock *blocks, const CoarseRun *runs, int n, const double x[3], double u[3]);

#endif
