#include "fluid/targets.h"

#include "base/array.h"

#include <math.h>
#include <stdbool.h>

/* The nodes in the order in which the elements hold them: what one target has brought into the cache, the
 * next one uses again. */
static Status order_nodes(const Mesh *mesh, int *node, Error *error) {
  Status status = STATUS_OK;
  bool *listed = NULL;
  TRY(ARRAY_NEW(&listed, mesh->n_nodes, error));
  int n = 0;
  for (int i = 0; i < 6 * mesh->n_elements; i++) {
    int p = mesh->element[i / 6][i % 6];
    if (!listed[p]) node[n++] = p;
    listed[p] = true;
  }
cleanup:
  array_free(listed);
  return status;
}

Status targets_new(Targets *targets, const Mesh *mesh, Error *error) {
  Status status = STATUS_OK;
  *targets = (Targets){.n = mesh->n_nodes};
  TRY(ARRAY_NEW(&targets->node, mesh->n_nodes, error));
  TRY(ARRAY_NEW(&targets->member, mesh->n_nodes, error));
  TRY(order_nodes(mesh, targets->node, error));
cleanup:
  return status;
}

/* Of each orbit the first member in the order of the targets: together they make up one part of the surface,
 * and few elements are near to any of them. */
void targets_use_symmetry(Targets *targets, const Symmetry *symmetry) {
  const Orbits *nodes = &symmetry->nodes;
  int n = 0;
  for (int o = 0; o < nodes->n; o++) targets->member[o] = -1;
  for (int i = 0; i < targets->n; i++) {
    int p = targets->node[i], *member = &targets->member[nodes->orbit[p]];
    if (*member >= 0) continue;
    *member = p;
    targets->node[n++] = p;
  }
  targets->n = n;
  targets->symmetry = symmetry;
}

void targets_free(Targets *targets) {
  array_free(targets->node);
  array_free(targets->member);
}

void targets_spread(const Targets *targets, double *u) {
  if (!targets->symmetry) return;
  const Orbits *nodes = &targets->symmetry->nodes;
  for (int o = 0; o < nodes->n; o++) {
    int p = targets->member[o], representative = nodes->representative[o];
    const double *sign = targets->symmetry->operation[nodes->operation[p]].sign;
    for (int c = 0; c < 3; c++) u[3 * representative + c] = sign[c] * u[3 * p + c];
  }
  symmetry_spread(targets->symmetry, u);
}

Status targets_check_finite(const char *what, int n_nodes, const double *values, Error *error) {
  for (int i = 0; i < 3 * n_nodes; i++) {
    if (!isfinite(values[i])) {
      return error_set(error, STATUS_REJECT, "single layer: %s of node %d is %g, not a finite number", what,
                       i / 3, values[i]);
    }
  }
  return STATUS_OK;
}

Status targets_check_elements(int degenerate, int n_nodes, Error *error) {
  if (degenerate == n_nodes) return STATUS_OK;
  return error_set(error, STATUS_REJECT, "single layer: an element at node %d is degenerate", degenerate);
}
