#include "coupling/stages.h"

#include <math.h>

static Chebyshev chebyshev_next(double w, Chebyshev last, Chebyshev before) {
  return (Chebyshev){
      .T = 2 * w * last.T - before.T,
      .dT = 2 * w * last.dT - before.dT + 2 * last.T,
      .d2T = 2 * w * last.d2T - before.d2T + 4 * last.dT,
  };
}

Chebyshev chebyshev(int j, double w) {
  Chebyshev before = {1, 0, 0}, last = {w, 1, 0};
  for (int i = 2; i <= j; i++) {
    const Chebyshev next = chebyshev_next(w, last, before);
    before = last;
    last = next;
  }
  return last;
}

Stages stages_open(double w0, int end) {
  const Chebyshev at_end = chebyshev(end, w0), C2 = chebyshev(2, w0);
  const double b = C2.d2T / (C2.dT * C2.dT); /* b_0 = b_1 = b_2 */
  return (Stages){.w0 = w0, .w1 = at_end.dT / at_end.d2T, .C_before = {1, 0, 0}, .b_before = b, .b_last = b};
}

static StageTerms first_stage(Stages *s) {
  s->C_last = (Chebyshev){s->w0, 1, 0};
  s->a_last = 1 - s->b_last * s->w0;
  return (StageTerms){.x0 = 1, .f0 = s->b_last * s->w1, .time = s->b_last * s->w1};
}

StageTerms stages_next(Stages *s) {
  if (++s->j == 1) return first_stage(s);
  const Chebyshev C = chebyshev_next(s->w0, s->C_last, s->C_before);
  const double b = C.d2T / (C.dT * C.dT);
  const double mu = 2 * b * s->w0 / s->b_last, nu = -b / s->b_before, f = 2 * b * s->w1 / s->b_last;
  const StageTerms terms = {.x0 = 1 - mu - nu,
                            .last = mu,
                            .before = nu,
                            .f = f,
                            .f0 = -s->a_last * f,
                            .time = fmin(s->w1 * C.d2T / C.dT, 1)};
  s->C_before = s->C_last;
  s->C_last = C;
  s->b_before = s->b_last;
  s->b_last = b;
  s->a_last = 1 - b * C.T;
  return terms;
}

void stage_sum(const StageTerms *terms, double h, int n, const double *x0, const double *f0,
               const double *last, const double *before, const double *f, double *next) {
  const StageTerms c = *terms;
  if (c.last == 0) { /* the first stage: there is none before */
    for (int i = 0; i < n; i++) next[i] = x0[i] + c.f0 * h * f0[i];
    return;
  }
  for (int i = 0; i < n; i++)
    next[i] = c.x0 * x0[i] + c.last * last[i] + c.before * before[i] + c.f * h * f[i] + c.f0 * h * f0[i];
}

void stages_turn(double **before, double **last, double **next) {
  double *free_array = *before;
  *before = *last;
  *last = *next;
  *next = free_array;
}
