/* The explicit midpoint rule, the paper's scheme (section 3.4): order 2, stable for h rho <= 2. */
#ifndef CAPSELLA_COUPLING_RK2_H
#define CAPSELLA_COUPLING_RK2_H

#include "coupling/integrator.h"

extern const Integrator integrator_rk2;

#endif
