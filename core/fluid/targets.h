/* The nodes at which a single layer is summed, in an order in which neighbours are near to each other; with a
 * symmetry one node of each orbit, and the others by reflection. */
#ifndef CAPSELLA_FLUID_TARGETS_H
#define CAPSELLA_FLUID_TARGETS_H

#include "base/status.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

/* In front of the single layer. */
static const double ONE_OVER_8PI = 0.039788735772973836;

typedef struct {
  int n, *node;             /* [n] */
  const Symmetry *symmetry; /* NULL: none */
  int *member;              /* [orbits] the target of each orbit */
} Targets;

/* All nodes. */
Status targets_new(Targets *targets, const Mesh *mesh, Error *error);
/* One node of each orbit from now on.  The symmetry must outlive the targets. */
void targets_use_symmetry(Targets *targets, const Symmetry *symmetry);
void targets_free(Targets *targets);

/* u [n_nodes][3] from the targets to all nodes. */
void targets_spread(const Targets *targets, double *u);

/* STATUS_REJECT with the first node at which `values` [n_nodes][3] is not finite; `what` names them. */
Status targets_check_finite(const char *what, int n_nodes, const double *values, Error *error);

/* STATUS_REJECT when `degenerate`, the first node around which an element is, is not n_nodes: none. */
Status targets_check_elements(int degenerate, int n_nodes, Error *error);

#endif
