/* The kinds of study: one row each. */
#include "study/compare.h"
#include "study/sweep.h"
#include "study/threshold.h"

const StudyKind *const STUDY_KINDS[] = {&SWEEP, &THRESHOLD, &COMPARE, NULL};
