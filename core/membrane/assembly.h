/* Sums over the elements around a node when only one element of each orbit is computed (mesh/symmetry.h): the
 * others are its images. */
#ifndef CAPSELLA_MEMBRANE_ASSEMBLY_H
#define CAPSELLA_MEMBRANE_ASSEMBLY_H

#include "base/status.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

/* An element of the mesh as the image of a computed one. */
typedef struct {
  int orbit;     /* place of the computed element */
  int operation; /* what takes that element onto this one */
  unsigned char
      local[6]; /* local node k of this element is the image of local node local[k] of the computed one */
} ElementImage;

ElementImage assembly_image(const Symmetry *symmetry, int element);

/* One term of the sum at a node: the value of local node `local` of a computed element, turned by an
 * operation. */
typedef struct {
  int orbit;
  unsigned char local, operation;
} AssemblyTerm;

/* Terms at the first node of orbit i: start[i] .. start[i + 1] - 1, in rising element order. */
typedef struct {
  const Symmetry *symmetry;
  int *start;
  AssemblyTerm *term;
} Assembly;

Status assembly_new(Assembly *assembly, const Mesh *mesh, const Symmetry *symmetry, Error *error);
void assembly_free(Assembly *assembly);

/* R [n_nodes][3] from element forces [18][n_orbits] (component 3 * local + c), at one node of each orbit and,
 * by their images, at all.  The order of each sum is fixed. */
void assembly_sum(const Assembly *assembly, const double *element_force, double *R);

#endif
