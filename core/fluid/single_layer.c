/* One evaluation: the tree of the surface, for each target what is far, pieces of the elements that are near
 * to any target, and for each target what is near.  Threads share elements and targets; each target is one
 * fixed sequence of sums. */
#include "fluid/single_layer.h"

#include "base/array.h"
#include "fluid/gather.h"
#include "fluid/singular.h"
#include "fluid/surface_tree.h"
#include "fluid/targets.h"
#include "fluid/walk.h"

#include <string.h>

typedef struct {
  TreeScheme tree;
  PolarScheme polar;
} Method;

static const Method METHODS[] = {
    [FLUID_DIRECT] = {{.rule_points = 12}, {POLAR_PARAMETRIC, 6, 6, 0}},
    [FLUID_FAST] = {{.rule_points = 6, .reach = 4.2, .far = 3.1, .rough = 2e-4}, {POLAR_TANGENT, 3, 8, 16}},
    [FLUID_REFERENCE] = {{.rule_points = 12, .reach = 4.2}, {POLAR_TANGENT, 4, 16, 16}},
};

struct SingleLayer {
  const Mesh *mesh;
  SingularRule *singular;
  SurfaceTree tree;
  Targets targets;
  NearElements *near; /* [targets] elements to be cut */
  char *wanted;       /* [n_elements] whether any target is near */
  KernelCount count;
};

Status single_layer_new(SingleLayer **out, const Mesh *mesh, FluidMethod method, Error *error) {
  Status status = STATUS_OK;
  SingleLayer *layer = NULL;
  TRY(ARRAY_NEW(&layer, 1, error));
  const Method *m = &METHODS[method];
  layer->mesh = mesh;
  TRY(singular_new(&layer->singular, &m->polar, error));
  TRY(tree_new(&layer->tree, mesh, &m->tree, error));
  TRY(targets_new(&layer->targets, mesh, error));
  TRY(ARRAY_NEW(&layer->near, mesh->n_nodes, error));
  TRY(ARRAY_NEW(&layer->wanted, mesh->n_elements, error));
  *out = layer;
  layer = NULL;
cleanup:
  single_layer_free(layer);
  return status;
}

void single_layer_use_symmetry(SingleLayer *layer, const Symmetry *symmetry) {
  targets_use_symmetry(&layer->targets, symmetry);
  tree_use_symmetry(&layer->tree, symmetry);
}

void single_layer_free(SingleLayer *layer) {
  if (!layer) return;
  singular_free(layer->singular);
  tree_free(&layer->tree);
  targets_free(&layer->targets);
  array_free(layer->near);
  array_free(layer->wanted);
  array_free(layer);
}

KernelCount single_layer_count(const SingleLayer *layer) {
  return layer->count;
}

/* What is far from target i: its part of u, but for the factor 1/(8 pi). */
static void sum_far(SingleLayer *layer, const double *x, const double *q, int i, double u[3],
                    WalkCount *count) {
  Gather gather;
  NearElements *near = &layer->near[i];
  gather_start(&gather, x + 3 * layer->targets.node[i]);
  walk_far(&layer->tree, x, q, layer->targets.node[i], &gather, near, count);
  gather_flush(&gather);
  for (int c = 0; c < 3; c++) u[c] = gather.u[c];
  for (int k = 0; k < near->n; k++) {
#pragma omp atomic write
    layer->wanted[near->element[k]] = 1;
  }
}

/* Adds the pieces of near elements and the elements around the node.  Returns the number of points around the
 * node, or -1 when an element has no tangent plane there. */
static int sum_near(const SingleLayer *layer, const double *x, const double *q, int i, double u[3],
                    WalkCount *count) {
  Gather gather;
  int p = layer->targets.node[i];
  gather_start(&gather, x + 3 * p);
  walk_near(&layer->tree, x, q, &layer->near[i], &gather, count);
  int singular = singular_gather(layer->singular, layer->mesh, x, q, p, &gather);
  gather_flush(&gather);
  for (int c = 0; c < 3; c++) u[c] = ONE_OVER_8PI * (u[c] + gather.u[c]);
  return singular;
}

/* Sums u at all targets.  Returns the first node around which an element is degenerate, or n_nodes. */
static int sum_targets(SingleLayer *layer, const double *x, const double *q, double *u) {
  int n_elements = layer->mesh->n_elements, degenerate = layer->mesh->n_nodes;
  long long far = 0, near = 0, singular = 0;
  memset(layer->wanted, 0, (size_t)n_elements);
#pragma omp parallel reduction(+ : far, near, singular) reduction(min : degenerate)
  {
    WalkCount count = {0, 0};
#pragma omp for schedule(dynamic, 16)
    for (int i = 0; i < layer->targets.n; i++)
      sum_far(layer, x, q, i, u + 3 * layer->targets.node[i], &count);
#pragma omp for schedule(dynamic, 16)
    for (int e = 0; e < n_elements; e++) {
      if (layer->wanted[e]) tree_cut(&layer->tree, e, x, q);
    }
#pragma omp for schedule(dynamic, 16)
    for (int i = 0; i < layer->targets.n; i++) {
      int p = layer->targets.node[i], points = sum_near(layer, x, q, i, u + 3 * p, &count);
      if (points >= 0) {
        singular += points;
      } else if (p < degenerate) {
        degenerate = p;
      }
    }
    far = count.far;
    near = count.near;
  }
  layer->count.far += far;
  layer->count.near += near;
  layer->count.singular += singular;
  return degenerate;
}

Status single_layer_evaluate(SingleLayer *layer, const double *x, const double *q, double *u, Error *error) {
  Status status = STATUS_OK;
  int n_nodes = layer->mesh->n_nodes;
  TRY(targets_check_finite("position", n_nodes, x, error));
  TRY(targets_check_finite("load", n_nodes, q, error));
  tree_update(&layer->tree, x, q);
  int degenerate = sum_targets(layer, x, q, u); /* its values are not used then */
  TRY(targets_check_elements(degenerate, n_nodes, error));
  targets_spread(&layer->targets, u);
  TRY(targets_check_finite("velocity", n_nodes, u, error));
cleanup:
  return status;
}
