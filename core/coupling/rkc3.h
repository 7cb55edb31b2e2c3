/* A stabilised Runge-Kutta method of order 3 on the stages of the Runge-Kutta-Chebyshev method:
 *
 *   x1 = x0 + h sum_j b_j F_j,   j = 0, 2, 3, ... s - 1
 *
 * Every stage but the first is of order two there, so that with b_1 = 0 the three conditions
 * sum b_j c_j^k = 1/(k + 1), k = 0, 1, 2, make order 3 (c_j: where in the step stage j stands).  What they
 * leave free makes the step stable on an interval of the negative real axis that grows as 0.465 s^2, of which
 * no polynomial of order 3 reaches more than 0.49 s^2 (docs/decisions/order-three.md).
 *
 * A step that needs more than RKC3_MAX_STAGES is one of rkc2: its length is a matter of stiffness then,
 * hardly of accuracy, and order 2 takes fewer stages. */
#ifndef CAPSELLA_COUPLING_RKC3_H
#define CAPSELLA_COUPLING_RKC3_H

#include "coupling/integrator.h"

extern const Integrator integrator_rkc3;

enum { RKC3_MIN_STAGES = 4, RKC3_MAX_STAGES = 24 };

/* The weights b [stages], RKC3_MIN_STAGES <= stages <= RKC3_MAX_STAGES. */
Status rkc3_weights(int stages, double *b, Error *error);

#endif
