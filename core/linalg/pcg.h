/* Conjugate gradients with Jacobi preconditioning for a symmetric positive definite matrix and three
 * right-hand sides that share it. */
#ifndef CAPSELLA_LINALG_PCG_H
#define CAPSELLA_LINALG_PCG_H

#include "base/status.h"
#include "linalg/sparse.h"

typedef struct {
  double *r, *z, *p, *Ap;   /* [n][3] each */
  double *inverse_diagonal; /* [n] */
  int n;
} PcgWork;

Status pcg_work_new(PcgWork *work, int n, Error *error);
void pcg_work_free(PcgWork *work);

/* Solves A x = b, x and b [n][3]; x holds the start vector on entry.  Each of the three systems stops when
 * ||D^-1/2 (b - A x)|| <= tolerance * ||D^-1/2 b|| (D the diagonal of A), which keeps the true relative error
 * near `tolerance` since the scaled matrix is well conditioned on any mesh.  Sums run in a fixed order: the
 * result does not depend on the number of threads.  STATUS_REJECT when not converged in max_iterations or
 * when A is not positive. */
Status pcg_solve3(const SparseMatrix *matrix, const double *b, double *x, double tolerance,
                  int max_iterations, PcgWork *work, int *iterations, Error *error);

#endif
