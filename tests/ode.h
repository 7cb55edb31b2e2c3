/* Small differential equations with known solutions, for the tests of the integrators and of the stepper.
 * Each is an Rhs without context, or with one that the test owns. */
#ifndef CAPSELLA_TESTS_ODE_H
#define CAPSELLA_TESTS_ODE_H

#include "coupling/rhs.h"
#include <math.h>
#include <stdbool.h>

/* Non-autonomous, non-linear and coupled, with x(0) = (1, 0, 1):
 *   x' = (-2 t x_1, 2 t x_0, -cos(t) (x_0^2 + x_1^2) x_2),   x = (cos t^2, sin t^2, exp(-sin t)). */
static inline Status swing_evaluate(void *context, const double *x, double t, double dt, double *f,
                                    Error *error) {
  (void)context;
  (void)error;
  const double now = t + dt;
  f[0] = -2 * now * x[1];
  f[1] = 2 * now * x[0];
  f[2] = -cos(now) * (x[0] * x[0] + x[1] * x[1]) * x[2];
  return STATUS_OK;
}

static inline void swing_solution(double t, double x[3]) {
  x[0] = cos(t * t);
  x[1] = sin(t * t);
  x[2] = exp(-sin(t));
}

static inline Rhs swing(void) {
  return (Rhs){.n = 3, .evaluate = swing_evaluate};
}

static inline double largest_difference(int n, const double *a, const double *b) {
  double largest = 0;
  for (int i = 0; i < n; i++) largest = fmax(largest, fabs(a[i] - b[i]));
  return largest;
}

/* x_i' = rate[i] x_i */
typedef struct {
  int n;
  const double *rate;
} Decay;

static inline Status decay_evaluate(void *context, const double *x, double t, double dt, double *f,
                                    Error *error) {
  (void)t;
  (void)dt;
  (void)error;
  const Decay *decay = context;
  for (int i = 0; i < decay->n; i++) f[i] = decay->rate[i] * x[i];
  return STATUS_OK;
}

static inline Rhs decay_rhs(Decay *decay) {
  return (Rhs){.n = decay->n, .context = decay, .evaluate = decay_evaluate};
}

/* x' = 1 / (pi w (1 + ((t - 1)/w)^2)): all at once around t = 1. */
static inline Status pulse_evaluate(void *context, const double *x, double t, double dt, double *f,
                                    Error *error) {
  (void)x;
  (void)error;
  const double width = *(const double *)context, u = (t + dt - 1) / width;
  f[0] = 1 / (3.14159265358979323846 * width * (1 + u * u));
  f[1] = f[2] = 0;
  return STATUS_OK;
}

/* Counts evaluations, and answers with `code` in place of f at those numbered first .. last (from 1) or at
 * those beyond a time. */
typedef struct {
  Rhs inner;
  Status code;
  long first, last;
  double beyond; /* refuses t + dt > beyond; INFINITY: never */
  long calls;
  double earliest, latest; /* times asked for */
} Watch;

static inline Watch watch(Rhs inner) {
  return (Watch){.inner = inner, .beyond = INFINITY, .earliest = INFINITY, .latest = -INFINITY};
}

static inline Status watch_evaluate(void *context, const double *x, double t, double dt, double *f,
                                    Error *error) {
  Watch *w = context;
  w->calls++;
  w->earliest = fmin(w->earliest, t + dt);
  w->latest = fmax(w->latest, t + dt);
  if ((w->calls >= w->first && w->calls <= w->last) || t + dt > w->beyond)
    return error_set(error, w->code, "the door is closed");
  return w->inner.evaluate(w->inner.context, x, t, dt, f, error);
}

static inline Rhs watched(Watch *w) {
  return (Rhs){.n = w->inner.n, .context = w, .evaluate = watch_evaluate};
}

#endif
