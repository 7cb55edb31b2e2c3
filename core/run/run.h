/* Running a scene from file to results. */
#ifndef CAPSELLA_RUN_RUN_H
#define CAPSELLA_RUN_RUN_H

#include "base/status.h"
#include "base/text.h"
#include "laws/watch.h"
#include "observe/summary.h"
#include <stdbool.h>
#include <stdio.h>

typedef struct {
  const char *scene_path;
  const char *const *sets; /* "key.path=value" */
  size_t n_sets;
  const char *folder; /* where results go; NULL: results/NAME */
  bool resume; /* from the newest whole snapshot of the folder; anew, with a warning, when it has none */
  int threads; /* 0: all */
  bool quiet;
  FILE *progress; /* may be NULL */
  const volatile int
      *interrupt;      /* set to non-zero (by a signal handler) to stop after the current step; may be NULL */
  LawWatch *law_watch; /* [LAW_WATCHES] filled in with the laws being called; may be NULL */
} RunOptions;

/* Runs to the end, to rupture, to a steady state or to an interrupt, and writes every output.  When the
 * computation fails, the last good state and a summary with status "failed" are on disk.  `folder` receives
 * the result folder. */
Status run_scene(const RunOptions *options, Outcome *outcome, Text *folder, Error *error);

#endif
