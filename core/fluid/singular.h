/* Elements that hold the target: polar quadrature about the node.
 *
 * Along a ray from the node a P2 element is exactly quadratic, y - x = r (t + r c), and the Jacobian r of the
 * polar map removes the singularity. */
#ifndef CAPSELLA_FLUID_SINGULAR_H
#define CAPSELLA_FLUID_SINGULAR_H

#include "base/status.h"
#include "fluid/gather.h"
#include "mesh/mesh.h"

typedef enum {
  POLAR_PARAMETRIC, /* Gauss points in the angle of the (xi, eta) plane */
  POLAR_TANGENT     /* Gauss points in the tangent plane, where 1/r is integrated exactly */
} PolarPlane;

typedef struct {
  PolarPlane plane;
  int n_radial, n_angular;
  int n_angular_long; /* POLAR_TANGENT: for triangles much longer than high as seen from the node */
} PolarScheme;

typedef struct SingularRule SingularRule;

Status singular_new(SingularRule **rule, const PolarScheme *scheme, Error *error);
void singular_free(SingularRule *rule);

/* Gathers the point forces of the elements around node p; x, q [n_nodes][3].  Returns the number of points,
 * or -1 when an element has no tangent plane at the node. */
int singular_gather(const SingularRule *rule, const Mesh *mesh, const double *x, const double *q, int p,
                    Gather *gather);

/* The points of the elements around many nodes, settled at one shape and used at others near to it, where
 * they are found at a fraction of the cost. */
typedef struct {
  const SingularRule *rule;
  const Mesh *mesh;
  const int *node; /* [n] */
  int *start;      /* [n + 1] of the elements around node i in the next two */
  int *first, *n;  /* place of an element's points in `offset`, and how many there are */
  double *offset;  /* s, t and weight of the points of each element */
} HeldPolar;

/* For a rule in the tangent plane.  The rule, the mesh and node [n] must outlive it. */
Status held_polar_new(HeldPolar *held, const SingularRule *rule, const Mesh *mesh, const int *node, int n,
                      Error *error);
void held_polar_free(HeldPolar *held);

/* Settles the points around node[i]; an element without a tangent plane there gets none. */
void held_polar_settle(HeldPolar *held, const double *x, int i);

/* As singular_gather for node[i], at positions near to those settled. */
int held_polar_gather(const HeldPolar *held, const double *x, const double *q, int i, Gather *gather);

#endif
