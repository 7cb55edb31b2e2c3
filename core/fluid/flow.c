/* Linear background flows.  The kinds that a scene names are all linear: config/ fills in their gradient. */
#include "fluid/flow.h"

#include "base/vec3.h"
#include "linalg/eigen.h"

#include <math.h>
#include <string.h>

/* Below this fraction of the gradient the vorticity is round-off. */
static const double VORTICITY_NOISE = 1e-12;

static const double PI = 3.14159265358979323846;

static void linear_velocity(const Flow *flow, const double x[3], double t, double v[3]) {
  (void)t;
  for (int i = 0; i < 3; i++) v[i] = vec3_dot(flow->gradient[i], x);
}

/* Turns a unit vector so that its largest component is positive. */
static void point_forward(double axis[3]) {
  int largest = 0;
  for (int i = 1; i < 3; i++) {
    if (fabs(axis[i]) > fabs(axis[largest])) largest = i;
  }
  if (axis[largest] >= 0) return;
  for (int i = 0; i < 3; i++) axis[i] = -axis[i];
}

static void strain_axis(const double G[3][3], double axis[3]) {
  const double strain[6] = {G[0][0], 0.5 * (G[0][1] + G[1][0]), 0.5 * (G[0][2] + G[2][0]),
                            G[1][1], 0.5 * (G[1][2] + G[2][1]), G[2][2]};
  double value[3], vector[3][3];
  Error ignored;
  if (eigen_symmetric3(strain, value, vector, &ignored) == STATUS_OK) {
    memcpy(axis, vector[1], sizeof vector[1]);
  } else { /* a gradient that is not finite: any axis will do */
    memcpy(axis, (const double[3]){0, 1, 0}, 3 * sizeof(double));
  }
  point_forward(axis);
}

void flow_linear(Flow *flow, const double gradient[3][3]) {
  *flow = (Flow){.velocity = linear_velocity};
  memcpy(flow->gradient, gradient, sizeof flow->gradient);
  const double(*G)[3] = gradient;
  double size = 0;
  for (int i = 0; i < 3; i++) size += vec3_dot(G[i], G[i]);
  double *axis = flow->vorticity_axis;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    axis[i] = G[k][j] - G[j][k];
  }
  if (vec3_norm(axis) > VORTICITY_NOISE * sqrt(size)) {
    vec3_normalize(axis);
  } else {
    strain_axis(G, axis);
  }
}

double flow_factor(const Flow *flow, double t) {
  const double strength = flow->strength.n > 0 ? broken_line_value(flow->strength, t) : 1;
  return flow->period > 0 ? strength * cos(2 * PI * t / flow->period) : strength;
}

void flow_velocity(const Flow *flow, int n, const double *x, double t, double *v) {
  const double factor = flow_factor(flow, t);
  for (int p = 0; p < n; p++) flow->velocity(flow, x + 3 * p, t, v + 3 * p);
  for (int i = 0; i < 3 * n; i++) v[i] *= factor;
}
