/* The sum over point forces with the Oseen-Burgers tensor (paper eq. 2.3): the one hot loop of the program.
 */
#ifndef CAPSELLA_FLUID_OSEEN_KERNEL_H
#define CAPSELLA_FLUID_OSEEN_KERNEL_H

enum { OSEEN_LANES = 8 };

/* Points y and the forces f that act there, as many as fill a vector; places not needed repeat a point, with
 * no force. */
typedef struct {
  double y[3][OSEEN_LANES], f[3][OSEEN_LANES];
} OseenBlock;

/* Blocks that stand one after the other. */
typedef struct {
  const OseenBlock *first;
  int n;
} OseenRun;

/* The images of n blocks under a change of sign of the coordinates. */
void oseen_reflect(const double sign[3], const OseenBlock *from, int n, OseenBlock *to);

/* u += sum of J(x, y) f over the points of n runs, with J = 1/r + r r / r^3.  No y may be x. */
void oseen_sum(const OseenRun *runs, int n, const double x[3], double u[3]);

#endif
