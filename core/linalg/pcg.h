/* Conjugate gradients with Jacobi preconditioning for a symmetric positive definite matrix and three
 * right-hand sides that share it. */
#ifndef CAPSELLA_LINALG_PCG_H
#define CAPSELLA_LINALG_PCG_H

#include "base/status.h"
#include "linalg/sparse.h"

/* Vectors of the iteration, [n][4]: the three systems side by side and a column of zeros, so that the four
 * move as one vector of the machine. */
typedef struct {
  double *x, *r, *p, *Ap;
  double *inverse_diagonal; /* [n] */
  double *ones;             /* [n] weights of nodes without a symmetry */
  int n;
} PcgWork;

Status pcg_work_new(PcgWork *work, int n, Error *error);
void pcg_work_free(PcgWork *work);

/* Solves A x = b, x and b [n][3]; x holds the start vector on entry.  Each of the three systems stops when
 * ||D^-1/2 (b - A x)|| <= tolerance * ||D^-1/2 b|| (D the diagonal of A), which keeps the true relative error
 * near `tolerance`: the eigenvalues of the scaled P2 mass matrix lie between 0.39 and 2.06 on any flat mesh
 * (Wathen 1987).  `iterations` counts those of the slowest system.  Runs on one thread, sums in a fixed
 * order. STATUS_REJECT, with x as it was, when not converged in max_iterations, when A is not positive or a
 * value is not finite. */
Status pcg_solve3(const SparseMatrix *matrix, const double *b, double *x, double tolerance,
                  int max_iterations, PcgWork *work, int *iterations, Error *error);

/* The same on one node of each orbit, b and x [n][3] at those nodes. */
Status pcg_solve3_images(const SparseMatrix *matrix, const SparseImages *images, const double *b, double *x,
                         double tolerance, int max_iterations, PcgWork *work, int *iterations, Error *error);

#endif
