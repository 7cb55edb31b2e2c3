#include "benchmark/work_precision.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

WorkError work_error(const RunState *state, const RunState *reference) {
  WorkError error = {.D12 = fabs(state->D12 / reference->D12 - 1),
                     .d_max = fabs(state->d_max - reference->d_max)};
  error.shape = fmax(error.D12, fabs(state->beta - reference->beta) / PI);
  for (int i = 0; i < 3; i++) error.shape = fmax(error.shape, fabs(state->L[i] / reference->L[i] - 1));
  error.shape = fmax(error.shape, fabs(state->area_strain - reference->area_strain));
  return error;
}

/* --- the grid --- */

/* Time errors are held against TIGHT, those of quadrature against the method `reference` at USUAL. */
static const char TIGHT[] = "1e-6", USUAL[] = "1e-3";
static const char FAST[] = "fast", DIRECT[] = "direct", REFERENCE[] = "reference", RK2[] = "rk2",
                  RKC3[] = "rkc3", QUADRATIC[] = "quadratic", QUARTIC[] = "quartic";
static const char *const TOLERANCES[] = {"1e-2", "4e-3", "1e-3", "1e-4", "1e-5", "1e-6"};
enum { N_TOLERANCES = sizeof TOLERANCES / sizeof *TOLERANCES };

const WorkScheme work_schemes[WORK_SCHEMES] = {
    {QUADRATIC, FAST}, {QUADRATIC, DIRECT}, {QUADRATIC, REFERENCE}, {QUARTIC, FAST}};

/* All tolerances with `fast`; the dear methods not on the finest mesh, but for one run that shows what the
 * quadrature adds; rk2 once, for stability rules its steps. */
static bool is_in_grid(const WorkKnobs *knobs, bool full) {
  const bool is_usual = strcmp(knobs->tolerance, USUAL) == 0;
  const bool is_dear = knobs->method != FAST && knobs->subdivisions == 4;
  if (knobs->integrator == RK2)
    return is_usual && !is_dear && (full || knobs->method == FAST) && knobs->interpolation == QUADRATIC;
  if (knobs->method == FAST) return true;
  if (is_dear) return is_usual && knobs->method == REFERENCE;
  return is_usual || (full && strcmp(knobs->tolerance, TIGHT) != 0);
}

static int build_grid(bool full, WorkPoint *points) {
  static const char *const integrators[] = {RK2, RKC3};
  int n = 0;
  for (int level = 1; level <= (full ? 4 : 3); level++)
    for (int m = 0; m < WORK_SCHEMES; m++)
      for (int i = 0; i < 2; i++)
        for (int t = 0; t < N_TOLERANCES; t++) {
          const WorkKnobs knobs = {level, work_schemes[m].interpolation, work_schemes[m].method,
                                   integrators[i], TOLERANCES[t]};
          if (is_in_grid(&knobs, full)) points[n++] = (WorkPoint){.knobs = knobs};
        }
  return n;
}

/* Powers read off the table: of the number of elements, of the digits asked for, and what a dear method or
 * integrator costs on top of that. */
double work_expected_seconds(const WorkKnobs *knobs) {
  const double size = pow(4, knobs->subdivisions - 3), digits = -log10(strtod(knobs->tolerance, NULL));
  double seconds = 0.5 * pow(size, 1.3) * pow(1.6, digits - 2);
  if (strcmp(knobs->integrator, RK2) == 0) seconds *= 6 * sqrt(size);
  if (strcmp(knobs->method, DIRECT) == 0) seconds *= 4 * pow(size, 0.6);
  if (strcmp(knobs->method, REFERENCE) == 0) seconds *= 1.5;
  return seconds;
}

static void tell(const WorkCase *work, const WorkKnobs *knobs, WorkProgress progress, double share) {
  char line[160];
  if (!progress.tell) return;
  snprintf(line, sizeof line, "%s: %d elements, %s, %s, %s %s", work->label, 20 << 2 * knobs->subdivisions,
           knobs->interpolation, knobs->method, knobs->integrator, knobs->tolerance);
  progress.tell(progress.context, line, share);
}

Status work_run(const WorkCase *work, const WorkKnobs *knobs, int threads, RunCost *run, Error *error) {
  char mesh[40], interpolation[40], method[40], integrator[40], tolerance[40];
  const char *sets[16];
  size_t n = 0;
  snprintf(mesh, sizeof mesh, "capsule.mesh.subdivisions=%d", knobs->subdivisions);
  snprintf(interpolation, sizeof interpolation, "membrane.interpolation=%s", knobs->interpolation);
  snprintf(method, sizeof method, "fluid.method=%s", knobs->method);
  snprintf(integrator, sizeof integrator, "time.integrator=%s", knobs->integrator);
  snprintf(tolerance, sizeof tolerance, "time.tolerance=%s", knobs->tolerance);
  for (; work->sets[n]; n++) sets[n] = work->sets[n];
  sets[n++] = mesh;
  sets[n++] = interpolation;
  sets[n++] = method;
  sets[n++] = integrator;
  sets[n++] = tolerance;
  sets[n] = NULL;
  *run = (RunCost){.sets = sets, .times = work->times, .n_times = work->n_times, .threads = threads};
  const Status status = benchmark_run(run, error);
  run->sets = NULL; /* gone with this call */
  return status;
}

/* --- errors --- */

static const RunState *last_state(const WorkPoint *point) {
  return &point->run.state[point->run.n_times - 1];
}

static const RunState *find_state(const WorkPrecision *result, WorkKnobs knobs) {
  for (int k = 0; k < result->n; k++) {
    const WorkKnobs *other = &result->point[k].knobs;
    if (other->subdivisions == knobs.subdivisions && strcmp(other->method, knobs.method) == 0 &&
        strcmp(other->interpolation, knobs.interpolation) == 0 &&
        strcmp(other->integrator, knobs.integrator) == 0 && strcmp(other->tolerance, knobs.tolerance) == 0)
      return last_state(&result->point[k]);
  }
  return NULL;
}

const RunState *work_best(const WorkPrecision *result, const WorkKnobs *knobs) {
  WorkKnobs best = *knobs;
  best.method = FAST;
  best.integrator = RKC3;
  best.tolerance = TIGHT;
  return find_state(result, best);
}

/* Each part varies one knob and keeps the others where they are known best or matter least. */
static void split_error(WorkPrecision *result, WorkPoint *point) {
  const WorkKnobs *knobs = &point->knobs;
  WorkKnobs other = *knobs;
  other.method = FAST;
  const RunState *stepped = find_state(result, other), *best = work_best(result, knobs);
  const RunState *summed =
      find_state(result, (WorkKnobs){knobs->subdivisions, QUADRATIC, knobs->method, RKC3, USUAL});
  const RunState *exact =
      find_state(result, (WorkKnobs){knobs->subdivisions, QUADRATIC, REFERENCE, RKC3, USUAL});
  point->error = work_error(last_state(point), last_state(&result->reference));
  point->space = work_error(best, last_state(&result->reference)).shape;
  point->time = work_error(stepped, best).shape;
  point->quadrature = work_error(summed, exact).shape;
}

double work_counted(const WorkPoint *point, double error) {
  return fmax(fmax(error, point->space), fmax(point->quadrature, point->time));
}

void work_mark_front(WorkPoint *points, int n) {
  for (int k = 0; k < n; k++) {
    points[k].is_on_front = true;
    for (int j = 0; j < n; j++)
      if (points[j].run.cpu_seconds < points[k].run.cpu_seconds &&
          work_counted(&points[j], points[j].error.shape) <= work_counted(&points[k], points[k].error.shape))
        points[k].is_on_front = false;
  }
}

const WorkPoint *work_cheapest(const WorkPoint *points, int n, size_t offset, double limit) {
  const WorkPoint *best = NULL;
  for (int k = 0; k < n; k++) {
    const double error = *(const double *)((const char *)&points[k].error + offset);
    if (work_counted(&points[k], error) <= limit &&
        (!best || points[k].run.cpu_seconds < best->run.cpu_seconds))
      best = &points[k];
  }
  return best;
}

const char *work_dominating(const WorkPoint *point) {
  if (point->space >= point->quadrature && point->space >= point->time) return "space";
  return point->quadrature >= point->time ? "quadrature" : "time";
}

double work_exponent(int n, const double *x, const double *y) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (int k = 0; k < n; k++) {
    mean_x += log(x[k]) / n;
    mean_y += log(y[k]) / n;
  }
  for (int k = 0; k < n; k++) {
    xx += pow(log(x[k]) - mean_x, 2);
    xy += (log(x[k]) - mean_x) * (log(y[k]) - mean_y);
  }
  return n < 2 ? NAN : xy / xx;
}

Status work_precision(const WorkCase *work, bool full, int threads, WorkProgress progress,
                      WorkPrecision *result, Error *error) {
  Status status;
  *result =
      (WorkPrecision){.of = work, .reference = {.knobs = {full ? 5 : 4, QUADRATIC, FAST, RKC3, "1e-5"}}};
  result->n = build_grid(full, result->point);
  double expected = work_expected_seconds(&result->reference.knobs), passed = expected;
  for (int k = 0; k < result->n; k++) expected += work_expected_seconds(&result->point[k].knobs);
  tell(work, &result->reference.knobs, progress, 0);
  TRY(work_run(work, &result->reference.knobs, threads, &result->reference.run, error));
  for (int k = 0; k < result->n; k++) {
    tell(work, &result->point[k].knobs, progress, passed / expected);
    TRY(work_run(work, &result->point[k].knobs, threads, &result->point[k].run, error));
    passed += work_expected_seconds(&result->point[k].knobs);
  }
  for (int k = 0; k < result->n; k++) split_error(result, &result->point[k]);
  work_mark_front(result->point, result->n);
cleanup:
  return status;
}
