/* Run time against error: single evaluations and whole runs of the reference case, measured in this process,
 * one after the other, so that their ratios hold on a noisy machine. */
#ifndef CAPSELLA_STUDY_BENCHMARK_H
#define CAPSELLA_STUDY_BENCHMARK_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

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

/* ---- whole runs ---- */

typedef struct {
  const char *label;
  const char *const *sets; /* on top of the reference case, as with --set; ended by NULL */
  int threads;
  /* Found: */
  double seconds, cpu_seconds;
  long long evaluations, pairs;
  double t, D12, beta, L[3], area_strain, d_max, Y_max;
} RunCost;

/* Runs without outputs. */
Status benchmark_run(RunCost *run, Error *error);

/* ---- the machine ---- */

/* Pairs per second of the bare kernel on one thread, median of several. */
double benchmark_kernel_rate(void);

/* Processor, compiler, date, as lines of Markdown. */
Status benchmark_machine(Text *text, Error *error);

#endif
