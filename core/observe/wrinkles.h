/* Waves on the scale of the mesh: how far the corners of the elements are off the smooth surface through
 * their surroundings. */
#ifndef CAPSELLA_OBSERVE_WRINKLES_H
#define CAPSELLA_OBSERVE_WRINKLES_H

#include "base/status.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

typedef struct Wrinkles Wrinkles;

/* For positions with the symmetry; both must outlive the wrinkles. */
Status wrinkles_new(Wrinkles **wrinkles, const Mesh *mesh, const Symmetry *symmetry, Error *error);
void wrinkles_free(Wrinkles *wrinkles);

/* Root mean square, over the corners, of the distance along the normal between a corner at x [n_nodes][3] and
 * the smooth surface there: the motion of the nodes within two mean edges of it at rest, fitted with least
 * squares by a polynomial of the place at rest, linear in space and quadratic along the sphere.
 *
 * An affine motion, thus an ellipsoid, has none.  Of waves up to one and a half edges long all is seen within
 * a tenth, of waves two edges long 0.4, three: 0.1, six: 0.02.  A smooth motion leaves what the fit misses,
 * of the third order in the size of the elements. */
double wrinkles_amplitude(const Wrinkles *wrinkles, const double *x);

#endif
