#include "observe/site.h"

#include "base/vec3.h"
#include <math.h>
#include <string.h>

static const double DEGREES = 57.295779513082320877;

Site site_measure(const Shape *shape, const double vorticity_axis[3], const double X[3], const double x[3]) {
  Site site;
  double arm[3];
  memcpy(site.X, X, sizeof site.X);
  memcpy(site.x, x, sizeof site.x);
  vec3_subtract(x, shape->center, arm);
  const double length = vec3_norm(arm);
  site.angle_to_vorticity_deg = DEGREES * acos(fmin(fabs(vec3_dot(arm, vorticity_axis)) / length, 1));
  site.angle_to_major_axis_deg = DEGREES * acos(fmin(fabs(vec3_dot(arm, shape->e1)) / length, 1));
  return site;
}
