/* Run time against error: one case on a grid of mesh, method, integrator and tolerance, each point compared
 * with a run on a finer mesh, and the choices that follow from it. */
#ifndef CAPSELLA_BENCHMARK_WORK_PRECISION_H
#define CAPSELLA_BENCHMARK_WORK_PRECISION_H

#include "base/status.h"
#include "benchmark/benchmark.h"
#include <stdbool.h>
#include <stddef.h>

/* The knobs that a user has. */
typedef struct {
  int subdivisions;
  const char *interpolation, *method, *integrator, *tolerance; /* as in a scene */
} WorkKnobs;

/* Ways to find the tensions and to sum the single layer that are compared. */
typedef struct {
  const char *interpolation, *method;
} WorkScheme;
enum { WORK_SCHEMES = 4 };
extern const WorkScheme work_schemes[WORK_SCHEMES];

/* Differences to another state. */
typedef struct {
  double D12;   /* relative */
  double shape; /* largest of those of D12 and the three axes (relative), beta/pi and the area strain */
  double d_max; /* absolute */
} WorkError;

WorkError work_error(const RunState *state, const RunState *reference);

typedef struct {
  WorkKnobs knobs;
  RunCost run;
  WorkError error;                /* of the last state */
  double space, quadrature, time; /* the parts of error.shape, each found by turning one knob */
  bool is_on_front;               /* no point is both cheaper and more accurate */
} WorkPoint;

typedef struct {
  const char *label;
  const char *const *sets; /* on top of the reference case; ended by NULL */
  const double *times;     /* [n_times] */
  size_t n_times;
} WorkCase;

enum { WORK_POINTS = 4 * WORK_SCHEMES * 2 * 6 }; /* no more meshes, schemes, integrators and tolerances */

typedef struct {
  const WorkCase *of;
  WorkPoint point[WORK_POINTS];
  int n;
  WorkPoint reference; /* on the finest mesh */
} WorkPrecision;

/* About how long a run of the reference case with these knobs takes, from the table in docs/benchmarks.md:
 * only ratios matter, for the time left. */
double work_expected_seconds(const WorkKnobs *knobs);

/* Told before each run what it is and which share of the expected seconds has passed. */
typedef struct {
  void (*tell)(void *context, const char *line, double share); /* may be NULL */
  void *context;
} WorkProgress;

/* The cost and the states of one run of a case. */
Status work_run(const WorkCase *work, const WorkKnobs *knobs, int threads, RunCost *run, Error *error);

/* Runs the grid: meshes up to 5120 elements against 20480; without `full`, up to 1280 against 5120 and fewer
 * points. */
Status work_precision(const WorkCase *work, bool full, int threads, WorkProgress progress,
                      WorkPrecision *result, Error *error);

/* The last state of the run on the same mesh with the same interpolation that is converged in time. */
const RunState *work_best(const WorkPrecision *result, const WorkKnobs *knobs);

/* An error as it counts: no less than the largest part, since parts that happen to cancel are no merit. */
double work_counted(const WorkPoint *point, double error);

/* Marks the points on the Pareto front of CPU seconds and counted error in shape. */
void work_mark_front(WorkPoint *points, int n);

/* The point of least CPU seconds whose error of the given kind counts at most `limit`; NULL: there is none.
 * `offset` is offsetof(WorkError, ...). */
const WorkPoint *work_cheapest(const WorkPoint *points, int n, size_t offset, double limit);

/* "space", "quadrature" or "time": the largest part. */
const char *work_dominating(const WorkPoint *point);

/* The exponent of y ~ x^p by least squares of the logarithms; NAN for fewer than two points. */
double work_exponent(int n, const double *x, const double *y);

#endif
