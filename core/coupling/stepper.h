/* Advancing the coupled problem in time: step size from the error and from stability, rejected steps, dense
 * output.
 *
 * A step is proposed, looked at (events and samples inside it may be probed), and accepted:
 *
 *   stepper_propose(...)            from (t, x, v) to (t1, x1, v1); nothing of the accepted state has changed
 *   stepper_interpolate(...)        positions inside the step
 *   stepper_accept(...)             the end of the step becomes the accepted state
 *
 * Error of a step: 0.8 (x0 - x1) + 0.4 h (v0 + v1), the third-derivative term of any method of order two; its
 * v1 is the first evaluation of the next step, so that it costs nothing.
 *
 * Damage runs away within the few elements that rupture, which the mean over the nodes hides: automatic steps
 * are so short that the largest damage grows by no more than 5 sqrt(tolerance) in each, down to steps of
 * 10 tolerance, since the damage of a brittle law jumps (docs/decisions/damage-steps.md). */
#ifndef CAPSELLA_COUPLING_STEPPER_H
#define CAPSELLA_COUPLING_STEPPER_H

#include "base/log.h"
#include "base/status.h"
#include "coupling/integrator.h"
#include "coupling/rhs.h"
#include <stdbool.h>

typedef struct {
  IntegratorKind integrator;
  bool is_auto;
  double fixed_step; /* when !is_auto */
  double tolerance;  /* of the error of one step, root mean square over the nodes, in units of a */
  bool allow_unstable;
} StepperOptions;

/* What the next step depends on beside the state; what a restart keeps. */
typedef struct {
  double t;
  double h_next;       /* size wanted for the next step */
  double error_before; /* scaled error, or growth of damage, of the last accepted step */
  double rho;          /* spectral radius, as estimated */
  double steps_since_rho;
  double steps, rejected_steps;
  double error_max;      /* of one step so far, as options.tolerance; above it only for fixed steps */
  double unstable_steps; /* fixed steps beyond the stability limit that allow_unstable let pass */
} StepperMemory;

typedef struct {
  Rhs rhs;
  StepperOptions options;
  const Integrator *integrator;
  StepperMemory memory;
  double *x, *v;       /* [n] accepted state at memory.t */
  double *direction;   /* [n] of the power iteration; part of a restart */
  double t1, *x1, *v1; /* the proposed end of the step */
  double *work;
  bool is_open; /* rhs.open_step knows (memory.t, x, v) */
  bool has_proposal;
} Stepper;

Status stepper_new(Stepper *stepper, Rhs rhs, StepperOptions options, Error *error);
void stepper_free(Stepper *stepper);

/* Starts at (t, x): evaluates v and the spectral radius.  A fixed step beyond the stability limit is refused
 * here with STATUS_INPUT and the limit named, unless allow_unstable. */
Status stepper_start(Stepper *stepper, double t, const double *x, Error *error);

/* Proposes a step that ends at t_limit at the latest, and exactly there when it comes near.  Rejected trials
 * are repeated with a smaller step.  STATUS_FAILED with the cause when no step can be found. */
Status stepper_propose(Stepper *stepper, double t_limit, Log *log, Error *error);

/* x, v [n] at time t inside the proposed step: cubic Hermite interpolation, of order three in x.  v may be
 * NULL. */
void stepper_interpolate(const Stepper *stepper, double t, double *x, double *v);

/* Ends the proposed step at t, inside it, with the interpolated positions and velocities: where a run stops
 * early. */
void stepper_shorten(Stepper *stepper, double t);

/* Takes the end of the proposed step as the accepted state. */
void stepper_accept(Stepper *stepper);

/* Largest step that is stable, with all the stages the integrator has, at the spectral radius last estimated.
 */
double stepper_stability_limit(const Stepper *stepper);

/* Estimates the spectral radius at the accepted state now. */
Status stepper_measure_radius(Stepper *stepper, Error *error);

#endif
