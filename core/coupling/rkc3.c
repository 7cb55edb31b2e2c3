#include "coupling/rkc3.h"

#include "base/array.h"
#include "coupling/rkc2.h"
#include "coupling/stages.h"
#include "linalg/saddle.h"
#include <math.h>
#include <string.h>

enum { CONDITIONS = 3, POINTS_PER_STAGE = 4, SWEEPS = 4 };

static const double PI = 3.14159265358979323846;
static const double SHARE_FLOOR = 0.3; /* points where R happens to be 0 still count in the next sweep */
static const double RIDGE = 1e-3; /* on the mean square of the weights: keeps out large ones that cancel */

/* The stages oscillate on the interval that they are stable on.  This damping makes that interval little
 * longer than the reach, so that weights of order one can shape the step there. */
static double shift(int stages) {
  const double damping = fmax(2.0 / 13, 3 - 18.0 / stages);
  return 1 + damping / ((double)stages * stages);
}

/* A fit from below to the longest interval on which the weights leave |R| < 0.95 away from 0. */
static double reach_of_three(int stages) {
  return 0.465 * stages * stages - 4.8;
}

static Stages open_stages(int stages) {
  return stages_open(shift(stages), stages - 1);
}

/* ---- weights ---- */

/* The linear problem x' = z x, one step from x = 1, at points z along the reach: the step is R = 1 + sum b_j
 * z P_j, with P_j the stages.  Unknowns are the weights but b_1. */
typedef struct {
  int stages, unknowns, points;
  double *F;     /* [unknowns][points] z P_j */
  double *times; /* [unknowns] */
  double *share; /* [points] of each point in the sum of squares */
  double *H, *B, *g, *x;
  double *scratch; /* [5][points] */
} Fit;

static Status fit_new(Fit *fit, int stages, Error *error) {
  Status status = STATUS_OK;
  const int unknowns = stages - 1, points = POINTS_PER_STAGE * stages;
  *fit = (Fit){.stages = stages, .unknowns = unknowns, .points = points};
  TRY(ARRAY_NEW(&fit->F, unknowns * points, error));
  TRY(ARRAY_NEW(&fit->times, unknowns, error));
  TRY(ARRAY_NEW(&fit->share, points, error));
  TRY(ARRAY_NEW(&fit->H, unknowns * unknowns, error));
  TRY(ARRAY_NEW(&fit->B, unknowns * CONDITIONS, error));
  TRY(ARRAY_NEW(&fit->g, unknowns, error));
  TRY(ARRAY_NEW(&fit->x, unknowns, error));
  TRY(ARRAY_NEW(&fit->scratch, 5 * points, error));
cleanup:
  return status;
}

static void fit_free(Fit *fit) {
  double *const arrays[] = {fit->F, fit->times, fit->share, fit->H, fit->B, fit->g, fit->x, fit->scratch};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) array_free(arrays[i]);
}

/* Runs the stages on the linear problem, at the extrema of a Chebyshev polynomial along the reach, where an
 * even sum of squares comes near the least maximum. */
static void run_stages(Fit *fit) {
  const int n = fit->points;
  double *z = fit->scratch, *one = z + n, *before = z + 2 * n, *last = z + 3 * n, *next = z + 4 * n;
  for (int i = 0; i < n; i++) {
    z[i] = -0.5 * reach_of_three(fit->stages) * (1 - cos(PI * i / (n - 1)));
    before[i] = one[i] = fit->share[i] = 1;
  }
  Stages recurrence = open_stages(fit->stages);
  StageTerms terms = stages_next(&recurrence);
  memcpy(fit->F, z, (size_t)n * sizeof *z); /* z P_0 */
  stage_sum(&terms, 1, n, one, z, NULL, NULL, NULL, last);
  double *f = fit->F + n; /* of stage 1 for the moment, which then makes room for stage 2 */
  for (int i = 0; i < n; i++) f[i] = z[i] * last[i];
  for (int k = 1; k < fit->unknowns; k++) {
    terms = stages_next(&recurrence);
    stage_sum(&terms, 1, n, one, z, last, before, f, next);
    f = fit->F + k * n;
    for (int i = 0; i < n; i++) f[i] = z[i] * next[i];
    fit->times[k] = terms.time;
    stages_turn(&before, &last, &next);
  }
}

/* Least sum of share R^2 with the conditions of order 3. */
static Status solve(Fit *fit, Error *error) {
  const int n = fit->unknowns, points = fit->points;
  for (int k = 0; k < n; k++) {
    const double *F_k = fit->F + k * points;
    fit->g[k] = 0;
    for (int i = 0; i < points; i++) fit->g[k] -= fit->share[i] * F_k[i];
    for (int l = 0; l <= k; l++) {
      const double *F_l = fit->F + l * points;
      double sum = k == l ? RIDGE * points : 0;
      for (int i = 0; i < points; i++) sum += fit->share[i] * F_k[i] * F_l[i];
      fit->H[k * n + l] = fit->H[l * n + k] = sum;
    }
    fit->B[k] = 1;
    fit->B[n + k] = fit->times[k];
    fit->B[2 * n + k] = fit->times[k] * fit->times[k];
  }
  const double d[CONDITIONS] = {1, 1.0 / 2, 1.0 / 3};
  return saddle_solve(n, CONDITIONS, fit->H, fit->B, fit->g, d, fit->x, error);
}

/* Points where |R| is large get a larger share: from the least sum of squares towards the least maximum
 * (Lawson's iteration). */
static void shift_shares(Fit *fit) {
  double sum = 0;
  for (int i = 0; i < fit->points; i++) {
    double R = 1;
    for (int k = 0; k < fit->unknowns; k++) R += fit->F[k * fit->points + i] * fit->x[k];
    fit->share[i] *= SHARE_FLOOR + fabs(R);
    sum += fit->share[i];
  }
  for (int i = 0; i < fit->points; i++) fit->share[i] *= fit->points / sum;
}

Status rkc3_weights(int stages, double *b, Error *error) {
  Status status = STATUS_OK;
  Fit fit;
  TRY(fit_new(&fit, stages, error));
  run_stages(&fit);
  for (int sweep = 0; sweep < SWEEPS; sweep++) {
    if (sweep > 0) shift_shares(&fit);
    TRY(solve(&fit, error));
  }
  b[0] = fit.x[0];
  b[1] = 0;
  for (int k = 1; k < fit.unknowns; k++) b[k + 1] = fit.x[k];
cleanup:
  fit_free(&fit);
  return status;
}

/* ---- one step ---- */

static double reach(int stages) {
  return stages <= RKC3_MAX_STAGES ? reach_of_three(stages) : integrator_rkc2.reach(stages);
}

static Status step(const Rhs *rhs, int stages, double t, double h, const double *x0, const double *f0,
                   double *x1, double *work, Error *error) {
  const int n = rhs->n;
  if (stages > RKC3_MAX_STAGES) return integrator_rkc2.step(rhs, stages, t, h, x0, f0, x1, work, error);
  double b[RKC3_MAX_STAGES];
  double *before = work, *last = work + n, *f = work + 2 * n, *next = work + 3 * n;
  Status status = rkc3_weights(stages, b, error);
  if (status != STATUS_OK) return status;
  Stages recurrence = open_stages(stages);
  StageTerms terms = stages_next(&recurrence);
  memcpy(before, x0, (size_t)n * sizeof *before);
  stage_sum(&terms, h, n, x0, f0, NULL, NULL, NULL, last);
  for (int i = 0; i < n; i++) x1[i] = x0[i] + b[0] * h * f0[i];
  for (int j = 1; j < stages; j++) {
    status = rhs_stage(rhs, last, t, terms.time * h, f, error);
    if (status != STATUS_OK) return status;
    for (int i = 0; i < n; i++) x1[i] += b[j] * h * f[i];
    if (j == stages - 1) break;
    terms = stages_next(&recurrence);
    stage_sum(&terms, h, n, x0, f0, last, before, f, next);
    stages_turn(&before, &last, &next);
  }
  return STATUS_OK;
}

const Integrator integrator_rkc3 = {
    .name = "rkc3", .min_stages = RKC3_MIN_STAGES, .max_stages = 200, .reach = reach, .step = step};
