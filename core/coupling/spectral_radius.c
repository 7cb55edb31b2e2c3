#include "coupling/spectral_radius.h"

#include <math.h>
#include <stdint.h>

enum { MAX_ITERATIONS = 60 };
static const double CONVERGED = 1e-2; /* relative change between two iterates */
static const double PERTURBATION = 1e-6;

static double norm(int n, const double *x) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += x[i] * x[i];
  return sqrt(sum);
}

void spectral_radius_seed(int n, double *direction) {
  uint64_t state = 0x9e3779b97f4a7c15u;
  for (int i = 0; i < n; i++) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    direction[i] = (double)(int32_t)(state >> 32) * 0x1p-31;
  }
}

Status spectral_radius(const Rhs *rhs, double t, const double *x, const double *f, double *direction,
                       double *x_trial, double *f_trial, double *rho, int *evaluations, Error *error) {
  const int n = rhs->n;
  const double size = PERTURBATION * fmax(norm(n, x), 1); /* x is in units of its own size */
  double estimate = 0;
  for (int k = 0; k < MAX_ITERATIONS; k++) {
    if (norm(n, direction) == 0) spectral_radius_seed(n, direction); /* f did not change along the last one */
    const double scale = size / norm(n, direction);
    for (int i = 0; i < n; i++) x_trial[i] = x[i] + scale * direction[i];
    const Status status = rhs_stage(rhs, x_trial, t, 0, f_trial, error);
    ++*evaluations;
    if (status != STATUS_OK) return status;
    for (int i = 0; i < n; i++) direction[i] = f_trial[i] - f[i];
    const double last = estimate;
    estimate = norm(n, direction) / size;
    if (k > 0 && fabs(estimate - last) <= CONVERGED * estimate) break;
  }
  *rho = estimate;
  return STATUS_OK;
}
