/* The curves of a run's folder for papers: what history.csv holds over time. */
#ifndef CAPSELLA_RUN_REPORT_CURVES_H
#define CAPSELLA_RUN_REPORT_CURVES_H

#include "base/status.h"
#include "base/text.h"

/* Appends an SVG document with six charts.  STATUS_IO: no history.csv, or one of another kind. */
Status report_curves(const char *folder, Text *svg, Error *error);

#endif
