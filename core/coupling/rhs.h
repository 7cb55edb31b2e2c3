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
  /* How much damage, which x does not show, has grown from the start of the step to where f was evaluated
   * last: between 0 and 1.  NULL: there is none. */
  double (*damage_growth)(void *context);
  /* What evaluate gives, from a cheaper rule, for the inner stages of a step and for differences of f near
   * its start.  Exact at the start of the step, which open_step names: f = f(t, x).  NULL both: there is
   * none. */
  Status (*open_step)(void *context, const double *x, double t, const double *f, Error *error);
  Status (*stage)(void *context, const double *x, double t, double dt, double *f, Error *error);
} Rhs;

static inline Status rhs_stage(const Rhs *rhs, const double *x, double t, double dt, double *f,
                               Error *error) {
  return (rhs->stage ? rhs->stage : rhs->evaluate)(rhs->context, x, t, dt, f, error);
}

#endif
