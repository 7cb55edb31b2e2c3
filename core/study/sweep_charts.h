/* The charts of a sweep:
 *
 *     charts:
 *       - {draw: d_max}                     figures at the end of the runs, over the longest varied range
 *       - {draw: [L1, L2, L3], over: t}     columns of the histories, a line for each run
 *
 * Each is a file named by what it shows: d_max.svg, L1_L2_L3_over_t.svg. Without the key: d_max and D12. */
#ifndef CAPSELLA_STUDY_SWEEP_CHARTS_H
#define CAPSELLA_STUDY_SWEEP_CHARTS_H

#include "study/study_run.h"

/* STATUS_INPUT, with its place, for what cannot be drawn. */
Status sweep_charts_check(const Study *study, Error *error);

/* `cases` [n_points]; a case that has left nothing to draw is left out. */
Status sweep_charts_write(const StudyRun *run, const int *cases, Error *error);

#endif
