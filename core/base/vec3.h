/* Small inline operations on vectors of three doubles. */
#ifndef CAPSELLA_BASE_VEC3_H
#define CAPSELLA_BASE_VEC3_H

#include <math.h>

static inline double vec3_dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static inline void vec3_cross(const double a[3], const double b[3], double c[3]) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}
static inline double vec3_norm(const double a[3]) {
  return sqrt(vec3_dot(a, a));
}
static inline void vec3_subtract(const double a[3], const double b[3], double c[3]) {
  for (int i = 0; i < 3; i++) c[i] = a[i] - b[i];
}
static inline double vec3_distance(const double a[3], const double b[3]) {
  double c[3];
  vec3_subtract(a, b, c);
  return vec3_norm(c);
}
/* Scales a to unit length; returns its length before. */
static inline double vec3_normalize(double a[3]) {
  double length = vec3_norm(a);
  for (int i = 0; i < 3; i++) a[i] /= length;
  return length;
}

#endif
