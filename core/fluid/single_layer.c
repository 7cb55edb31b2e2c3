/* Orchestrates one evaluation: point forces of all elements once, then for each target the far ranges, the
 * near elements and the elements around the node.  Threads share the targets; each target is one fixed
 * sequence of sums. */
#include "fluid/single_layer.h"

#include "base/array.h"
#include "fluid/blocks.h"
#include "fluid/gather.h"
#include "fluid/near.h"
#include "fluid/oseen_kernel.h"
#include "fluid/piece_tree.h"
#include "fluid/singular.h"

#include <math.h>

static const double ONE_OVER_8PI = 0.039788735772973836;

typedef struct {
  int rule_points; /* of the rule on elements and on pieces of near ones */
  double reach;    /* of an element, in radii of gyration: see near.h */
  PolarScheme polar;
} Method;

static const Method METHODS[] = {
    [FLUID_DIRECT] = {12, 0, {POLAR_PARAMETRIC, 6, 6, 0}},
    [FLUID_FAST] = {6, 4.2, {POLAR_TANGENT, 3, 8, 16}},
    [FLUID_REFERENCE] = {12, 4.2, {POLAR_TANGENT, 4, 16, 16}},
};

struct SingleLayer {
  const Mesh *mesh;
  SingularRule *singular;
  PieceTree tree;
  Blocks blocks;
  int n_targets, *target;   /* [n_targets] nodes at which u is summed, neighbours near to each other */
  const Symmetry *symmetry; /* u at the other nodes is the image of u at these; NULL: none */
  OseenSources far;         /* [n_elements * tree.rule.n], element after element */
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
  TRY(piece_tree_new(&layer->tree, mesh, m->rule_points, m->reach, error));
  TRY(blocks_new(&layer->blocks, mesh->n_elements, error));
  TRY(ARRAY_NEW(&layer->target, mesh->n_nodes, error));
  layer->n_targets = mesh->n_nodes;
  TRY(order_targets(mesh, layer->target, error));
  for (int c = 0; c < 3; c++) {
    TRY(ARRAY_NEW(&layer->far.y[c], mesh->n_elements * m->rule_points, error));
    TRY(ARRAY_NEW(&layer->far.f[c], mesh->n_elements * m->rule_points, error));
  }
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
  piece_tree_free(&layer->tree);
  blocks_free(&layer->blocks);
  array_free(layer->target);
  for (int c = 0; c < 3; c++) {
    array_free(layer->far.y[c]);
    array_free(layer->far.f[c]);
  }
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

/* The point forces of an element once more, in line with those of the others. */
static void line_up(const SingleLayer *layer, int e) {
  const PieceTree *tree = &layer->tree;
  const OseenBlock *points = &tree->points[(size_t)e * tree->n_pieces * tree->rule.n_blocks];
  for (int c = 0; c < 3; c++) {
    double *y = layer->far.y[c] + e * tree->rule.n, *f = layer->far.f[c] + e * tree->rule.n;
    for (int i = 0; i < tree->rule.n; i++) {
      y[i] = points[i / OSEEN_LANES].y[c][i % OSEEN_LANES];
      f[i] = points[i / OSEEN_LANES].f[c][i % OSEEN_LANES];
    }
  }
}

/* Everything that the targets share. */
static void place_points(SingleLayer *layer, const double *x, const double *q) {
#pragma omp parallel for schedule(static)
  for (int b = 0; b < layer->blocks.n; b++) {
    int first = b * BLOCK_ELEMENTS, last = first + BLOCK_ELEMENTS;
    if (last > layer->mesh->n_elements) last = layer->mesh->n_elements;
    for (int e = first; e < last; e++) {
      piece_tree_update(&layer->tree, e, x, q);
      line_up(layer, e);
    }
    blocks_update(&layer->blocks, b, &layer->tree, first, last);
  }
}

static bool holds_node(const int element[6], int p) {
  for (int k = 0; k < 6; k++) {
    if (element[k] == p) return true;
  }
  return false;
}

/* One target: what is summed for it and what that cost. */
typedef struct {
  int p;
  const double *x, *q, *position;
  double u[3];
  KernelCount count;
  Gather gather;
} Target;

/* The elements of a block that is not far as a whole, but for those around the target. */
static void gather_block(const SingleLayer *layer, int block, Target *target) {
  int first = block * BLOCK_ELEMENTS, last = first + BLOCK_ELEMENTS;
  for (int e = first; e < last && e < layer->mesh->n_elements; e++) {
    if (holds_node(layer->mesh->element[e], target->p)) continue;
    bool is_near;
    int points = near_gather(&layer->tree, e, target->x, target->q, &target->gather, &is_near);
    *(is_near ? &target->count.near : &target->count.far) += points;
  }
}

static void sum_blocks(const SingleLayer *layer, int first_block, int last_block, Target *target) {
  int points = layer->tree.rule.n * BLOCK_ELEMENTS, all = layer->tree.rule.n * layer->mesh->n_elements;
  int first = first_block * points, last = last_block * points < all ? last_block * points : all;
  if (first >= last) return;
  oseen_sum(&layer->far, first, last, target->position, target->u);
  target->count.far += last - first;
}

/* Which of the blocks first .. first + n - 1 can be summed whole: those that are far and hold no element
 * around the target. */
static void scan_blocks(const SingleLayer *layer, const Target *target, int first, int n, int *far) {
  const Mesh *mesh = layer->mesh;
  blocks_scan(&layer->blocks, target->position, first, n, far);
  for (int i = mesh->node_start[target->p]; i < mesh->node_start[target->p + 1]; i++) {
    int b = mesh->node_element[i] / BLOCK_ELEMENTS - first;
    if (b >= 0 && b < n) far[b] = 0;
  }
}

/* All elements but those around the target: far blocks in ranges as long as possible. */
static void sum_regular(const SingleLayer *layer, Target *target) {
  enum { SCAN = 64 };
  int n_blocks = layer->blocks.n, summed = 0;
  for (int first = 0; first < n_blocks; first += SCAN) {
    int far[SCAN], n = n_blocks - first < SCAN ? n_blocks - first : SCAN;
    scan_blocks(layer, target, first, n, far);
    for (int i = 0; i < n; i++) {
      if (far[i]) continue;
      sum_blocks(layer, summed, first + i, target);
      gather_block(layer, first + i, target);
      summed = first + i + 1;
    }
  }
  sum_blocks(layer, summed, n_blocks, target);
}

/* u(x_p) into u; false when an element around the node has no tangent plane there. */
static bool evaluate_target(const SingleLayer *layer, const double *x, const double *q, int p, double u[3],
                            KernelCount *count) {
  Target target;
  target.p = p;
  target.x = x;
  target.q = q;
  target.position = x + 3 * p;
  target.count = (KernelCount){0, 0, 0};
  for (int c = 0; c < 3; c++) target.u[c] = 0;
  gather_start(&target.gather, target.position);
  sum_regular(layer, &target);
  int singular = singular_gather(layer->singular, layer->mesh, x, q, p, &target.gather);
  if (singular < 0) return false;
  gather_flush(&target.gather);
  for (int c = 0; c < 3; c++) u[c] = ONE_OVER_8PI * (target.u[c] + target.gather.u[c]);
  *count = target.count;
  count->singular = singular;
  return true;
}

Status single_layer_evaluate(SingleLayer *layer, const double *x, const double *q, double *u, Error *error) {
  Status status = STATUS_OK;
  int n_nodes = layer->mesh->n_nodes;
  TRY(check_finite("position", 3 * n_nodes, x, error));
  TRY(check_finite("load", 3 * n_nodes, q, error));
  place_points(layer, x, q);
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
