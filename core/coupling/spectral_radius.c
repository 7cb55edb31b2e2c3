#include "coupling/spectral_radius.h"

#include "base/random.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { MAX_ITERATIONS = 60 };
static const double CONVERGED = 5e-3;    /* relative change between two iterates */
static const double PERTURBATION = 3e-5; /* well above the round-off of single precision in coarse sums */

static double norm(int n, const double *x) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += x[i] * x[i];
  return sqrt(sum);
}

/* 0 where there is no sign to follow, except at the origin, where there is nothing but that. */
static double odd(double x, double value, bool at_origin) {
  if (x == 0) return at_origin ? value : 0;
  return x < 0 ? -value : value;
}

/* Component c is odd in coordinate c and even in the others. */
void spectral_radius_seed(int n, const double *x, double *direction) {
  for (int first = 0; first < n; first += 3) {
    const int length = n - first < 3 ? n - first : 3;
    uint64_t state = (uint64_t)length;
    bool at_origin = true;
    for (int c = 0; c < length; c++) {
      const double size = fabs(x[first + c]);
      uint64_t bits;
      memcpy(&bits, &size, sizeof bits);
      state = random_mix(state ^ bits);
      at_origin = at_origin && size == 0;
    }
    for (int c = 0; c < length; c++) {
      state = random_mix(state);
      direction[first + c] = odd(x[first + c], random_symmetric(state), at_origin);
    }
  }
}

Status spectral_radius(const Rhs *rhs, double t, const double *x, const double *f, double *direction,
                       double *x_trial, double *f_trial, double *rho, int *evaluations, Error *error) {
  const int n = rhs->n;
  const double size = PERTURBATION * fmax(norm(n, x), 1); /* x is in units of its own size */
  double estimate = 0;
  for (int k = 0; k < MAX_ITERATIONS; k++) {
    if (norm(n, direction) == 0)
      spectral_radius_seed(n, x, direction); /* f did not change along the last one */
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
