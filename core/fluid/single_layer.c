/* One evaluation: the tree of the surface once, then for each target the way down the tree and the elements
 * around the node.  Threads share the targets; each target is one fixed sequence of sums. */
#include "fluid/single_layer.h"

#include "base/array.h"
#include "fluid/gather.h"
#include "fluid/singular.h"
#include "fluid/surface_tree.h"
#include "fluid/walk.h"

#include <math.h>
#include <stdbool.h>

static const double ONE_OVER_8PI = 0.039788735772973836;

typedef struct {
  TreeScheme tree;
  PolarScheme polar;
} Method;

static const Method METHODS[] = {
    [FLUID_DIRECT] = {{.rule_points = 12}, {POLAR_PARAMETRIC, 6, 6, 0}},
    [FLUID_FAST] = {{.rule_points = 6, .reach = 4.2, .far = 3.1, .rough = 5e-5}, {POLAR_TANGENT, 3, 8, 16}},
    [FLUID_REFERENCE] = {{.rule_points = 12, .reach = 4.2}, {POLAR_TANGENT, 4, 16, 16}},
};

struct SingleLayer {
  const Mesh *mesh;
  SingularRule *singular;
  SurfaceTree tree;
  int n_targets, *target;   /* [n_targets] nodes at which u is summed, neighbours near to each other */
  const Symmetry *symmetry; /* u at the other nodes is the image of u at these; NULL: none */
  KernelCount count;
};

/* The nodes in the order in which the elements hold them: what one target has brought into the cache, the
 * next one uses again. */
static Status order_targets(const Mesh *mesh, int *target, Error *error) {
  Status status = STATUS_OK;
  bool *listed = NULL;
  TRY(ARRAY_NEW(&listed, mesh->n_nodes, error));
  int n = 0;
  for (int i = 0; i < 6 * mesh->n_elements; i++) {
    int p = mesh->element[i / 6][i % 6];
    if (!listed[p]) target[n++] = p;
    listed[p] = true;
  }
cleanup:
  array_free(listed);
  return status;
}

Status single_layer_new(SingleLayer **out, const Mesh *mesh, FluidMethod method, Error *error) {
  Status status = STATUS_OK;
  SingleLayer *layer = NULL;
  TRY(ARRAY_NEW(&layer, 1, error));
  const Method *m = &METHODS[method];
  layer->mesh = mesh;
  TRY(singular_new(&layer->singular, &m->polar, error));
  TRY(tree_new(&layer->tree, mesh, &m->tree, error));
  TRY(ARRAY_NEW(&layer->target, mesh->n_nodes, error));
  layer->n_targets = mesh->n_nodes;
  TRY(order_targets(mesh, layer->target, error));
  *out = layer;
  layer = NULL;
cleanup:
  single_layer_free(layer);
  return status;
}

void single_layer_use_symmetry(SingleLayer *layer, const Symmetry *symmetry) {
  const Orbits *nodes = &symmetry->nodes;
  int n = 0;
  for (int i = 0; i < layer->n_targets; i++) {
    int p = layer->target[i];
    if (nodes->representative[nodes->orbit[p]] == p) layer->target[n++] = p;
  }
  layer->n_targets = n;
  layer->symmetry = symmetry;
}

void single_layer_free(SingleLayer *layer) {
  if (!layer) return;
  singular_free(layer->singular);
  tree_free(&layer->tree);
  array_free(layer->target);
  array_free(layer);
}

KernelCount single_layer_count(const SingleLayer *layer) {
  return layer->count;
}

static Status check_finite(const char *what, int n, const double *values, Error *error) {
  for (int i = 0; i < n; i++) {
    if (!isfinite(values[i])) {
      return error_set(error, STATUS_REJECT, "single layer: %s of node %d is %g, not a finite number", what,
                       i / 3, values[i]);
    }
  }
  return STATUS_OK;
}

/* u(x_p) into u; false when an element around the node has no tangent plane there. */
static bool evaluate_target(const SingleLayer *layer, const double *x, const double *q, int p, double u[3],
                            KernelCount *count) {
  Gather gather;
  WalkCount regular;
  gather_start(&gather, x + 3 * p);
  walk_gather(&layer->tree, x, q, p, &gather, &regular);
  int singular = singular_gather(layer->singular, layer->mesh, x, q, p, &gather);
  if (singular < 0) return false;
  gather_flush(&gather);
  for (int c = 0; c < 3; c++) u[c] = ONE_OVER_8PI * gather.u[c];
  *count = (KernelCount){.far = regular.far, .near = regular.near, .singular = singular};
  return true;
}

Status single_layer_evaluate(SingleLayer *layer, const double *x, const double *q, double *u, Error *error) {
  Status status = STATUS_OK;
  int n_nodes = layer->mesh->n_nodes;
  TRY(check_finite("position", 3 * n_nodes, x, error));
  TRY(check_finite("load", 3 * n_nodes, q, error));
  tree_update(&layer->tree, x, q);
  long long far = 0, near = 0, singular = 0;
  int degenerate = n_nodes; /* the first node where an element is degenerate */
#pragma omp parallel for schedule(dynamic, 16) reduction(+ : far, near, singular) reduction(min : degenerate)
  for (int i = 0; i < layer->n_targets; i++) {
    int p = layer->target[i];
    KernelCount count = {0, 0, 0};
    if (!evaluate_target(layer, x, q, p, u + 3 * p, &count) && p < degenerate) degenerate = p;
    far += count.far;
    near += count.near;
    singular += count.singular;
  }
  layer->count.far += far;
  layer->count.near += near;
  layer->count.singular += singular;
  if (degenerate < n_nodes) {
    return error_set(error, STATUS_REJECT, "single layer: an element at node %d is degenerate", degenerate);
  }
  if (layer->symmetry) symmetry_spread(layer->symmetry, u);
  TRY(check_finite("velocity", 3 * n_nodes, u, error));
cleanup:
  return status;
}
