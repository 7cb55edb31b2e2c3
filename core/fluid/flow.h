/* Undisturbed flows: v_inf(x, t), dimensionless (lengths by a, time by 1/rate). */
#ifndef CAPSELLA_FLUID_FLOW_H
#define CAPSELLA_FLUID_FLOW_H

#include "base/broken_line.h"

/* A background flow is a function of (x, t) with its own parameters: linear flows are all that is needed
 * today. */
typedef struct Flow Flow;
struct Flow {
  void (*velocity)(const Flow *flow, const double x[3], double t, double v[3]);
  double gradient[3][3];    /* v_i = gradient[i][j] x_j, for the linear ones */
  double vorticity_axis[3]; /* unit; for a flow without vorticity the intermediate axis of strain */
  /* What the velocity is multiplied by: strength(t) cos(2 pi t / period). */
  BrokenLine strength; /* no points: 1 */
  double period;       /* 0: no oscillation */
};

/* v = gradient . x, steady */
void flow_linear(Flow *flow, const double gradient[3][3]);

double flow_factor(const Flow *flow, double t);

/* v [n][3] = v_inf at x [n][3] */
void flow_velocity(const Flow *flow, int n, const double *x, double t, double *v);

#endif
