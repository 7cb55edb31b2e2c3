/* LAPACK's dspev for 3 x 3 matrices. */
#include "linalg/eigen.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Fortran: eigenvectors by columns; the lengths of the two character arguments come last. */
void dspev_(const char *job, const char *triangle, const int *n, double *packed, double *w, double *z,
            const int *ldz, double *work, int *info, size_t job_length, size_t triangle_length);

Status eigen_symmetric3(const double matrix[6], double value[3], double vector[3][3], Error *error) {
  for (int k = 0; k < 6; k++)
    if (!isfinite(matrix[k]))
      return error_set(error, STATUS_REJECT, "eigenvalues: expected a finite matrix, found an entry of %g",
                       matrix[k]);
  const int n = 3;
  double packed[6], work[9]; /* the upper triangle by rows is the lower one by columns; work [3 n] */
  int info;
  memcpy(packed, matrix, sizeof packed);
  dspev_("V", "L", &n, packed, value, &vector[0][0], &n, work, &info, 1, 1);
  if (info != 0) return error_set(error, STATUS_FAILED, "eigenvalues: dspev failed with info = %d", info);
  return STATUS_OK;
}
