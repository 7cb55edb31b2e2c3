#include "coupling/rk2.h"

static double reach(int stages) {
  (void)stages;
  return 2;
}

static Status step(const Rhs *rhs, int stages, double t, double h, const double *x0, const double *f0,
                   double *x1, double *work, Error *error) {
  (void)stages;
  double *middle = work, *f = work + rhs->n;
  for (int i = 0; i < rhs->n; i++) middle[i] = x0[i] + 0.5 * h * f0[i];
  const Status status = rhs->evaluate(rhs->context, middle, t, 0.5 * h, f, error);
  if (status != STATUS_OK) return status;
  for (int i = 0; i < rhs->n; i++) x1[i] = x0[i] + h * f[i];
  return STATUS_OK;
}

const Integrator integrator_rk2 = {
    .name = "rk2", .min_stages = 2, .max_stages = 2, .reach = reach, .step = step};
