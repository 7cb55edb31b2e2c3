/* Spectral radius of the Jacobian of f by a non-linear power iteration. */
#ifndef CAPSELLA_COUPLING_SPECTRAL_RADIUS_H
#define CAPSELLA_COUPLING_SPECTRAL_RADIUS_H

#include "coupling/rhs.h"

/* Estimates rho(df/dx) at (t, x) with f = f(t, x) given.  `direction` [n] is where the iteration starts and
 * ends: seed it once by spectral_radius_seed and hand the last one in again.  Converges from below to a few
 * per cent. x_trial and f_trial [n] are scratch.  `evaluations` counts those spent. */
Status spectral_radius(const Rhs *rhs, double t, const double *x, const double *f, double *direction,
                       double *x_trial, double *f_trial, double *rho, int *evaluations, Error *error);

/* Fills `direction` with pseudo-random numbers, the same every time.  As a field over the nodes at x (n / 3
 * of them) they have all symmetries that the nodes have under changes of sign of the coordinates, to the last
 * bit: a symmetric problem is measured where it moves, whether or not its symmetry is used. */
void spectral_radius_seed(int n, const double *x, double *direction);

#endif
