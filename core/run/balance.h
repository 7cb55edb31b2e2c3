/* The energy balance of one step: the work of the load and the energy that damage spends, along the motion
 * that was computed.
 *
 *   d/dt int (1 - d) phi dS0 + int Y dd/dt dS0 = R . dx/dt
 *
 * holds along any motion when the force R is the gradient of the energy.  The integrals over time are taken
 * by the rule of Gauss and Lobatto with four instants, which is exact while energy is quadratic in positions
 * that are cubic in time, and by the trapezoid in Y between them.  Where damage sets in, jumps or reaches its
 * largest value inside the step, parts of the step are halved until what the balance leaves over in each is
 * small.  That is the error of these rules, and vanishes with the parts; a force that does not belong to the
 * energy leaves over the same for any parts.  (docs/decisions/energy.md) */
#ifndef CAPSELLA_RUN_BALANCE_H
#define CAPSELLA_RUN_BALANCE_H

#include "base/status.h"

/* What the balance sees of the membrane at one instant. */
typedef struct {
  double t, power, stored; /* power: R . dx/dt */
  const double *Y, *d; /* [n] energy that damage releases where it grows, and the damage; somebody else's */
} Instant;

enum { BALANCE_NODES = 4 };

typedef struct {
  int n; /* integration points; 0 without damage */
  /* Looks at the membrane at time t of the step; the arrays of `instant` stay valid until the next look. */
  Status (*look)(void *context, double t, Instant *instant, Error *error);
  void *context;
  const double *area;      /* [n] that each point stands for */
  double *part_Y, *part_d; /* [n] at the start of the part */
  double *last_Y, *last_d; /* [n] at the last instant looked at */
  double t0, t1;
  double power[BALANCE_NODES];     /* at the nodes of the whole step */
  double work, dissipated, stored; /* of the whole step; stored: at its end */
  int looks;                       /* that the step took */
} Balance;

/* look, context and area are for the caller to set before the first step. */
Status balance_new(Balance *balance, int n, Error *error);
void balance_free(Balance *balance);

/* Takes in a step from `start` to t1; the last look is at t1.  Parts are halved while they leave over more
 * than `tolerance` of the largest energy, which is at least `scale`. */
Status balance_step(Balance *balance, const Instant *start, double t1, double tolerance, double scale,
                    Error *error);

/* Work from the start of the step to t, inside it or at its end. */
double balance_work(const Balance *balance, double t);

#endif
