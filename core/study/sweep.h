/* The study `sweep`: one run for each combination of the varied values. */
#ifndef CAPSELLA_STUDY_SWEEP_H
#define CAPSELLA_STUDY_SWEEP_H

#include "study/study.h"

extern const StudyKind SWEEP;

#endif
