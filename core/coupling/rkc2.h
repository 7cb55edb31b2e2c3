/* The Runge-Kutta-Chebyshev method of order 2 (Sommeijer, Shampine & Verwer, J. Comput. Appl. Math. 88,
 * 1998): s stages are stable on an interval of the negative real axis that grows as 0.65 s^2. */
#ifndef CAPSELLA_COUPLING_RKC2_H
#define CAPSELLA_COUPLING_RKC2_H

#include "coupling/integrator.h"

extern const Integrator integrator_rkc2;

#endif
