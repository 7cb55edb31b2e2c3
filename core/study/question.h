/* What a study `compare` asks for, as its file says it. */
#ifndef CAPSELLA_STUDY_QUESTION_H
#define CAPSELLA_STUDY_QUESTION_H

#include "study/calibration.h"
#include "study/contender.h"
#include "study/plan.h"

typedef enum { MODE_PASSIVE, MODE_COUPLED } Mode;
enum { N_MODES = 2 };
extern const char *const MODES[]; /* their names; ends in NULL */

typedef struct {
  Mode mode;
  Contender *contenders; /* [n] */
  size_t n;
  bool *acts; /* [n] on the membrane in a run of its own */
  CalibrationGoal goal;
  Plan plan; /* the limits to be found of each contender; without targets: none */
} Question;

/* STATUS_INPUT with the place of what is wrong. */
Status question_read(const Study *study, Question *question, Error *error);
void question_free(Question *question);

#endif
