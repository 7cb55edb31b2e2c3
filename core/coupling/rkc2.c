#include "coupling/rkc2.h"

#include <string.h>

static const double DAMPING = 2.0 / 13;

/* Chebyshev polynomial T_j at w and its first two derivatives, by the three-term recurrence. */
typedef struct {
  double T, dT, d2T;
} Chebyshev;

static Chebyshev chebyshev_next(double w, Chebyshev last, Chebyshev before) {
  return (Chebyshev){
      .T = 2 * w * last.T - before.T,
      .dT = 2 * w * last.dT - before.dT + 2 * last.T,
      .d2T = 2 * w * last.d2T - before.d2T + 4 * last.dT,
  };
}

static Chebyshev chebyshev(int j, double w) {
  Chebyshev before = {1, 0, 0}, last = {w, 1, 0};
  for (int i = 2; i <= j; i++) {
    const Chebyshev next = chebyshev_next(w, last, before);
    before = last;
    last = next;
  }
  return last;
}

static double shift(int stages) {
  return 1 + DAMPING / ((double)stages * stages);
}

static double reach(int stages) {
  const Chebyshev p = chebyshev(stages, shift(stages));
  return (1 + shift(stages)) * p.d2T / p.dT;
}

/* The recurrence of the source (eq. 2.1):
 *   Y_0 = x0,  Y_1 = Y_0 + m~_1 h F_0,
 *   Y_j = (1 - m_j - n_j) Y_0 + m_j Y_{j-1} + n_j Y_{j-2} + m~_j h F_{j-1} + g~_j h F_0,   x1 = Y_s. */
static Status step(const Rhs *rhs, int stages, double t, double h, const double *x0, const double *f0,
                   double *x1, double *work, Error *error) {
  const int n = rhs->n;
  double *before = work, *last = work + n, *f = work + 2 * n, *next = x1;
  const double w0 = shift(stages);
  const Chebyshev top = chebyshev(stages, w0), C2 = chebyshev(2, w0);
  const double w1 = top.dT / top.d2T;

  Chebyshev C_before = {1, 0, 0}, C_last = {w0, 1, 0};
  double b_before = C2.d2T / (C2.dT * C2.dT), b_last = b_before; /* b_0 = b_1 = b_2 */
  double a_last = 1 - b_last * w0;
  double c_last = w1 * C2.d2T / C2.dT / (4 * w0); /* time of stage 1 */

  memcpy(before, x0, (size_t)n * sizeof *before);
  for (int i = 0; i < n; i++) last[i] = x0[i] + b_last * w1 * h * f0[i];
  for (int j = 2; j <= stages; j++) {
    const Status status = rhs_stage(rhs, last, t, c_last * h, f, error);
    if (status != STATUS_OK) return status;
    const Chebyshev C = chebyshev_next(w0, C_last, C_before);
    const double b = C.d2T / (C.dT * C.dT);
    const double mu = 2 * b * w0 / b_last, nu = -b / b_before;
    const double mu_h = 2 * b * w1 / b_last * h, gamma_h = -a_last * mu_h;
    for (int i = 0; i < n; i++)
      next[i] = (1 - mu - nu) * x0[i] + mu * last[i] + nu * before[i] + mu_h * f[i] + gamma_h * f0[i];
    double *free_array = before;
    before = last;
    last = next;
    next = free_array;
    C_before = C_last;
    C_last = C;
    b_before = b_last;
    b_last = b;
    a_last = 1 - b * C.T;
    c_last = w1 * C.d2T / C.dT;
  }
  if (last != x1) memcpy(x1, last, (size_t)n * sizeof *x1);
  return STATUS_OK;
}

const Integrator integrator_rkc2 = {
    .name = "rkc2", .min_stages = 2, .max_stages = 200, .reach = reach, .step = step};
