/* Maps of the places where criteria rupture a capsule: on the sphere at rest, and on the deformed capsule. */
#ifndef CAPSELLA_STUDY_SITES_H
#define CAPSELLA_STUDY_SITES_H

#include "study/runner.h"

typedef struct {
  const char *name;
  double X[3], x[3]; /* NAN: not known, the site is left out */
} SiteMark;

/* Writes FOLDER/sites_reference[SUFFIX].svg and sites_capsule[SUFFIX].svg: the last state of `item`, with the
 * marks and, as a sphere in a linear flow is its own image there, their images under inversion. */
Status sites_write(const Case *item, const SiteMark *marks, size_t n, const char *folder, const char *suffix,
                   Error *error);

/* A name for the part of the capsule that a site is in: "vorticity_axis" and "major_tip" within 20 degrees of
 * these axes, "shear_plane" within 20 degrees of the plane, "elsewhere"; "" when an angle is not known. */
const char *site_region(double angle_to_vorticity_deg, double angle_to_major_axis_deg);

#endif
