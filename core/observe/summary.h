/* summary.json: how a run ended, in figures. */
#ifndef CAPSELLA_OBSERVE_SUMMARY_H
#define CAPSELLA_OBSERVE_SUMMARY_H

#include "base/status.h"
#include "base/text.h"
#include "observe/verdict.h"
#include <stdbool.h>
#include <stddef.h>

typedef enum { OUTCOME_STEADY, OUTCOME_END, OUTCOME_RUPTURED, OUTCOME_FAILED, OUTCOME_INTERRUPTED } Outcome;

/* "steady", "end", "ruptured", "failed", "interrupted". */
const char *outcome_name(Outcome outcome);

/* Dimensionless.  A double that is NAN becomes null. */
typedef struct {
  Outcome status;
  double t;
  double D12, beta, L1, L2, L3; /* beta in radians */
  double area_strain, volume_error, volume_error_max;
  double d_max;
  struct {
    double X[3], x[3]; /* reference and current position of the point of largest damage */
  } d_max_location;    /* written as null while d_max is 0 or NAN */
  double Y_max;
  double t_c, t_l; /* first time with d > 0, with d >= 1; NAN: not reached */
  bool has_rupture;
  Site rupture;                 /* where, if has_rupture */
  double damaged_area_fraction; /* then, of the reference area with d > 0 */
  double energy_error_max;
  double step_error_max; /* largest error of a step, as time.tolerance; NAN: steps are prescribed */
  double film_min; /* thinnest film between two parts of the membrane, in widths of the elements there; NAN:
                      none thinner than an element is wide */
  double wrinkle_amplitude_max; /* of the rows of the history; NAN: the radius is imposed */
  long long unstable_steps;     /* steps beyond the stability limit, which time.allow_unstable let pass */
  long long steps, rejected_steps;
  long long evaluations, stage_evaluations; /* of the velocity: all, and those of them by the coarse rule */
  double wall_seconds;
  int threads, elements, nodes;
  /* Scales of a scene with units: metre, second, newton per metre.  All 0 for a dimensionless scene. */
  double length_scale, time_scale, tension_scale;
  const char *const *skipped; /* sentences: what was not set up, and why */
  size_t n_skipped;
  const Verdict *criteria; /* what criteria that looked on say; the key is left out when there are none */
  size_t n_criteria;
} Summary;

/* The keys of the interface, in its order. */
Status summary_print(const Summary *summary, Text *json, Error *error);

/* The same into a file, written whole or not at all. */
Status summary_write(const Summary *summary, const char *path, Error *error);

#endif
