/* The ellipsoid of inertia, from moments of the enclosed volume by the divergence theorem. */
#include "observe/shape.h"

#include "base/vec3.h"
#include "linalg/eigen.h"
#include "mesh/surface.h"

#include <stdbool.h>

/* Below this D12 the direction of e1 is round-off. */
static const double ROUND_SHAPE = 1e-10;

/* Without the round-off that would take it off the planes of symmetry. */
static void mean_position(const Mesh *mesh, const Symmetry *symmetry, const double *x, double mean[3]) {
  for (int i = 0; i < 3; i++) mean[i] = 0.0;
  for (int p = 0; p < mesh->n_nodes; p++)
    for (int i = 0; i < 3; i++) mean[i] += x[3 * p + i] / mesh->n_nodes;
  for (int k = 0; symmetry && k < symmetry->n_operations; k++)
    for (int i = 0; i < 3; i++)
      if (symmetry->operation[k].sign[i] < 0) mean[i] = 0.0;
}

/* Moves second moments from the origin to the centre of the volume, at `center` from there. */
static void move_to_center(SurfaceMoments *moments, const double center[3]) {
  double *second = moments->second;
  for (int i = 0; i < 3; i++)
    for (int j = i; j < 3; j++) *second++ -= moments->volume * center[i] * center[j];
}

/* Unit vector along the part of v normal to `axis`; false when v lies along it. */
static bool project_out(const double v[3], const double axis[3], double unit[3]) {
  double along = vec3_dot(v, axis);
  for (int i = 0; i < 3; i++) unit[i] = v[i] - along * axis[i];
  return vec3_normalize(unit) > 1e-6;
}

/* Turns e1 into the half plane of angles (-pi/2, pi/2]; returns its angle. */
static double orient_major(const double vorticity_axis[3], double e1[3]) {
  static const double e_x[3] = {1.0, 0.0, 0.0}, e_y[3] = {0.0, 1.0, 0.0};
  double along[3], across[3];
  if (!project_out(e_x, vorticity_axis, along)) project_out(e_y, vorticity_axis, along);
  vec3_cross(along, vorticity_axis, across);
  double cosine = vec3_dot(e1, along), sine = vec3_dot(e1, across);
  if (cosine < 0.0 || (cosine == 0.0 && sine < 0.0)) {
    for (int i = 0; i < 3; i++) e1[i] = -e1[i];
    cosine = -cosine;
    sine = -sine;
  }
  return atan2(sine, cosine);
}

/* Names the principal axes, given with rising semi-axes. */
static void name_axes(const double semi_axis[3], double vector[3][3], const double vorticity_axis[3],
                      Shape *shape) {
  int third = 0;
  for (int k = 1; k < 3; k++)
    if (fabs(vec3_dot(vector[k], vorticity_axis)) > fabs(vec3_dot(vector[third], vorticity_axis))) third = k;
  int minor = third == 0 ? 1 : 0, major = third == 2 ? 1 : 2;
  double sense = vec3_dot(vector[third], vorticity_axis) < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 3; i++) {
    shape->e1[i] = vector[major][i];
    shape->e3[i] = sense * vector[third][i];
  }
  shape->L1 = 2.0 * semi_axis[major];
  shape->L2 = 2.0 * semi_axis[minor];
  shape->L3 = 2.0 * semi_axis[third];
  shape->D12 = (shape->L1 - shape->L2) / (shape->L1 + shape->L2);
  double angle = orient_major(vorticity_axis, shape->e1);
  shape->beta = shape->D12 < ROUND_SHAPE ? NAN : angle;
  vec3_cross(shape->e3, shape->e1, shape->e2);
}

Status shape_measure(const Mesh *mesh, const Symmetry *symmetry, const double *x,
                     const double vorticity_axis[3], Shape *shape, Error *error) {
  double origin[3], center[3], value[3], vector[3][3], semi_axis[3];
  mean_position(mesh, symmetry, x, origin); /* near the centre, so that moving the moments loses no digits */
  SurfaceMoments moments = surface_moments(mesh, symmetry, x, origin);
  for (int i = 0; i < 3; i++) {
    center[i] = moments.first[i] / moments.volume;
    shape->center[i] = origin[i] + center[i];
  }
  move_to_center(&moments, center);
  Status status = eigen_symmetric3(moments.second, value, vector, error);
  if (status != STATUS_OK) {
    error_prefix(error, "shape of the capsule: ");
    return status;
  }
  if (!(moments.volume > 0.0 && value[0] > 0.0))
    return error_set(
        error, STATUS_REJECT,
        "shape of the capsule: expected a positive volume and positive second moments, found %g and %g",
        moments.volume, value[0]);
  shape->volume = moments.volume;
  shape->area = surface_area(mesh, symmetry, x);
  for (int k = 0; k < 3; k++) semi_axis[k] = sqrt(5.0 * value[k] / moments.volume);
  name_axes(semi_axis, vector, vorticity_axis, shape);
  return STATUS_OK;
}
