#include "fluid/coarse_layer.h"

#include "base/array.h"
#include "fluid/coarse_kernel.h"
#include "fluid/gather.h"
#include "fluid/singular.h"
#include "fluid/surface_tree.h"
#include "fluid/targets.h"
#include "fluid/walk.h"

#include <stdbool.h>

/* No element is cut: one next to the target gives the largest error, a few 1e-4. */
static const TreeScheme TREE = {.rule_points = 6, .reach = 0, .far = 1.5, .rough = 5e-3};
static const PolarScheme POLAR = {POLAR_TANGENT, 2, 4, 8};

struct CoarseLayer {
  const Mesh *mesh;
  Targets targets;
  SingularRule *singular;
  HeldPolar around; /* points on the elements of each target */
  SurfaceTree tree;
  CoarseBlock *blocks; /* [tree.n_blocks] those of the tree, rounded */
  HeldRuns *held;      /* [n_nodes], of which one for each target: what stands for all but its own elements */
  bool is_settled;     /* held[] and `around` belong to the step */
  KernelCount count;
};

Status coarse_layer_new(CoarseLayer **out, const Mesh *mesh, const Symmetry *symmetry, Error *error) {
  Status status = STATUS_OK;
  CoarseLayer *layer = NULL;
  TRY(ARRAY_NEW(&layer, 1, error));
  layer->mesh = mesh;
  TRY(targets_new(&layer->targets, mesh, error));
  TRY(singular_new(&layer->singular, &POLAR, error));
  TRY(tree_new(&layer->tree, mesh, &TREE, error));
  if (symmetry) {
    targets_use_symmetry(&layer->targets, symmetry);
    tree_use_symmetry(&layer->tree, symmetry);
  }
  TRY(held_polar_new(&layer->around, layer->singular, mesh, layer->targets.node, layer->targets.n, error));
  TRY(ARRAY_NEW(&layer->blocks, layer->tree.n_blocks, error));
  TRY(ARRAY_NEW(&layer->held, mesh->n_nodes, error));
  *out = layer;
  layer = NULL;
cleanup:
  coarse_layer_free(layer);
  return status;
}

void coarse_layer_free(CoarseLayer *layer) {
  if (!layer) return;
  for (int i = 0; layer->held && i < layer->mesh->n_nodes; i++) array_free(layer->held[i].run);
  held_polar_free(&layer->around);
  targets_free(&layer->targets);
  singular_free(layer->singular);
  tree_free(&layer->tree);
  array_free(layer->blocks);
  array_free(layer->held);
  array_free(layer);
}

KernelCount coarse_layer_count(const CoarseLayer *layer) {
  return layer->count;
}

static void hold_target(CoarseLayer *layer, const double *x, const double *q, int i) {
  Gather gather;
  NearElements none;
  WalkCount count = {0, 0};
  int p = layer->targets.node[i];
  HeldRuns *held = &layer->held[i];
  gather_start(&gather, x + 3 * p);
  gather.held = held;
  held->blocks = layer->tree.blocks;
  held->n = 0;
  held->status = STATUS_OK;
  walk_far(&layer->tree, x, q, p, &gather, &none, &count);
  gather_flush(&gather);
}

static Status hold_all(CoarseLayer *layer, const double *x, const double *q, Error *error) {
#pragma omp parallel for schedule(dynamic, 16)
  for (int i = 0; i < layer->targets.n; i++) {
    hold_target(layer, x, q, i);
    held_polar_settle(&layer->around, x, i);
  }
  for (int i = 0; i < layer->targets.n; i++) {
    if (layer->held[i].status != STATUS_OK) {
      return error_set(error, STATUS_MEMORY, "out of memory: the coarse layer lists what acts on node %d",
                       layer->targets.node[i]);
    }
  }
  layer->is_settled = true;
  return STATUS_OK;
}

void coarse_layer_settle(CoarseLayer *layer) {
  layer->is_settled = false;
}

/* Returns the number of points around the node, or -1 when an element has no tangent plane there. */
static int sum_target(const CoarseLayer *layer, const double *x, const double *q, int i, double u[3]) {
  Gather gather;
  int p = layer->targets.node[i];
  gather_start(&gather, x + 3 * p);
  int singular = held_polar_gather(&layer->around, x, q, i, &gather);
  gather_flush(&gather);
  coarse_sum(layer->blocks, layer->held[i].run, layer->held[i].n, x + 3 * p, gather.u);
  for (int c = 0; c < 3; c++) u[c] = ONE_OVER_8PI * gather.u[c];
  return singular;
}

/* Returns the first node around which an element is degenerate, or n_nodes. */
static int sum_targets(CoarseLayer *layer, const double *x, const double *q, double *u) {
  int degenerate = layer->mesh->n_nodes;
  long long far = 0, singular = 0;
#pragma omp parallel reduction(+ : far, singular) reduction(min : degenerate)
  {
#pragma omp for schedule(static)
    for (int k = 0; k < layer->tree.n_blocks; k++) coarse_round(&layer->tree.blocks[k], 1, &layer->blocks[k]);
#pragma omp for schedule(dynamic, 16)
    for (int i = 0; i < layer->targets.n; i++) {
      int p = layer->targets.node[i], points = sum_target(layer, x, q, i, u + 3 * p);
      const HeldRuns *held = &layer->held[i];
      for (int k = 0; k < held->n; k++) far += OSEEN_LANES * held->run[k].n;
      if (points >= 0) {
        singular += points;
      } else if (p < degenerate) {
        degenerate = p;
      }
    }
  }
  layer->count.far += far;
  layer->count.singular += singular;
  return degenerate;
}

Status coarse_layer_evaluate(CoarseLayer *layer, const double *x, const double *q, double *u, Error *error) {
  Status status = STATUS_OK;
  int n_nodes = layer->mesh->n_nodes;
  TRY(targets_check_finite("position", n_nodes, x, error));
  TRY(targets_check_finite("load", n_nodes, q, error));
  tree_update(&layer->tree, x, q);
  if (!layer->is_settled) TRY(hold_all(layer, x, q, error));
  int degenerate = sum_targets(layer, x, q, u);
  TRY(targets_check_elements(degenerate, n_nodes, error));
  targets_spread(&layer->targets, u);
  TRY(targets_check_finite("velocity", n_nodes, u, error));
cleanup:
  return status;
}
