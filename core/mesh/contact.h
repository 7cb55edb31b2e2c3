/* How near a closed P2 surface comes to itself.
 *
 * Two parts of a surface that come near to each other across a film, of what is inside or of what is outside,
 * face each other: their outward normals point in opposite directions.  Looked for are nodes that have an
 * element across a film thinner than that element is wide, and the thinnest film relative to the width. Parts
 * that were less than three elements apart at rest are neighbours and not looked at: a narrow crest is no
 * contact, and on the 20 triangles of the icosahedron there is none. */
#ifndef CAPSELLA_MESH_CONTACT_H
#define CAPSELLA_MESH_CONTACT_H

#include "base/status.h"
#include "mesh/mesh.h"
#include <stdbool.h>

typedef struct ContactSearch ContactSearch;

typedef struct {
  double share; /* thickness of the film over the width of the element (its least height, the corners joined
                   by straight lines); INFINITY: no film is thinner than its elements are wide */
  double gap;   /* its thickness; INFINITY the same */
  int node, element; /* on its two sides; -1: none */
  double place[3];   /* its middle */
  bool crosses;      /* the surface crosses itself */
} Contact;

/* Only the sphere's nested mesh is known (mesh_sphere), which must outlive the search. */
Status contact_search_new(ContactSearch **search, const Mesh *mesh, Error *error);
void contact_search_free(ContactSearch *search);

/* At positions x [n_nodes][3].  Exact up to the error of the P2 surface and to where nodes are: the thinnest
 * place may lie between them. */
Contact contact_find(ContactSearch *search, const double *x);

#endif
