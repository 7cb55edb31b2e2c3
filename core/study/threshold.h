/* The study `threshold`: at each point of the varied values, the value of a key at which something begins:
 * damage, rupture, or a figure beyond a level. */
#ifndef CAPSELLA_STUDY_THRESHOLD_H
#define CAPSELLA_STUDY_THRESHOLD_H

#include "study/study.h"

extern const StudyKind THRESHOLD;

#endif
