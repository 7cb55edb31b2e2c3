/* The coupled problem at one instant: positions -> membrane -> load -> fluid -> velocity of the nodes.
 *
 *   M q = R(x, d),   v(x_p) = v_inf(x_p) - 1/(Ca G_s) 1/(8 pi) int_S J(x_p, y) q(y) dS_y     (paper
 * eq. 2.2, 3.4)
 *
 * with tensions in the units of the law, whose shear modulus at rest is G_s. */
#ifndef CAPSELLA_COUPLING_SYSTEM_H
#define CAPSELLA_COUPLING_SYSTEM_H

#include "base/status.h"
#include "coupling/rhs.h"
#include "fluid/coarse_layer.h"
#include "fluid/flow.h"
#include "fluid/single_layer.h"
#include "membrane/membrane.h"
#include "mesh/mesh.h"
#include <stdbool.h>

typedef struct {
  const Mesh *mesh;
  Membrane *membrane;
  SingleLayer *layer;
  const Flow *flow;
  const Symmetry *symmetry; /* of all fields, to the last bit; NULL: none is used */
  double mobility;          /* 1 / (Ca G_s) */
  bool keep_volume; /* subtract c n from v so that int v . n dS = 0, and move the end of a step back onto
                       volume0 */
  double volume0;   /* to be enclosed: that of mesh->X until told otherwise */
  double *R,
      *q; /* [n_nodes][3] internal force and load of the last evaluation; q starts the next mass solve */
  double *u, *A, *normal; /* [n_nodes][3] scratch */
  /* For the inner stages of a step; NULL where they are summed as all else: */
  CoarseLayer *coarse;
  double *lack; /* [n_nodes][3] what the coarse velocity lacks at the start of the step */
  long long evaluations, coarse_evaluations; /* of the velocity: all, and those of them by the coarse layer */
} CoupledSystem;

/* Allocates the arrays; the parts must outlive the system. */
Status system_new(CoupledSystem *system, const Mesh *mesh, Membrane *membrane, SingleLayer *layer,
                  const Flow *flow, double mobility, bool keep_volume, Error *error);
void system_free(CoupledSystem *system);

/* From now on the inner stages of a step sum over `coarse` and add what that lacked at the step's start
 * (docs/decisions/stages.md). */
Status system_use_coarse(CoupledSystem *system, CoarseLayer *coarse, Error *error);
/* From the next step on they are summed as all else.  Returns whether that is a change. */
bool system_sum_in_full(CoupledSystem *system);

/* v [n_nodes][3] at positions x and time t + dt; the membrane holds the trial history that belongs to it. */
Status system_velocity(CoupledSystem *system, const double *x, double t, double dt, double *v, Error *error);

/* Moves x along the normals until it encloses volume0, where the volume is kept, and makes it symmetric to
 * the last bit, where a symmetry is used. */
void system_constrain(CoupledSystem *system, double *x);

Rhs system_rhs(CoupledSystem *system);

#endif
