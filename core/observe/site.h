/* A place on the membrane, by its angles to the axes of the capsule and of the flow. */
#ifndef CAPSELLA_OBSERVE_SITE_H
#define CAPSELLA_OBSERVE_SITE_H

#include "observe/shape.h"

/* Nothing but doubles, so that a restart keeps it as numbers. */
typedef struct {
  double X[3], x[3]; /* reference and current position */
  double angle_to_vorticity_deg, angle_to_major_axis_deg;
} Site;

/* The site at the current position x of the reference point X: angles from 0 to 90 degrees between the
 * vorticity axis (a unit vector) or the major axis e1 and the line from the centre of the capsule to x. */
Site site_measure(const Shape *shape, const double vorticity_axis[3], const double X[3], const double x[3]);

#endif
