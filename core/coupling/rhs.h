/* The ordinary differential equation that the integrators see: dx/dt = f(t, x), x [n]. */
#ifndef CAPSELLA_COUPLING_RHS_H
#define CAPSELLA_COUPLING_RHS_H

#include "base/status.h"

/* f [n] at x [n] and time t + dt, where t is the time of the accepted state (a law with memory sees both).
 * STATUS_REJECT when x is no admissible state: a smaller step may do. */
typedef struct {
  int n;
  void *context;
  Status (*evaluate)(void *context, const double *x, double t, double dt, double *f, Error *error);
  /* Moves x [n] onto the invariants of the equation, by no more than the error of a step; NULL: there are
   * none. */
  void (*constrain)(void *context, double *x);
} Rhs;

#endif
