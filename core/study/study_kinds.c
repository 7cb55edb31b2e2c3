/* The kinds of study: one row each. */
#include "study/compare.h"
#include "study/sweep.h"

const StudyKind *const STUDY_KINDS[] = {&COMPARE, &SWEEP, NULL};
