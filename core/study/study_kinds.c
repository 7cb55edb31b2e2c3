/* The kinds of study: one row each. */
#include "study/sweep.h"

const StudyKind *const STUDY_KINDS[] = {&SWEEP, NULL};
