/* Preconditioned conjugate gradients on four columns at once: three systems and one of zeros.
 *
 * Called for every velocity evaluation.  The loops over the columns are for the compiler to turn into one
 * vector operation, and what happens to a row happens in one pass: the product with p . Ap, the two updates
 * with r . z.  The preconditioned residual z = D^-1 r is never stored. A system that has converged goes on
 * with steps of length zero until the others have. */
#include "linalg/pcg.h"

#include "base/array.h"
#include "base/vector_clones.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { COLUMNS = 4 };

Status pcg_work_new(PcgWork *work, int n, Error *error) {
  Status status = STATUS_OK;
  size_t size = COLUMNS * (size_t)n;
  *work = (PcgWork){.n = n};
  TRY(ARRAY_NEW(&work->x, size, error));
  TRY(ARRAY_NEW(&work->r, size, error));
  TRY(ARRAY_NEW(&work->p, size, error));
  TRY(ARRAY_NEW(&work->Ap, size, error));
  TRY(ARRAY_NEW(&work->inverse_diagonal, n, error));
  TRY(ARRAY_NEW(&work->ones, n, error));
  for (int i = 0; i < n; i++) work->ones[i] = 1;
cleanup:
  if (status != STATUS_OK) pcg_work_free(work);
  return status;
}

void pcg_work_free(PcgWork *work) {
  array_free(work->x);
  array_free(work->r);
  array_free(work->p);
  array_free(work->Ap);
  array_free(work->inverse_diagonal);
  array_free(work->ones);
  *work = (PcgWork){0};
}

static Status invert_diagonal(const SparseMatrix *matrix, const SparseImages *images, double *inverse,
                              Error *error) {
  for (int i = 0; i < matrix->n; i++) {
    int k = images ? images->diagonal[i] : sparse_index(matrix, i, i);
    double diagonal = k < 0 ? 0.0 : matrix->value[k];
    if (!(diagonal > 0.0) || !isfinite(diagonal))
      return error_set(error, STATUS_REJECT,
                       "conjugate gradients: expected a positive matrix, found %g on the diagonal of row %d",
                       diagonal, i);
    inverse[i] = 1.0 / diagonal;
  }
  return STATUS_OK;
}

/* y = A x and, by columns, dot = x . y. */
VECTOR_CLONES static void multiply(const SparseMatrix *matrix, const double *restrict x, double *restrict y,
                                   double dot[COLUMNS]) {
  const int *restrict column = matrix->column;
  const double *restrict value = matrix->value;
  double total[COLUMNS] = {0.0};
  for (int row = 0; row < matrix->n; row++) {
    double sum[COLUMNS] = {0.0};
    for (int k = matrix->row_start[row]; k < matrix->row_start[row + 1]; k++) {
      const double *entry = &x[COLUMNS * (size_t)column[k]];
#pragma omp simd /* gcc 12 splits the four columns without it */
      for (int c = 0; c < COLUMNS; c++) sum[c] += value[k] * entry[c];
    }
    for (int c = 0; c < COLUMNS; c++) {
      y[COLUMNS * row + c] = sum[c];
      total[c] += sum[c] * x[COLUMNS * row + c];
    }
  }
  memcpy(dot, total, sizeof total);
}

/* The same on one node of each orbit. */
VECTOR_CLONES static void multiply_images(const SparseMatrix *matrix, const SparseImages *images,
                                          const double *restrict x, double *restrict y, double dot[COLUMNS]) {
  const int *restrict column = matrix->column;
  const double *restrict value = matrix->value;
  double total[COLUMNS] = {0.0};
  for (int row = 0; row < matrix->n; row++) {
    double sum[COLUMNS] = {0.0};
    for (int k = matrix->row_start[row]; k < matrix->row_start[row + 1]; k++) {
      const double *entry = &x[COLUMNS * (size_t)column[k]], *sign = images->sign[images->operation[k]];
#pragma omp simd
      for (int c = 0; c < COLUMNS; c++) sum[c] += value[k] * (sign[c] * entry[c]);
    }
    for (int c = 0; c < COLUMNS; c++) {
      y[COLUMNS * row + c] = sum[c];
      total[c] += images->weight[row] * sum[c] * x[COLUMNS * row + c];
    }
  }
  memcpy(dot, total, sizeof total);
}

/* r = b - A x (Ap holds A x), p = D^-1 r, and the squared norms of r and b that the stop rule compares. */
static void start(PcgWork *work, const double *b, const double *weight, double residual[COLUMNS],
                  double right_side[COLUMNS]) {
  memset(residual, 0, COLUMNS * sizeof *residual);
  memset(right_side, 0, COLUMNS * sizeof *right_side);
  for (int i = 0; i < work->n; i++)
    for (int c = 0; c < 3; c++) {
      int k = COLUMNS * i + c;
      double inverse = work->inverse_diagonal[i];
      work->r[k] = b[3 * i + c] - work->Ap[k];
      work->p[k] = inverse * work->r[k];
      residual[c] += weight[i] * work->r[k] * work->p[k];
      right_side[c] += weight[i] * b[3 * i + c] * inverse * b[3 * i + c];
    }
}

/* x += alpha p, r -= alpha Ap; returns r . D^-1 r by columns. */
VECTOR_CLONES static void advance(PcgWork *work, const double *restrict weight, const double alpha[COLUMNS],
                                  double residual[COLUMNS]) {
  double *restrict x = work->x, *restrict r = work->r;
  const double *restrict p = work->p, *restrict Ap = work->Ap;
  double total[COLUMNS] = {0.0};
  for (int i = 0; i < work->n; i++) {
    double inverse = work->inverse_diagonal[i];
    for (int c = 0; c < COLUMNS; c++) {
      int k = COLUMNS * i + c;
      x[k] += alpha[c] * p[k];
      r[k] -= alpha[c] * Ap[k];
      total[c] += weight[i] * r[k] * inverse * r[k];
    }
  }
  memcpy(residual, total, sizeof total);
}

/* p = D^-1 r + beta p. */
VECTOR_CLONES static void turn(PcgWork *work, const double beta[COLUMNS]) {
  double *restrict p = work->p;
  const double *restrict r = work->r;
  for (int i = 0; i < work->n; i++) {
    double inverse = work->inverse_diagonal[i];
    for (int c = 0; c < COLUMNS; c++) {
      int k = COLUMNS * i + c;
      p[k] = inverse * r[k] + beta[c] * p[k];
    }
  }
}

static void product(const SparseMatrix *matrix, const SparseImages *images, const double *x, double *y,
                    double dot[COLUMNS]) {
  if (images)
    multiply_images(matrix, images, x, y, dot);
  else
    multiply(matrix, x, y, dot);
}

/* The iteration proper, on work->x. */
static Status iterate(const SparseMatrix *matrix, const SparseImages *images, const double *b,
                      double tolerance, int max_iterations, PcgWork *work, int *iterations, Error *error) {
  double residual[COLUMNS], right_side[COLUMNS], curvature[COLUMNS];
  const double *weight = images ? images->weight : work->ones;
  product(matrix, images, work->x, work->Ap, curvature);
  start(work, b, weight, residual, right_side);
  for (*iterations = 0;; ++*iterations) {
    bool active[COLUMNS], any = false;
    for (int c = 0; c < COLUMNS; c++) {
      if (!isfinite(residual[c]))
        return error_set(error, STATUS_REJECT, "conjugate gradients: a value is not finite");
      active[c] = residual[c] > tolerance * tolerance * right_side[c];
      any = any || active[c];
    }
    if (!any) return STATUS_OK;
    if (*iterations == max_iterations)
      return error_set(error, STATUS_REJECT, "conjugate gradients: not converged to %g in %d iterations",
                       tolerance, max_iterations);

    product(matrix, images, work->p, work->Ap, curvature);
    double alpha[COLUMNS], beta[COLUMNS], previous[COLUMNS];
    for (int c = 0; c < COLUMNS; c++) {
      if (active[c] && !(curvature[c] > 0.0))
        return error_set(error, STATUS_REJECT,
                         "conjugate gradients: expected a positive matrix, found p . A p = %g", curvature[c]);
      alpha[c] = active[c] ? residual[c] / curvature[c] : 0.0;
      previous[c] = residual[c];
    }
    advance(work, weight, alpha, residual);
    for (int c = 0; c < COLUMNS; c++) beta[c] = active[c] ? residual[c] / previous[c] : 0.0;
    turn(work, beta);
  }
}

/* Copies the start vector in; a system whose right-hand side is zero starts at its solution, which no
 * relative tolerance could reach. */
static void load(PcgWork *work, const double *b, const double *x) {
  bool zero[3] = {true, true, true};
  for (int i = 0; i < work->n; i++)
    for (int c = 0; c < 3; c++) zero[c] = zero[c] && b[3 * i + c] == 0.0;
  for (int i = 0; i < work->n; i++)
    for (int c = 0; c < 3; c++) work->x[COLUMNS * i + c] = zero[c] ? 0.0 : x[3 * i + c];
}

Status pcg_solve3_images(const SparseMatrix *matrix, const SparseImages *images, const double *b, double *x,
                         double tolerance, int max_iterations, PcgWork *work, int *iterations, Error *error) {
  Status status = STATUS_OK;
  *iterations = 0;
  TRY(invert_diagonal(matrix, images, work->inverse_diagonal, error));
  load(work, b, x);
  TRY(iterate(matrix, images, b, tolerance, max_iterations, work, iterations, error));
  for (int i = 0; i < work->n; i++)
    for (int c = 0; c < 3; c++) x[3 * i + c] = work->x[COLUMNS * i + c];
cleanup:
  return status;
}

Status pcg_solve3(const SparseMatrix *matrix, const double *b, double *x, double tolerance,
                  int max_iterations, PcgWork *work, int *iterations, Error *error) {
  return pcg_solve3_images(matrix, NULL, b, x, tolerance, max_iterations, work, iterations, error);
}
