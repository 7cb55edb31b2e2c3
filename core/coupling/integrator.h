/* Explicit one-step integrators of order two or three behind one small table.  Each passes the same test
 * suite. */
#ifndef CAPSELLA_COUPLING_INTEGRATOR_H
#define CAPSELLA_COUPLING_INTEGRATOR_H

#include "base/status.h"
#include "config/scene.h"
#include "coupling/rhs.h"

typedef struct {
  const char *name;
  int min_stages, max_stages;
  /* Length of the interval of the negative real axis on which `stages` stages are stable: h rho must stay
   * below. */
  double (*reach)(int stages);
  /* x1 from x0 and f0 = f(t, x0) over a step h; costs stages - 1 evaluations, since f0 is given.
   * work [INTEGRATOR_WORK * n]. */
  Status (*step)(const Rhs *rhs, int stages, double t, double h, const double *x0, const double *f0,
                 double *x1, double *work, Error *error);
} Integrator;

enum { INTEGRATOR_WORK = 4 }; /* arrays of n doubles that a step may need */

const Integrator *integrator_get(IntegratorKind kind);

/* Fewest stages that are stable at h rho; 0 when even max_stages are not. */
int integrator_stages(const Integrator *integrator, double h_rho);

#endif
