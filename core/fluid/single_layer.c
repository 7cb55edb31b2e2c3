/* Orchestrates one evaluation: point forces of all elements once, then for each target the far ranges, the
 * near elements and the elements around the node.  Threads share the targets; each target is one fixed
 * sequence of sums. */
#include "fluid/single_layer.h"

#include "base/array.h"
#include "base/vec3.h"
#include "fluid/blocks.h"
#include "fluid/near.h"
#include "fluid/oseen_kernel.h"
#include "fluid/pack.h"
#include "fluid/points_kernel.h"
#include "fluid/singular.h"
#include "mesh/p2.h"

#include <math.h>

static const double ONE_OVER_8PI = 0.039788735772973836;

typedef struct {
  int far_points, near_points; /* of the rules on whole elements and on pieces of near ones */
  double near_factor;
  PolarScheme polar;
} Method;

static const Method METHODS[] = {
    [FLUID_DIRECT] = {12, 12, 0, {6, 6, false}},
    [FLUID_FAST] = {6, 6, 0.75, {2, 8, true}},
    [FLUID_REFERENCE] = {12, 12, 0.75, {3, 12, true}},
};

struct SingleLayer {
  const Mesh *mesh;
  PieceRule far_rule;
  NearRule near;
  SingularRule *singular;
  Blocks blocks;
  OseenSources far; /* [n_elements * far_rule.n], element after element */
  KernelCount count;
};

static void piece_rule(PieceRule *rule, int n) {
  const TriangleRule *points = triangle_rule(n);
  rule->n = n;
  for (int g = 0; g < n; g++) {
    double dN[6][2];
    rule->weight[g] = points->weight[g];
    p2_values(points->point[g][0], points->point[g][1], rule->N[g]);
    p2_gradients(points->point[g][0], points->point[g][1], dN);
    for (int k = 0; k < 6; k++) {
      for (int i = 0; i < 2; i++) rule->dN[i][g][k] = dN[k][i];
    }
  }
}

Status single_layer_new(SingleLayer **out, const Mesh *mesh, FluidMethod method, Error *error) {
  Status status = STATUS_OK;
  SingleLayer *layer = NULL;
  TRY(ARRAY_NEW(&layer, 1, error));
  const Method *m = &METHODS[method];
  layer->mesh = mesh;
  piece_rule(&layer->far_rule, m->far_points);
  piece_rule(&layer->near.rule, m->near_points);
  layer->near.factor = m->near_factor;
  TRY(singular_new(&layer->singular, &m->polar, error));
  TRY(blocks_new(&layer->blocks, mesh, m->near_factor, error));
  for (int c = 0; c < 3; c++) {
    TRY(ARRAY_NEW(&layer->far.y[c], mesh->n_elements * m->far_points, error));
    TRY(ARRAY_NEW(&layer->far.f[c], mesh->n_elements * m->far_points, error));
  }
  *out = layer;
  layer = NULL;
cleanup:
  single_layer_free(layer);
  return status;
}

void single_layer_free(SingleLayer *layer) {
  if (!layer) return;
  singular_free(layer->singular);
  blocks_free(&layer->blocks);
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

/* Point forces of all elements by the far rule. */
static void place_far_points(SingleLayer *layer, const double *x, const double *q) {
  const Mesh *mesh = layer->mesh;
#pragma omp parallel for schedule(static)
  for (int first = 0; first < mesh->n_elements; first += PIECE_LANES) {
    PieceBatch batch = {0};
    int n = mesh->n_elements - first < PIECE_LANES ? mesh->n_elements - first : PIECE_LANES;
    for (int lane = 0; lane < n; lane++) {
      for (int k = 0; k < 6; k++) {
        int p = mesh->element[first + lane][k];
        for (int c = 0; c < 3; c++) {
          batch.node[k][c][lane] = x[3 * p + c];
          batch.node[k][c + 3][lane] = q[3 * p + c];
        }
      }
    }
    piece_points(&batch, n, &layer->far_rule, &layer->far, first * layer->far_rule.n);
  }
}

/* The point forces of one element that is far although its block is not. */
static void pack_far_element(const SingleLayer *layer, const double target[3], int e, PointPack *pack) {
  int n = layer->far_rule.n, first = e * n;
  pack_reserve(pack, n);
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < n; i++) {
      pack->points.y[c][pack->n + i] = layer->far.y[c][first + i] - target[c];
      pack->points.f[c][pack->n + i] = layer->far.f[c][first + i];
    }
  }
  pack->n += n;
}

static bool holds_node(const int element[6], int p) {
  for (int k = 0; k < 6; k++) {
    if (element[k] == p) return true;
  }
  return false;
}

static void pack_block(const SingleLayer *layer, const double *x, const double *q, int p, int block,
                       PointPack *pack, KernelCount *count) {
  const Mesh *mesh = layer->mesh;
  const double *target = x + 3 * p;
  int last = (block + 1) * BLOCK_ELEMENTS;
  for (int e = block * BLOCK_ELEMENTS; e < last && e < mesh->n_elements; e++) {
    const int *node = mesh->element[e];
    if (holds_node(node, p)) continue;
    if (blocks_may_be_near(&layer->blocks, e, target)) {
      double piece[6][6];
      for (int k = 0; k < 6; k++) {
        vec3_subtract(x + 3 * node[k], target, piece[k]);
        for (int c = 0; c < 3; c++) piece[k][c + 3] = q[3 * node[k] + c];
      }
      if (near_is_near(piece[0], piece[1], piece[2], layer->near.factor)) {
        count->near += near_pack(&layer->near, (const double(*)[6])piece, pack);
        continue;
      }
    }
    pack_far_element(layer, target, e, pack);
    count->far += layer->far_rule.n;
  }
}

/* Blocks that cannot be summed whole: those near the target and those that hold an element around it. */
enum { SCAN = 64 };

static void scan_blocks(const SingleLayer *layer, const double *target, int p, int first, int n, int *far) {
  const Mesh *mesh = layer->mesh;
  blocks_scan(&layer->blocks, target, first, n, far);
  for (int i = mesh->node_start[p]; i < mesh->node_start[p + 1]; i++) {
    int b = mesh->node_element[i] / BLOCK_ELEMENTS - first;
    if (b >= 0 && b < n) far[b] = 0;
  }
}

static void sum_range(const SingleLayer *layer, const double *target, int first_block, int last_block,
                      double u[3], KernelCount *count) {
  int points = layer->far_rule.n * BLOCK_ELEMENTS, all = layer->far_rule.n * layer->mesh->n_elements;
  int first = first_block * points, last = last_block * points < all ? last_block * points : all;
  if (first >= last) return;
  oseen_sum(&layer->far, first, last, target, u);
  count->far += last - first;
}

/* u(x_p) but for the factor 1/(8 pi); false when an element around the node has no tangent plane there. */
static bool evaluate_target(const SingleLayer *layer, const double *x, const double *q, int p, double u[3],
                            KernelCount *count) {
  const double *target = x + 3 * p;
  PointPack pack;
  pack_start(&pack);
  for (int c = 0; c < 3; c++) u[c] = 0;
  int range = 0; /* first block of the range of far blocks not yet summed */
  for (int first = 0; first < layer->blocks.n_blocks; first += SCAN) {
    int far[SCAN], n = layer->blocks.n_blocks - first < SCAN ? layer->blocks.n_blocks - first : SCAN;
    scan_blocks(layer, target, p, first, n, far);
    for (int i = 0; i < n; i++) {
      if (far[i]) continue;
      sum_range(layer, target, range, first + i, u, count);
      range = first + i + 1;
      pack_block(layer, x, q, p, first + i, &pack, count);
    }
  }
  sum_range(layer, target, range, layer->blocks.n_blocks, u, count);
  int singular = singular_pack(layer->singular, layer->mesh, x, q, p, &pack);
  if (singular < 0) return false;
  count->singular += singular;
  pack_flush(&pack);
  for (int c = 0; c < 3; c++) u[c] += pack.u[c];
  return true;
}

Status single_layer_evaluate(SingleLayer *layer, const double *x, const double *q, double *u, Error *error) {
  Status status = STATUS_OK;
  int n_nodes = layer->mesh->n_nodes;
  TRY(check_finite("position", 3 * n_nodes, x, error));
  TRY(check_finite("load", 3 * n_nodes, q, error));
  blocks_update(&layer->blocks, layer->mesh, x);
  place_far_points(layer, x, q);
  long long far = 0, near = 0, singular = 0;
  int degenerate = n_nodes; /* the first node where an element is degenerate */
#pragma omp parallel for schedule(dynamic, 16) reduction(+ : far, near, singular) reduction(min : degenerate)
  for (int p = 0; p < n_nodes; p++) {
    KernelCount count = {0, 0, 0};
    if (!evaluate_target(layer, x, q, p, u + 3 * p, &count) && p < degenerate) degenerate = p;
    for (int c = 0; c < 3; c++) u[3 * p + c] *= ONE_OVER_8PI;
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
  TRY(check_finite("velocity", 3 * n_nodes, u, error));
cleanup:
  return status;
}
