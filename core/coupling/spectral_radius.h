/* Spectral radius of the Jacobian of f by a non-linear power iteration. */
#ifndef CAPSELLA_COUPLING_SPECTRAL_RADIUS_H
#define CAPSELLA_COUPLING_SPECTRAL_RADIUS_H

#include "coupling/rhs.h"

/* Estimates rho(df/dx) at (t, x) with f = f(t, x) given.  `direction` [n] is where the iteration starts and
 * ends: seed it once by spectral_radius_seed and hand the last one in again.  Converges from below to a few
 * per cent. x_trial and f_trial [n] are scratch.  `evaluations` counts those spent. */
Status spectral_radius(const Rhs *rhs, double t, const double *x, const double *f, double *direction,
                       double *x_trial, double *f_trial, double *rho, int *evaluations, Error *error);

/* Fills `direction` with the same pseudo-random numbers every time. */
void spectral_radius_seed(int n, double *direction);

#endif
