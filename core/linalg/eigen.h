/* Symmetric eigenproblem by LAPACK: the one room that names it. */
#ifndef CAPSELLA_LINALG_EIGEN_H
#define CAPSELLA_LINALG_EIGEN_H

#include "base/status.h"

/* Eigenvalues in rising order and unit eigenvectors (vector[k] belongs to value[k]) of a symmetric matrix
 * given as [xx, xy, xz, yy, yz, zz].  STATUS_REJECT when an entry is not finite. */
Status eigen_symmetric3(const double matrix[6], double value[3], double vector[3][3], Error *error);

#endif
