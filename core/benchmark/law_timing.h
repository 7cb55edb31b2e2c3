/* What it costs to call a law through the plugin interface: nanoseconds for each point of a batch. */
#ifndef CAPSELLA_BENCHMARK_LAW_TIMING_H
#define CAPSELLA_BENCHMARK_LAW_TIMING_H

#include "base/status.h"
#include "base/text.h"
#include "laws/loader.h"

/* Points of one element, of a block of elements, and of a whole coarse mesh. */
enum { LAW_BATCHES = 3 };
extern const int law_batch_points[LAW_BATCHES]; /* 6, 96, 1536 */

typedef struct {
  double nanoseconds[LAW_BATCHES]; /* per point, median of several */
} LawTiming;

/* The call that a run makes: phi and its first derivatives, zeta at a Y beyond all before, or a step of a
 * general damage law; parameters uniform.  STATUS_FAILED when the law refuses the points of the conformance
 * suite. */
Status law_timing(const LoadedLaw *law, LawTiming *timing, Error *error);

/* Every law on the default search path as a table in Markdown, with the share that batches of 96 have of an
 * evaluation of the velocity that takes so many milliseconds on one thread for `points` integration points.
 */
Status law_timing_print(double evaluation_milliseconds, int points, Text *markdown, Error *error);

#endif
