/* What a search has found, as cells of a table: the same columns in every study. */
#ifndef CAPSELLA_STUDY_ANSWER_H
#define CAPSELLA_STUDY_ANSWER_H

#include "study/table.h"

/* NAN: not known. */
typedef struct {
  double value, low, high; /* the condition does not hold at `low`, and holds at `high` */
  double error;            /* of the value */
  int runs;                /* made for it */
  const char *note;        /* why there is none; NULL otherwise */
} Answer;

/* NAME, NAME_low, NAME_high, NAME_error, NAME_runs, NAME_note. */
void answer_header(Table *table, const char *name);
void answer_put(Table *table, const Answer *answer);

#endif
