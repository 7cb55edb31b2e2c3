/* The sum over point forces with the Oseen-Burgers tensor (paper eq. 2.3): the one hot loop of the program.
 */
#ifndef CAPSELLA_FLUID_OSEEN_KERNEL_H
#define CAPSELLA_FLUID_OSEEN_KERNEL_H

enum { OSEEN_LANES = 8 };

/* Points y and the forces f that act there, one array for each component. */
typedef struct {
  double *y[3], *f[3];
} OseenSources;

/* A few points that stand together in memory; places not needed repeat a point, with no force. */
typedef struct {
  double y[3][OSEEN_LANES], f[3][OSEEN_LANES];
} OseenBlock;

/* u += sum of J(x, y_i) f_i over first <= i < last, with J = 1/r + r r / r^3.  No y_i may be x. */
void oseen_sum(const OseenSources *sources, int first, int last, const double x[3], double u[3]);

/* The same sum over n blocks, wherever they are. */
void oseen_sum_blocks(const OseenBlock *const *blocks, int n, const double x[3], double u[3]);

#endif
