#include "coupling/integrator.h"

#include "coupling/rk2.h"
#include "coupling/rkc2.h"
#include "coupling/rkc3.h"

const Integrator *integrator_get(IntegratorKind kind) {
  static const Integrator *const integrators[] = {[INTEGRATOR_RK2] = &integrator_rk2,
                                                  [INTEGRATOR_RKC2] = &integrator_rkc2,
                                                  [INTEGRATOR_RKC3] = &integrator_rkc3};
  return integrators[kind];
}

int integrator_stages(const Integrator *integrator, double h_rho) {
  for (int stages = integrator->min_stages; stages <= integrator->max_stages; stages++)
    if (integrator->reach(stages) >= h_rho) return stages;
  return 0;
}
