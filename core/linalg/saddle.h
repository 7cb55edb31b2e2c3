/* The least value of a quadratic form under linear conditions, by LAPACK. */
#ifndef CAPSELLA_LINALG_SADDLE_H
#define CAPSELLA_LINALG_SADDLE_H

#include "base/status.h"

/* Minimises x' H x / 2 - g' x with B x = d.  H [n][n] is symmetric and positive definite where B x = 0;
 * B [conditions][n].  STATUS_FAILED when the conditions do not leave one x. */
Status saddle_solve(int n, int conditions, const double *H, const double *B, const double *g, const double *d,
                    double *x, Error *error);

#endif
