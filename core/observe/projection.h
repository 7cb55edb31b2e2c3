/* A curved surface seen from one side: flat pieces in the plane of the picture, farthest first. */
#ifndef CAPSELLA_OBSERVE_PROJECTION_H
#define CAPSELLA_OBSERVE_PROJECTION_H

#include "base/status.h"
#include "mesh/mesh.h"
#include <stddef.h>

/* Orthonormal: `right` and `up` span the picture, `toward` points to the eye. */
typedef struct {
  double right[3], up[3], toward[3];
} Projection;

/* A triangle of the cut-up surface. */
typedef struct {
  double corner[3][2]; /* along right and up, from the centre of the view */
  double depth;        /* along toward; greater is nearer */
  double values[3];    /* of the field at the corners */
  double value;        /* their mean */
  double light; /* 0 (turned away from the light) .. 1; the light comes over the viewer's left shoulder */
  int order;    /* in the surface: settles ties of depth */
} Piece;

/* STATUS_INPUT when `toward` is zero or `up` lies along it. */
Status projection_make(Projection *projection, const double toward[3], const double up[3], Error *error);

/* Cuts each element into cuts * cuts pieces and keeps those that face the eye, sorted from the farthest to
 * the nearest.  x [n_nodes][3]; field [n_nodes] or NULL (value 0); lengths stay those of x. `pieces` is made
 * by array_allocate. */
Status projection_pieces(const Projection *projection, const Mesh *mesh, const double *x, const double *field,
                         const double center[3], int cuts, Piece **pieces, size_t *count, Error *error);

#endif
