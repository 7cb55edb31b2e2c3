#include "coupling/rkc2.h"

#include "coupling/stages.h"
#include <string.h>

static const double DAMPING = 2.0 / 13;

static double shift(int stages) {
  return 1 + DAMPING / ((double)stages * stages);
}

static double reach(int stages) {
  const Chebyshev p = chebyshev(stages, shift(stages));
  return (1 + shift(stages)) * p.d2T / p.dT;
}

/* The last stage is the end of the step. */
static Status step(const Rhs *rhs, int stages, double t, double h, const double *x0, const double *f0,
                   double *x1, double *work, Error *error) {
  const int n = rhs->n;
  double *before = work, *last = work + n, *f = work + 2 * n, *next = x1;
  Stages recurrence = stages_open(shift(stages), stages);
  StageTerms terms = stages_next(&recurrence);
  memcpy(before, x0, (size_t)n * sizeof *before);
  stage_sum(&terms, h, n, x0, f0, NULL, NULL, NULL, last);
  for (int j = 2; j <= stages; j++) {
    const Status status = rhs_stage(rhs, last, t, terms.time * h, f, error);
    if (status != STATUS_OK) return status;
    terms = stages_next(&recurrence);
    stage_sum(&terms, h, n, x0, f0, last, before, f, next);
    stages_turn(&before, &last, &next);
  }
  if (last != x1) memcpy(x1, last, (size_t)n * sizeof *x1);
  return STATUS_OK;
}

const Integrator integrator_rkc2 = {
    .name = "rkc2", .min_stages = 2, .max_stages = 200, .reach = reach, .step = step};
