/* What is to be expected at a point of the outer product from points that are known.
 *
 * Points are taken in levels: the corners first, then the middles between them, and so on; a point may lean
 * on all points of lower levels.  That order is fixed by the axes alone, so what is expected where does not
 * depend on the order in which cases end.  Only points that agree along the axes that are no numbers are
 * neighbours. */
#ifndef CAPSELLA_STUDY_NEIGHBOURS_H
#define CAPSELLA_STUDY_NEIGHBOURS_H

#include "study/study.h"

/* Level of a point, from 0. */
int neighbours_level(const Study *study, size_t point);

/* Whether `other` is of a lower level than `point` and agrees with it where axes are no numbers. */
bool neighbours_lean(const Study *study, size_t point, size_t other);

/* The value at `point` of a plane fitted to values [n_points] of the points it leans on, near ones counting
 * most; values that are not finite are passed over.  NAN when there are none. */
double neighbours_expect(const Study *study, size_t point, const double *values);

#endif
