/* The search for one target, by runs of its own: at a point of a threshold study, or for one criterion of a
 * comparison. */
#ifndef CAPSELLA_STUDY_TRIAL_SEARCH_H
#define CAPSELLA_STUDY_TRIAL_SEARCH_H

#include "study/answer.h"
#include "study/bracket.h"
#include "study/target.h"

typedef struct {
  const Target *target;
  const Override *settings; /* [n_settings] of the point */
  size_t n_settings;
  const char *label; /* what its cases are called, before the value that is tried; NULL: by the settings */
  const char *where; /* in a summary the event is looked up: "criteria.2."; NULL: of the membrane itself */
  Bracket bracket;
  double trial[2];
  int cases[2];
  int n_trials;
  int runs;      /* asked for */
  int unsettled; /* of them: came to the end of time without rupture or steady state */
  bool begun, over;
  const char *reason; /* why it has no answer; owned by a case, or constant */
} Search;

/* Begins around a guess; see bracket_start. */
void search_begin(Search *search, double low, double high, double tolerance, double guess, double reach);

/* Goes on as far as the cases that have ended allow; `moved` is set when it did. */
Status search_advance(Search *search, Runner *runner, bool *moved, Error *error);

/* What it has found by now. */
Answer search_answer(const Search *search);

#endif
