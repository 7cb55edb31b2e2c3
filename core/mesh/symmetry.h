/* Symmetry of a mesh and of a linear flow under changes of sign of the coordinates.
 *
 * The operations are S = diag(+-1, +-1, +-1): the identity, mirrors in the coordinate planes, half turns
 * about the coordinate axes and the inversion, eight in all, each its own inverse.  An operation belongs to a
 * mesh when it takes every node onto a node, bit for bit, and every element onto an element.  It belongs to
 * the flow v = G x when S G S = G, for then S v(x) = v(S x).  Operations that belong to both form a group,
 * and a capsule that starts with it keeps it: v(x) at one node of an orbit gives v at all of them,
 *
 *   v(S x) = S v(x),
 *
 * so that only one node of each orbit needs its velocity, and one element of each orbit its tensions.  Simple
 * shear keeps four operations (identity, inversion, and along the vorticity axis the mirror and the half
 * turn), planar hyperbolic flow all eight.
 *
 * This room finds the group, its permutations and its orbits.  Whether to use them is not decided here: it
 * suppresses all wrinkles that are not symmetric, and holds only for isotropic laws. */
#ifndef CAPSELLA_MESH_SYMMETRY_H
#define CAPSELLA_MESH_SYMMETRY_H

#include "base/status.h"
#include "mesh/mesh.h"

enum { SYMMETRY_MAX = 8 };

/* One operation and what it does to the mesh. */
typedef struct {
  double sign[3]; /* the diagonal of S */
  int *node;      /* [n_nodes] S takes node p onto node[p] */
  int *element;   /* [n_elements] S takes element e onto element[e] */
  /* [n_elements] and its local node k onto local node local[e][k] of that; an odd permutation of the corners
   * when S turns right hands into left ones. */
  unsigned char (*local)[6];
} SymmetryOperation;

/* Orbits of nodes or of elements: the classes of those that the operations take onto each other. */
typedef struct {
  int n;               /* number of orbits */
  int *representative; /* [n] the member with the lowest number; rising */
  int *size;           /* [n] number of members */
  int *orbit;          /* [n_nodes or n_elements] the orbit of each member */
  int *operation; /* the same: an operation that takes the representative onto the member; 0 for itself */
} Orbits;

typedef struct {
  int n_operations; /* 1, 2, 4 or 8; operation 0 is the identity */
  SymmetryOperation operation[SYMMETRY_MAX];
  Orbits nodes, elements;
} Symmetry;

/* The group of the mesh with its nodes at x [n_nodes][3] (finite) and of the flow gradient (v_i = G_ij x_j;
 * NULL: of the mesh alone). */
Status symmetry_find(Symmetry *symmetry, const Mesh *mesh, const double *x, const double gradient[3][3],
                     Error *error);

/* The group that holds nothing but the identity: every node and every element is its own orbit. */
Status symmetry_none(Symmetry *symmetry, const Mesh *mesh, Error *error);
void symmetry_free(Symmetry *symmetry);

/* Leaves the operations that keep a field of values at the elements [n_elements], bit for bit, which are a
 * group again; orbits and their numbers change. */
Status symmetry_keep_field(Symmetry *symmetry, const Mesh *mesh, const double *value, Error *error);

/* Makes a vector field [n_nodes][3] symmetric from its values at the representatives: components that an
 * operation would change there are set to zero, and the other members get their images. */
void symmetry_spread(const Symmetry *symmetry, double *field);

#endif
