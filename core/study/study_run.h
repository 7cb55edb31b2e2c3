/* A study at work: from its file to its folder. */
#ifndef CAPSELLA_STUDY_STUDY_RUN_H
#define CAPSELLA_STUDY_STUDY_RUN_H

#include "observe/json.h"
#include "study/runner.h"

typedef struct {
  const char *path;
  const char *const *sets; /* of the base scene */
  size_t n_sets;
  const char *folder; /* NULL: results/NAME */
  int part, parts;    /* of those that study_take_part tells apart, in FOLDER/part_N; 0: the whole */
  RunnerOptions runner;
} StudyOptions;

/* What a kind of study works with.  Its run() asks the runner for cases, writes table.csv and charts into the
 * folder, and adds keys of its own to the summary. After an interrupt it writes what there is. */
struct StudyRun {
  const Study *study;
  Runner *runner;
  const char *folder;
  Json *summary;
  Text *found; /* what was to be found, in lines for the reader of a terminal */
};

typedef struct {
  bool interrupted;
  RunnerCount count;
  Text found; /* lines; freed by the caller, on failure too */
} StudyEnd;

/* Reads the study, or the part of it that the options ask for: study_free. */
Status study_open(const StudyOptions *options, Study *study, Error *error);

/* Runs the study and writes its folder: scene.yaml, journal.txt, cases/, table.csv, summary.json and charts.
 * `folder` receives its path. */
Status study_run(const StudyOptions *options, Text *folder, StudyEnd *end, Error *error);

/* Writes a finished text into the study's folder. */
Status study_write(const StudyRun *run, const char *name, const Text *text, Error *error);

#endif
