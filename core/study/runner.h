/* The cases of a study: asked for by label and settings, run as processes of their own side by side, kept on
 * disk, and taken over from there when they are known already.
 *
 *     runner_request(...) -> number of the case        as often as wanted
 *     runner_wait(...)                                 until one more of them has ended
 *     runner_case(...)                                 its figures
 *
 * A case is a folder cases/LABEL of a run.  What a study asks for must follow from the figures of cases
 * alone, never from the order in which they end: then its result depends neither on the number of jobs nor on
 * where it was stopped and resumed. */
#ifndef CAPSELLA_STUDY_RUNNER_H
#define CAPSELLA_STUDY_RUNNER_H

#include "study/case.h"
#include "study/study.h"
#include <stdio.h>

typedef struct {
  int jobs;       /* cases side by side; 0: one a processor */
  int threads;    /* of each case; 0: one */
  bool resume;    /* take over what the folder holds */
  FILE *progress; /* may be NULL */
  bool quiet;
  const char *program;           /* that runs a scene; NULL: this one */
  const volatile int *interrupt; /* set by a signal handler; may be NULL */
} RunnerOptions;

typedef struct Runner Runner;

/* `folder` exists and outlives the runner.  Writes FOLDER/scene.yaml, the base scene. */
Status runner_new(Runner **runner, const Study *study, const char *folder, const RunnerOptions *options,
                  Error *error);

/* On a rank of an MPI job other than 0: runs cases for rank 0 until its runner is freed. `options->interrupt`
 * is not NULL. */
Status runner_serve(const RunnerOptions *options, Error *error);

/* Stops what is running; finished cases stay on disk. */
void runner_free(Runner *runner);

/* The case with these settings on top of the base scene; the number of an earlier request when it is the
 * same. `label` names its folder: letters, digits and "_.+,=-". */
Status runner_request(Runner *runner, const char *label, const Override *settings, size_t n, int *number,
                      Error *error);

/* How many cases there will be, for the time left; what has been requested at least. */
void runner_expect(Runner *runner, long cases);

/* Returns when at least one more case has ended, or at once when none is waiting or running, or, once all
 * processes have stopped, after an interrupt. */
Status runner_wait(Runner *runner, Error *error);

/* Until all have ended or an interrupt. */
Status runner_wait_all(Runner *runner, Error *error);

bool runner_interrupted(const Runner *runner);

const Case *runner_case(const Runner *runner, int number);

/* What there was to do and what has been saved. */
typedef struct {
  long cases, failed;
  long shared;        /* requests that another one had made already */
  long taken_over;    /* found on disk */
  double evaluations; /* of the velocity, in all cases that have ended */
  int jobs;
} RunnerCount;
RunnerCount runner_count(const Runner *runner);

#endif
