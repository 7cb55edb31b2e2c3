/* Quartic (P4) interpolation on the four elements that come from halving one (mesh.h): together they have the
 * 15 nodes of a triangle of order four, spaced evenly in its (xi, eta). */
#ifndef CAPSELLA_MESH_P4_H
#define CAPSELLA_MESH_P4_H

enum { P4_NODES = 15, P4_CHILDREN = 4 };

/* Where the nodes of the quartic triangle are among those of its children: node m, at xi = i/4 and eta = j/4,
 * counts i first.  A node that several children have is given once. */
typedef struct {
  unsigned char child, local; /* local node 0..5 of child 0..3 */
} P4Place;
void p4_places(P4Place place[P4_NODES]);

/* Gradients of the 15 shape functions at the point (xi, eta) of a child, by that child's own xi and eta. */
void p4_gradients(int child, double xi, double eta, double dN[P4_NODES][2]);

#endif
