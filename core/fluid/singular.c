/* Each element as a polynomial about the node, and the polar points that fit its shape there. */
#include "fluid/singular.h"

#include "base/array.h"
#include "base/vec3.h"
#include "fluid/piece.h"
#include "fluid/polar_kernel.h"
#include "mesh/p2.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* |a1 x a2| / (|a1|^2 + |a2|^2) is 0 for an element squashed to a line, 0.43 for an equilateral one. */
static const double DEGENERATE = 1e-10;

/* Range of w (polar_kernel.h) from which on a triangle counts as long: an equilateral one has 1.1 as seen
 * from a corner, 2.1 as seen from the middle of an edge. */
static const double LONG_RANGE = 3.5;

struct SingularRule {
  PolarPlane plane;
  PolarGauss gauss, gauss_long;
  OffsetPoints parametric[6]; /* for each local node */
  int n_parametric[6];        /* of which this many are points */
  double expand[6][6][6];     /* [local node][coefficient][node]: expansion about a local node */
};

/* Parametric corners of the triangles with their apex at each local node: one or two. */
static const int OPPOSITE[6][3] = {{1, 2, -1}, {2, 0, -1}, {0, 1, -1}, {1, 2, 0}, {2, 0, 1}, {0, 1, 2}};

static void fill_expansions(SingularRule *rule) {
  /* d2/dxi2, d2/dxi deta, d2/deta2 of the shape functions */
  static const double second[3][6] = {{4, 4, 0, -8, 0, 0}, {4, 0, 0, -4, 4, -4}, {4, 0, 4, 0, 0, -8}};
  for (int local = 0; local < 6; local++) {
    double dN[6][2];
    p2_gradients(p2_node[local][0], p2_node[local][1], dN);
    double(*expand)[6] = rule->expand[local];
    expand[0][local] = 1;
    for (int k = 0; k < 6; k++) {
      expand[1][k] = dN[k][0];
      expand[2][k] = dN[k][1];
      expand[3][k] = second[0][k] / 2;
      expand[4][k] = second[1][k];
      expand[5][k] = second[2][k] / 2;
    }
  }
}

static void fill_parametric(SingularRule *rule) {
  static const double metric[3] = {1, 0, 1};
  for (int local = 0; local < 6; local++) {
    PolarPoint polar[POLAR_MAX_POINTS];
    OffsetPoints *points = &rule->parametric[local];
    int n = polar_points(&rule->gauss, local, metric, polar);
    rule->n_parametric[local] = n;
    points->n = (n + OSEEN_LANES - 1) / OSEEN_LANES * OSEEN_LANES;
    for (int i = 0; i < points->n; i++) {
      const PolarPoint *point = &polar[i < n ? i : 0];
      points->s[i] = point->dxi;
      points->t[i] = point->deta;
      points->weight[i] = i < n ? point->weight : 0;
    }
  }
}

Status singular_new(SingularRule **out, const PolarScheme *scheme, Error *error) {
  Status status = STATUS_OK;
  SingularRule *rule = NULL;
  TRY(ARRAY_NEW(&rule, 1, error));
  rule->plane = scheme->plane;
  polar_gauss(scheme->n_radial, scheme->n_angular, &rule->gauss);
  fill_expansions(rule);
  if (scheme->plane == POLAR_PARAMETRIC) {
    fill_parametric(rule);
  } else {
    polar_gauss(scheme->n_radial, scheme->n_angular_long, &rule->gauss_long);
  }
  *out = rule;
cleanup:
  return status;
}

void singular_free(SingularRule *rule) {
  array_free(rule);
}

/* exp(asinh(z)) without cancellation. */
static double exp_asinh(double z) {
  double root = sqrt(1 + z * z);
  return z > 0 ? root + z : 1 / (root - z);
}

/* The triangle (node, from, to) in the tangent plane spanned by a1, a2. */
static ApexTriangle apex_triangle(const double a1[3], const double a2[3], const double node[2],
                                  const double from[2], const double to[2]) {
  ApexTriangle triangle = {.a = {from[0] - node[0], from[1] - node[1]},
                           .b = {to[0] - node[0], to[1] - node[1]}};
  const double *a = triangle.a, *b = triangle.b;
  double side[3], edge[3], normal[3];
  for (int c = 0; c < 3; c++) {
    side[c] = a1[c] * a[0] + a2[c] * a[1];
    edge[c] = a1[c] * (b[0] - a[0]) + a2[c] * (b[1] - a[1]);
  }
  vec3_cross(side, edge, normal);
  double length2 = vec3_dot(edge, edge), height_length = vec3_norm(normal),
         foot_length = vec3_dot(side, edge);
  triangle.area = a[0] * b[1] - a[1] * b[0];
  triangle.height_over_edge = height_length / length2;
  triangle.foot_over_edge = foot_length / length2;
  triangle.start = exp_asinh(foot_length / height_length);
  triangle.range = log(exp_asinh((foot_length + length2) / height_length) / triangle.start);
  return triangle;
}

/* Points of both triangles in the tangent plane. */
static void tangent_points(const SingularRule *rule, const Expansion *expansion, int local,
                           OffsetPoints *points) {
  points->n = 0;
  const double *a1 = expansion->coefficient[1], *a2 = expansion->coefficient[2];
  for (int k = 0; k < 2 && OPPOSITE[local][k + 1] >= 0; k++) {
    ApexTriangle triangle =
        apex_triangle(a1, a2, p2_node[local], p2_node[OPPOSITE[local][k]], p2_node[OPPOSITE[local][k + 1]]);
    apex_points(&triangle, triangle.range > LONG_RANGE ? &rule->gauss_long : &rule->gauss, points);
  }
}

static bool has_tangent_plane(const Expansion *expansion) {
  const double *a1 = expansion->coefficient[1], *a2 = expansion->coefficient[2];
  double normal[3];
  vec3_cross(a1, a2, normal);
  return vec3_norm(normal) > DEGENERATE * (vec3_dot(a1, a1) + vec3_dot(a2, a2));
}

static int gather_element(const SingularRule *rule, const int element[6], int local, const double *x,
                          const double *q, Gather *gather) {
  Piece piece;
  Expansion expansion;
  piece_load(element, x, q, &piece);
  expansion_set((const double(*)[6])rule->expand[local], &piece, &expansion);
  if (!has_tangent_plane(&expansion)) return -1;
  const OffsetPoints *points = &rule->parametric[local];
  int n = rule->n_parametric[local];
  OffsetPoints tangent;
  if (rule->plane == POLAR_TANGENT) {
    tangent_points(rule, &expansion, local, &tangent);
    points = &tangent;
    n = tangent.n;
  }
  expansion_points(&expansion, offset_view(points), gather_reserve(gather, points->n / OSEEN_LANES));
  return n;
}

int singular_gather(const SingularRule *rule, const Mesh *mesh, const double *x, const double *q, int p,
                    Gather *gather) {
  int total = 0;
  for (int i = mesh->node_start[p]; i < mesh->node_start[p + 1]; i++) {
    int n = gather_element(rule, mesh->element[mesh->node_element[i]], mesh->node_local[i], x, q, gather);
    if (n < 0) return -1;
    total += n;
  }
  return total;
}

/* ---- held ---- */

/* Most points of an element, as seen from a local node. */
static int most_points(const SingularRule *rule, int local) {
  const int triangles = OPPOSITE[local][2] >= 0 ? 2 : 1;
  return triangles * rule->gauss_long.n_radial * rule->gauss_long.n_angular;
}

Status held_polar_new(HeldPolar *held, const SingularRule *rule, const Mesh *mesh, const int *node, int n,
                      Error *error) {
  Status status = STATUS_OK;
  *held = (HeldPolar){.rule = rule, .mesh = mesh, .node = node};
  TRY(ARRAY_NEW(&held->start, n + 1, error));
  for (int i = 0; i < n; i++)
    held->start[i + 1] = held->start[i] + mesh->node_start[node[i] + 1] - mesh->node_start[node[i]];
  TRY(ARRAY_NEW(&held->first, held->start[n], error));
  TRY(ARRAY_NEW(&held->n, held->start[n], error));
  int total = 0;
  for (int i = 0; i < n; i++)
    for (int k = held->start[i]; k < held->start[i + 1]; k++) {
      held->first[k] = total;
      total += 3 * most_points(rule, mesh->node_local[mesh->node_start[node[i]] + k - held->start[i]]);
    }
  TRY(ARRAY_NEW(&held->offset, total, error));
cleanup:
  if (status != STATUS_OK) held_polar_free(held);
  return status;
}

void held_polar_free(HeldPolar *held) {
  array_free(held->start);
  array_free(held->first);
  array_free(held->n);
  array_free(held->offset);
  *held = (HeldPolar){0};
}

/* The expansion of element k of those around node[i]; returns its number of the node. */
static int expand(const HeldPolar *held, const double *x, const double *q, int i, int k,
                  Expansion *expansion) {
  const Mesh *mesh = held->mesh;
  const int entry = mesh->node_start[held->node[i]] + k - held->start[i], local = mesh->node_local[entry];
  Piece piece;
  piece_load(mesh->element[mesh->node_element[entry]], x, q, &piece);
  expansion_set((const double(*)[6])held->rule->expand[local], &piece, expansion);
  return local;
}

void held_polar_settle(HeldPolar *held, const double *x, int i) {
  for (int k = held->start[i]; k < held->start[i + 1]; k++) {
    Expansion expansion;
    OffsetPoints points = {.n = 0};
    const int local = expand(held, x, x, i, k, &expansion); /* no load is needed, and x is one */
    if (has_tangent_plane(&expansion)) tangent_points(held->rule, &expansion, local, &points);
    const size_t bytes = (size_t)points.n * sizeof(double);
    double *to = held->offset + held->first[k];
    memcpy(to, points.s, bytes);
    memcpy(to + points.n, points.t, bytes);
    memcpy(to + 2 * points.n, points.weight, bytes);
    held->n[k] = points.n;
  }
}

int held_polar_gather(const HeldPolar *held, const double *x, const double *q, int i, Gather *gather) {
  int total = 0;
  for (int k = held->start[i]; k < held->start[i + 1]; k++) {
    Expansion expansion;
    const int n = held->n[k];
    const double *s = held->offset + held->first[k];
    expand(held, x, q, i, k, &expansion);
    if (n == 0 || !has_tangent_plane(&expansion)) return -1;
    expansion_points(&expansion, (OffsetView){n, s, s + n, s + 2 * n},
                     gather_reserve(gather, n / OSEEN_LANES));
    total += n;
  }
  return total;
}
