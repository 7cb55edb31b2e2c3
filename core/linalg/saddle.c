/* LAPACK's dsysv for [H B'; B 0]. */
#include "linalg/saddle.h"

#include "base/array.h"
#include <stddef.h>
#include <string.h>

void dsysv_(const char *triangle, const int *n, const int *columns, double *A, const int *lda, int *pivot,
            double *b, const int *ldb, double *work, const int *lwork, int *info, size_t triangle_length);

enum { BLOCK = 32 }; /* columns that LAPACK takes together when it has the room */

Status saddle_solve(int n, int conditions, const double *H, const double *B, const double *g, const double *d,
                    double *x, Error *error) {
  Status status = STATUS_OK;
  double *A = NULL, *b = NULL, *work = NULL;
  int *pivot = NULL, info;
  const int size = n + conditions, one = 1, work_size = BLOCK * size;
  TRY(ARRAY_NEW(&A, size * size, error));
  TRY(ARRAY_NEW(&b, size, error));
  TRY(ARRAY_NEW(&work, work_size, error));
  TRY(ARRAY_NEW(&pivot, size, error));
  for (int i = 0; i < n; i++) memcpy(A + i * size, H + i * n, (size_t)n * sizeof *A);
  for (int k = 0; k < conditions; k++) memcpy(A + (n + k) * size, B + k * n, (size_t)n * sizeof *A);
  memcpy(b, g, (size_t)n * sizeof *b);
  memcpy(b + n, d, (size_t)conditions * sizeof *b);
  dsysv_("U", &size, &one, A, &size, pivot, b, &size, work, &work_size, &info,
         1); /* rows are columns there */
  if (info != 0) status = error_set(error, STATUS_FAILED, "saddle point: dsysv failed with info = %d", info);
  memcpy(x, b, (size_t)n * sizeof *x);
cleanup:
  array_free(A);
  array_free(b);
  array_free(work);
  array_free(pivot);
  return status;
}
