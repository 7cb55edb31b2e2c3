/* Sparse direct solution by UMFPACK: symbolic analysis once, numeric factor for each new set of values.
 * The only room that includes umfpack.h (GPL-2+); built without it, direct_new fails with a sentence that
 * says so. */
#ifndef CAPSELLA_LINALG_DIRECT_H
#define CAPSELLA_LINALG_DIRECT_H

#include "base/status.h"
#include "linalg/sparse.h"

typedef struct DirectSolver DirectSolver;

/* Analyses the pattern, which must outlive the solver.  The matrix may be unsymmetric in values. */
Status direct_new(DirectSolver **solver, const SparseMatrix *matrix, Error *error);
void direct_free(DirectSolver *solver);

/* Factors the present values of the matrix; STATUS_REJECT when it is singular. */
Status direct_factor(DirectSolver *solver, Error *error);

/* Solves for three right-hand sides, x and b [n][3]. */
Status direct_solve3(DirectSolver *solver, const double *b, double *x, Error *error);

#endif
