/* Symmetric eigenproblem by LAPACK: the one room that names it. */
#ifndef CAPSELLA_LINALG_EIGEN_H
#define CAPSELLA_LINALG_EIGEN_H

#include "base/status.h"

/* Eigenvalues in rising order and unit eigenvectors (vector[k] belongs to value[k]) of a symmetric matrix. */
Status eigen_symmetric3(const double matrix[3][3], double value[3], double vector[3][3], Error *error);

#endif
