/* UMFPACK.  It stores matrices by columns: our rows are the columns of the transpose, so the transposed
 * system of what UMFPACK is given is ours. */
#include "linalg/direct.h"

#ifdef CAPSELLA_UMFPACK

#include "base/array.h"

#include <umfpack.h>

struct DirectSolver {
  const SparseMatrix *matrix;
  void *symbolic, *numeric;
  double *b, *x; /* [n] one right-hand side and its solution */
};

/* The meaning of UMFPACK's return codes for us; `action` names what was tried. */
static Status direct_status(int code, const char *action, Error *error) {
  switch (code) {
  case UMFPACK_OK:
    return STATUS_OK;
  case UMFPACK_WARNING_singular_matrix:
    return error_set(error, STATUS_REJECT, "UMFPACK: the matrix is singular (%s)", action);
  case UMFPACK_ERROR_out_of_memory:
    return error_set(error, STATUS_MEMORY, "UMFPACK: out of memory (%s)", action);
  default:
    return error_set(error, STATUS_FAILED, "UMFPACK: %s failed with code %d", action, code);
  }
}

Status direct_new(DirectSolver **solver, const SparseMatrix *matrix, Error *error) {
  Status status = STATUS_OK;
  TRY(ARRAY_NEW(solver, 1, error));
  (*solver)->matrix = matrix;
  TRY(ARRAY_NEW(&(*solver)->b, matrix->n, error));
  TRY(ARRAY_NEW(&(*solver)->x, matrix->n, error));
  TRY(direct_status(umfpack_di_symbolic(matrix->n, matrix->n, matrix->row_start, matrix->column, NULL,
                                        &(*solver)->symbolic, NULL, NULL),
                    "symbolic analysis", error));
cleanup:
  if (status != STATUS_OK) {
    direct_free(*solver);
    *solver = NULL;
  }
  return status;
}

void direct_free(DirectSolver *solver) {
  if (!solver) return;
  umfpack_di_free_numeric(&solver->numeric);
  umfpack_di_free_symbolic(&solver->symbolic);
  array_free(solver->b);
  array_free(solver->x);
  array_free(solver);
}

Status direct_factor(DirectSolver *solver, Error *error) {
  const SparseMatrix *matrix = solver->matrix;
  umfpack_di_free_numeric(&solver->numeric);
  int code = umfpack_di_numeric(matrix->row_start, matrix->column, matrix->value, solver->symbolic,
                                &solver->numeric, NULL, NULL);
  if (code != UMFPACK_OK) umfpack_di_free_numeric(&solver->numeric); /* a singular matrix has factors too */
  return direct_status(code, "numeric factorisation", error);
}

Status direct_solve3(DirectSolver *solver, const double *b, double *x, Error *error) {
  const SparseMatrix *matrix = solver->matrix;
  if (!solver->numeric) return error_set(error, STATUS_FAILED, "UMFPACK: solve before a factorisation");
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < matrix->n; i++) solver->b[i] = b[3 * i + c];
    Status status =
        direct_status(umfpack_di_solve(UMFPACK_At, matrix->row_start, matrix->column, matrix->value,
                                       solver->x, solver->b, solver->numeric, NULL, NULL),
                      "solution", error);
    if (status != STATUS_OK) return status;
    for (int i = 0; i < matrix->n; i++) x[3 * i + c] = solver->x[i];
  }
  return STATUS_OK;
}

#else

#include <stddef.h>

static Status direct_missing(Error *error) {
  return error_set(error, STATUS_INPUT,
                   "this program was built without UMFPACK: choose mass_solver: pcg, or build with "
                   "-DCAPSELLA_UMFPACK=ON");
}

Status direct_new(DirectSolver **solver, const SparseMatrix *matrix, Error *error) {
  (void)matrix;
  *solver = NULL;
  return direct_missing(error);
}

void direct_free(DirectSolver *solver) {
  (void)solver;
}

Status direct_factor(DirectSolver *solver, Error *error) {
  (void)solver;
  return direct_missing(error);
}

Status direct_solve3(DirectSolver *solver, const double *b, double *x, Error *error) {
  (void)solver;
  (void)b;
  (void)x;
  return direct_missing(error);
}

#endif
