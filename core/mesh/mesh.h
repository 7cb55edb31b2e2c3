/* The surface mesh: curved triangles with six nodes (P2), and who touches whom.
 *
 * A mesh is topology and the reference positions X; the current positions x are somebody else's array of the
 * same shape.  Normals of element (0,1,2) point outward. */
#ifndef CAPSELLA_MESH_MESH_H
#define CAPSELLA_MESH_MESH_H

#include "base/status.h"

typedef struct {
  int subdivisions;  /* of the icosahedron */
  int n_nodes;       /* 10 * 4^n * 4 + 2 */
  int n_vertices;    /* corner nodes come first: 0 .. n_vertices-1 */
  int n_elements;    /* 20 * 4^n */
  double *X;         /* [n_nodes][3] reference positions */
  int (*element)[6]; /* [n_elements]: corners 0 1 2, then mid-edge nodes of edges 01, 12, 20 */
  /* Elements around a node: entries node_start[p] .. node_start[p+1]-1 of the two tables, in rising element
   * order. */
  int *node_start;   /* [n_nodes + 1] */
  int *node_element; /* [6 * n_elements] element */
  int *node_local;   /* [6 * n_elements] local index (0..5) of the node in that element */
} Mesh;

/* Rotation of the whole mesh about an axis through the centre, for mesh-independence studies. */
typedef struct {
  double axis[3]; /* any length but zero */
  double angle;   /* radians; 0: the 2-fold axes of the icosahedron lie on x, y, z */
} MeshRotation;

/* Unit sphere from an icosahedron halved `subdivisions` (0..7) times, all six nodes of each element on the
 * sphere. `rotation` may be NULL. */
Status mesh_sphere(Mesh *mesh, int subdivisions, const MeshRotation *rotation, Error *error);
void mesh_free(Mesh *mesh);

/* Makes the mesh of a sphere irregular: corners move on it by random shifts of up to `share` (at most 0.3) of
 * the mean edge in each direction of space, mid-edge nodes stay halfway between them.  The same seed gives
 * the same mesh. */
void mesh_jitter(Mesh *mesh, double share, int seed);

/* Checks that the surface is closed (each edge in two elements, opposite senses), of Euler number 2, and
 * outward. */
Status mesh_check(const Mesh *mesh, Error *error);

/* Mean length of the element edges (chord between corners) at positions x [n_nodes][3]. */
double mesh_edge_length(const Mesh *mesh, const double *x);

#endif
