/* The search for one target at one point of a threshold study, by runs of its own. */
#ifndef CAPSELLA_STUDY_TRIAL_SEARCH_H
#define CAPSELLA_STUDY_TRIAL_SEARCH_H

#include "study/bracket.h"
#include "study/target.h"

typedef struct {
  const Target *target;
  const Override *settings; /* [n_settings] of the point */
  size_t n_settings;
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

#endif
