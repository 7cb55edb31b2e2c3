/* Base vectors by quartic interpolation on the four elements that come from halving one (mesh/p4.h), in place
 * of that by the six nodes of each (docs/decisions/quartic.md). */
#ifndef CAPSELLA_MEMBRANE_QUARTIC_H
#define CAPSELLA_MEMBRANE_QUARTIC_H

#include "membrane/element_kernel.h"
#include "mesh/mesh.h"
#include "mesh/p4.h"

typedef struct {
  P4Place place[P4_NODES];
  double dN[P4_CHILDREN][P4_NODES][2 * RULE_POINTS]; /* by xi_alpha at rule point g: [2 g + alpha] */
} QuarticBasis;

void quartic_fill(QuarticBasis *basis);

/* Base vectors dx/dxi_alpha of an element in a lane of the block, from positions (or velocities) x
 * [n_nodes][3]. */
void quartic_base_vectors(const QuarticBasis *basis, const Mesh *mesh, int element, const double *x, int lane,
                          ElementBlock *block);

/* Forces at the 15 nodes from the tensions of an element in a lane of the block: what the virtual work of the
 * tensions is the product of with displacements interpolated alike. */
void quartic_force(const QuarticBasis *basis, int element, int lane, const ElementBlock *block,
                   double force[P4_NODES][3]);

#endif
