/* The study `compare` at work: its runs, and the rows of its table that are read from them.  Shared by the
 * files that make it up; nothing else includes this. */
#ifndef CAPSELLA_STUDY_COMPARISON_H
#define CAPSELLA_STUDY_COMPARISON_H

#include "base/text.h"
#include "study/question.h"
#include "study/study_run.h"
#include "study/trial_search.h"

/* A way to run the scene of a point: all contenders looking on, or one of them acting on the membrane. */
typedef struct {
  Override *settings; /* [n_settings], then room for one more */
  size_t n_settings;
  Text criteria, damage, label; /* `settings` holds the first two; the name of the case */
  int number;                   /* of the case */
} Variant;

/* One verdict: of a contender, at a point, in a mode. */
typedef struct {
  size_t point, contender;
  Mode mode;
  const Calibrated *strength;
  const Variant *variant;      /* NULL: the strength is not known, nothing is run */
  char where[32];              /* the contender's entry in the summary of the case: "criteria.2." */
  Search search[MOST_TARGETS]; /* [n_targets] for its limits */
} Row;

typedef struct {
  StudyRun *run;
  Question question;
  Calibrated *strength[N_MODES]; /* [n_points][n] */
  Variant *variants;             /* [n_variants] */
  size_t n_variants;
  Row *rows; /* [n_rows] */
  size_t n_rows;
} Comparison;

#endif
