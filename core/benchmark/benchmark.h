/* Run time against error: single evaluations and whole runs of the reference case, measured in this process,
 * one after the other, so that their ratios hold on a noisy machine. */
#ifndef CAPSELLA_BENCHMARK_BENCHMARK_H
#define CAPSELLA_BENCHMARK_BENCHMARK_H

#include "base/status.h"
#include "base/text.h"
#include <mlaw/mlaw.h>
#include <stdbool.h>
#include <stddef.h>

/* ---- one evaluation of the velocity ---- */

typedef struct {
  const char *method; /* as in a scene */
  int subdivisions, threads;
  bool symmetric;
  int elements;
  double milliseconds;           /* median of several */
  double membrane_milliseconds;  /* of which: internal force and load */
  long long far, near, singular; /* kernel pairs */
} EvaluationCost;

/* An evaluation on a capsule stretched to 2:1:0.5, loaded by its own tensions. */
Status benchmark_evaluation(EvaluationCost *cost, Error *error);

/* ---- accuracy of the single layer ---- */

typedef struct {
  const char *method;
  int subdivisions;
  double axes[3];
  double
      error; /* of the velocity of a rigid ellipsoid in translation, max over nodes / |u|: exact solution */
  double quadrature; /* the same against the reference method on the same surface: without the error of the P2
                        geometry */
} LayerError;

Status benchmark_layer(LayerError *layer, Error *error);

/* ---- the same law compiled in ---- */

typedef struct {
  double plugin_microseconds, compiled_in_microseconds; /* of one internal force, 1280 elements, one thread */
} LawCost;

/* `compiled_in`: the elastic law of the reference case, linked into the program. */
Status benchmark_law(const mlaw_energy *compiled_in, LawCost *cost, Error *error);

/* ---- whole runs ---- */

typedef struct {
  double t, D12, beta, L[3], area_strain, d_max;
  double Y_max; /* up to t */
} RunState;

enum { BENCHMARK_STATES = 4, BENCHMARK_RUNS = 5 };

typedef struct {
  const char *label;
  const char *const *sets; /* on top of the reference case, as with --set; ended by NULL */
  const double *times;     /* [n_times] rising, at most BENCHMARK_STATES: the run ends at the last */
  size_t n_times;
  int threads;
  /* Found: */
  double seconds, cpu_seconds; /* median; a short run is repeated, at most BENCHMARK_RUNS times */
  long long evaluations, pairs;
  RunState state[BENCHMARK_STATES]; /* at `times` */
} RunCost;

/* Runs without outputs: a capsule of neo-Hookean membrane with threshold damage in simple shear at Ca = 0.7,
 * 1280 elements, but for what `sets` says. */
Status benchmark_run(RunCost *run, Error *error);

typedef struct {
  const char *const *sets; /* as of a RunCost */
  int threads;
  /* Found: */
  double t_c, t_l; /* first damage, rupture */
  double seconds, cpu_seconds;
  long long evaluations;
} RuptureCost;

/* Runs to rupture.  STATUS_FAILED when there is none up to t = 20. */
Status benchmark_rupture(RuptureCost *run, Error *error);

/* ---- the machine ---- */

/* Pairs per second of the bare kernel on one thread, median of several. */
double benchmark_kernel_rate(void);

/* Processor, compiler, date, as lines of Markdown. */
Status benchmark_machine(Text *text, Error *error);

#endif
