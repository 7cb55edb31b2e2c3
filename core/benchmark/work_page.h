/* A measured grid of run time against error as tables in Markdown and as a picture. */
#ifndef CAPSELLA_BENCHMARK_WORK_PAGE_H
#define CAPSELLA_BENCHMARK_WORK_PAGE_H

#include "base/status.h"
#include "base/text.h"
#include "benchmark/work_precision.h"

/* The least CPU seconds to errors in shape of 1e-2, 1e-3 and 1e-4, and the knobs that they take. */
Status work_print_choices(const WorkPrecision *work, Text *markdown, Error *error);

/* Every point with its error and the parts of it. */
Status work_print_grid(const WorkPrecision *work, Text *markdown, Error *error);

/* D12 and damage on each mesh at all times, with time errors out of the way. */
Status work_print_meshes(const WorkPrecision *work, Text *markdown, Error *error);

/* CPU seconds against error in shape, with the Pareto front and the choices above.  `other` (may be NULL) is
 * one more run, named by its label. */
Status work_print_picture(const WorkPrecision *work, const char *title, const RunCost *other, Text *svg,
                          Error *error);

#endif
