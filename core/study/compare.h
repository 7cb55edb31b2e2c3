/* The study `compare`: where and when several damage laws would rupture one and the same capsule.
 *
 *     mode: passive    all laws look on along one run of the scene, without feedback (default)
 *     mode: coupled    each law acts on the membrane in a run of its own
 *     confirm: [...]   with `passive`: these by coupled runs too
 *     calibrate: ...   first multiplies the `strength` of each law so that all are equally severe */
#ifndef CAPSELLA_STUDY_COMPARE_H
#define CAPSELLA_STUDY_COMPARE_H

#include "study/study.h"

extern const StudyKind COMPARE;

#endif
