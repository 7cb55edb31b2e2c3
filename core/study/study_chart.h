/* A chart of a quantity over the points of a study: against its longest numeric axis, one line for each
 * combination of the other values. */
#ifndef CAPSELLA_STUDY_STUDY_CHART_H
#define CAPSELLA_STUDY_STUDY_CHART_H

#include "study/study_run.h"

typedef struct {
  const char *name;     /* in the legend */
  const double *values; /* [n_points]; what is not finite is left out */
} Curve;

/* Writes FOLDER/FILE; nothing when no axis has two numbers or there is nothing to draw. */
Status study_chart_write(const StudyRun *run, const char *file, const char *y_label, const Curve *curves,
                         size_t n, Error *error);

/* Appends what tells a point of a study from the others: "NAME, Y_C = 2, no damage".  The axis `skipped` is
 * left out; n_axes: none is. */
Status study_chart_label(const Study *study, const char *name, size_t point, size_t skipped, Text *label,
                         Error *error);

#endif
