/* Polar quadrature in the tangent plane of a node, and the point forces of an element about a node. */
#ifndef CAPSELLA_FLUID_POLAR_KERNEL_H
#define CAPSELLA_FLUID_POLAR_KERNEL_H

#include "fluid/oseen_kernel.h"
#include "fluid/piece_kernel.h"
#include "mesh/polar.h"

/* Parametric offsets (s, t) from a node and quadrature weights, a multiple of OSEEN_LANES of them: places not
 * needed repeat a point with weight 0. */
enum { OFFSET_MAX = 128 };
typedef struct {
  int n;
  double s[OFFSET_MAX], t[OFFSET_MAX], weight[OFFSET_MAX];
} OffsetPoints;

/* Such points wherever they are kept. */
typedef struct {
  int n;
  const double *s, *t, *weight; /* [n] */
} OffsetView;

static inline OffsetView offset_view(const OffsetPoints *points) {
  return (OffsetView){points->n, points->s, points->t, points->weight};
}

/* A triangle with its apex at the node, in the tangent plane there.  Along the opposite edge the distance
 * from the foot of the perpendicular is height * sinh(w), with exp(w) from `start` on over a range of w. */
typedef struct {
  double a[2], b[2];       /* parametric offsets of the corners that end the opposite edge */
  double area;             /* twice the parametric area */
  double height_over_edge; /* distance of the apex from the edge, over the edge's length */
  double foot_over_edge;   /* distance of corner a from the foot, the way to b; over the edge's length */
  double start, range;
} ApexTriangle;

/* Appends gauss->n_radial x gauss->n_angular points (n_angular a multiple of OSEEN_LANES), Gauss in w. */
void apex_points(const ApexTriangle *triangle, const PolarGauss *gauss, OffsetPoints *points);

/* An element as a polynomial about one of its nodes: value = c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2 for
 * each component. */
typedef struct {
  double coefficient[6][PIECE_COMPONENTS];
} Expansion;

/* The expansion from the nodes of an element: coefficient[m] = sum of matrix[m][k] node[k]. */
void expansion_set(const double matrix[6][6], const Piece *element, Expansion *expansion);

/* Point forces at the offsets: points.n / OSEEN_LANES blocks. */
void expansion_points(const Expansion *expansion, OffsetView points, OseenBlock *out);

#endif
