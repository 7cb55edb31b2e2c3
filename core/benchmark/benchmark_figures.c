/* Sections of the page of benchmarks: what `accuracy` gives, and figures of one line each. */
#include "base/array.h"
#include "base/file.h"
#include "benchmark/benchmark_private.h"
#include "benchmark/process.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The mesh of the single figures. */
static const char *usual_mesh(const Bench *bench) {
  return bench->options->full ? "capsule.mesh.subdivisions=3" : "capsule.mesh.subdivisions=2";
}
static int usual_elements(const Bench *bench) {
  return bench->options->full ? 1280 : 320;
}

/* ---- what `accuracy` gives ---- */

/* Largest over all times; without D12 before it has grown. */
static double time_and_quadrature(const RunCost *run, const RunCost *best, double *d_max) {
  double shape = 0;
  *d_max = 0;
  for (size_t k = 0; k < run->n_times; k++) {
    const WorkError error = work_error(&run->state[k], &best->state[k]);
    shape = fmax(shape, error.shape);
    *d_max = fmax(*d_max, error.d_max);
  }
  return shape;
}

static const char *const presets[] = {"accuracy=draft", "accuracy=standard", "accuracy=fine"};
enum { N_PRESETS = sizeof presets / sizeof *presets };

static Status preset_rows(Bench *bench, const char *name, const char *capillary_number, const char *damage) {
  static const double times[] = {1, 2, 4};
  const char *mesh = usual_mesh(bench);
  Status status;
  RunCost best = {.sets = (const char *const[]){mesh, capillary_number, "fluid.method=reference",
                                                "time.tolerance=1e-7", damage, NULL},
                  .times = times,
                  .n_times = 3,
                  .threads = BENCHMARK_THREADS};
  bench_tell(bench, name);
  TRY(benchmark_run(&best, bench->error));
  for (int k = 0; k < N_PRESETS; k++) {
    double d_max;
    RunCost run = best;
    run.sets = (const char *const[]){mesh, capillary_number, presets[k], damage, NULL};
    TRY(benchmark_run(&run, bench->error));
    const double shape = time_and_quadrature(&run, &best, &d_max);
    TRY(text_append(bench->page, bench->error, "| %s | `%s` | %.1e | %.1e | %lld | %.3f | %.3f |\n", name,
                    presets[k] + sizeof "accuracy", shape, d_max, run.evaluations, run.cpu_seconds,
                    run.seconds));
  }
cleanup:
  return status;
}

static Status preset_ruptures(Bench *bench) {
  static const char capillary_number[] = "flow.capillary_number=0.8";
  const char *mesh = usual_mesh(bench);
  Status status;
  RuptureCost best = {.sets = (const char *const[]){mesh, capillary_number, "fluid.method=reference",
                                                    "time.tolerance=1e-7", NULL},
                      .threads = BENCHMARK_THREADS};
  bench_tell(bench, "rupture at Ca 0.8");
  TRY(benchmark_rupture(&best, bench->error));
  TRY(text_append(bench->page, bench->error,
                  "\nRupture at Ca = 0.8 on the same mesh, against t_c = %.5f and t_l = %.5f:\n\n"
                  "| `accuracy` | t_c off by | t_l off by | evaluations | CPU s | seconds |\n"
                  "|---|---|---|---|---|---|\n",
                  best.t_c, best.t_l));
  for (int k = 0; k < N_PRESETS; k++) {
    RuptureCost run = {.sets = (const char *const[]){mesh, capillary_number, presets[k], NULL},
                       .threads = BENCHMARK_THREADS};
    TRY(benchmark_rupture(&run, bench->error));
    TRY(text_append(bench->page, bench->error, "| `%s` | %.2f %% | %.2f %% | %lld | %.3f | %.3f |\n",
                    presets[k] + sizeof "accuracy", 100 * fabs(run.t_c / best.t_c - 1),
                    100 * fabs(run.t_l / best.t_l - 1), run.evaluations, run.cpu_seconds, run.seconds));
  }
cleanup:
  return status;
}

Status bench_presets(Bench *bench) {
  Status status;
  TRY(bench_say(bench, "What `accuracy` gives"));
  TRY(text_append(
      bench->page, bench->error,
      "Errors of time and quadrature together, on %d elements to t = 4: largest difference at t = 1, 2, 4 to "
      "`reference` with rkc3 at 1e-7 on the same mesh. The aims are 1 %%, 0.1 %% and 0.01 %% of the shape; "
      "the "
      "error of the mesh comes on top, and the tables above tell which mesh suits.\n\n"
      "| scene | `accuracy` | error of the shape | of d_max | evaluations | CPU s | seconds "
      "|\n|---|---|---|---|---|---|---|\n",
      usual_elements(bench)));
  TRY(preset_rows(bench, "Ca 0.3", "flow.capillary_number=0.3", "membrane.damage="));
  TRY(preset_rows(bench, "Ca 0.6", "flow.capillary_number=0.6", "membrane.damage="));
  TRY(preset_rows(bench, "Ca 0.7, damage", "flow.capillary_number=0.7", NULL));
  TRY(preset_rows(bench, "Ca 0.8, damage, before rupture", "flow.capillary_number=0.8", NULL));
  TRY(preset_ruptures(bench));
cleanup:
  return status;
}

/* ---- single figures ---- */

/* A point of the grid run again on one thread, straight to the last time. */
typedef struct {
  const WorkPoint *point;
  RunCost run;
  double error; /* of D12, and no less than its parts by space and time */
} Straight;

static double off(double value, double from) {
  return fabs(value / from - 1);
}

static Status run_straight(const WorkPrecision *work, const WorkPoint *point, Straight *straight,
                           Error *error) {
  const WorkCase *of = work->of;
  const size_t last = of->n_times - 1;
  const WorkCase only = {of->label, of->sets, &of->times[last], 1};
  const double best = work_best(work, &point->knobs)->D12, exact = work->reference.run.state[last].D12;
  *straight = (Straight){.point = point};
  const Status status = work_run(&only, &point->knobs, 1, &straight->run, error);
  if (status != STATUS_OK) return status;
  const double D12 = straight->run.state[0].D12;
  straight->error = fmax(off(D12, exact), fmax(off(best, exact), off(D12, best)));
  return STATUS_OK;
}

static bool is_candidate(const WorkKnobs *knobs) {
  return strcmp(knobs->method, "fast") == 0 && strcmp(knobs->integrator, "rkc3") == 0 &&
         strtod(knobs->tolerance, NULL) >= 1e-5 && knobs->subdivisions <= 3;
}

static Status bench_D12(Bench *bench) {
  static const double limits[] = {4e-3, 4e-4, 4e-5};
  const WorkPrecision *work = &bench->work[ELASTIC];
  const size_t last = work->of->n_times - 1;
  Straight best[3] = {{0}};
  Status status;
  for (int k = 0; k < work->n; k++) {
    Straight straight;
    if (!is_candidate(&work->point[k].knobs)) continue;
    TRY(run_straight(work, &work->point[k], &straight, bench->error));
    for (int i = 0; i < 3; i++)
      if (straight.error <= limits[i] &&
          (!best[i].point || straight.run.cpu_seconds < best[i].run.cpu_seconds))
        best[i] = straight;
  }
  TRY(text_append(
      bench->page, bench->error,
      "- Ca = 0.6 without damage, D12(t = 8) = %.5f on %d elements. On one thread, straight to t = 8:",
      work->reference.run.state[last].D12, 20 << 2 * work->reference.knobs.subdivisions));
  for (int i = 0; i < 3; i++) {
    if (!best[i].point) {
      TRY(text_append(bench->page, bench->error, " within %g %%: not reached%s", 100 * limits[i],
                      i < 2 ? ";" : "."));
      continue;
    }
    const WorkKnobs *knobs = &best[i].point->knobs;
    TRY(text_append(
        bench->page, bench->error,
        " within %g %%: %.3f CPU s (%d elements, %s, %s, %s %s, %lld evaluations, off by %.4f %%)%s",
        100 * limits[i], best[i].run.cpu_seconds, 20 << 2 * knobs->subdivisions, knobs->interpolation,
        knobs->method, knobs->integrator, knobs->tolerance, best[i].run.evaluations, 100 * best[i].error,
        i < 2 ? ";" : "."));
  }
  TRY(text_append(bench->page, bench->error, "\n"));
cleanup:
  return status;
}

/* To one time, on two threads. */
static RunCost run_to(const double *end, const char *const *sets) {
  return (RunCost){.sets = sets, .times = end, .n_times = 1, .threads = BENCHMARK_THREADS};
}

static Status bench_stiff(Bench *bench) {
  static const double end = 1;
  const char *mesh = usual_mesh(bench);
  const char *const rk2_sets[] = {mesh, "membrane.damage=", "flow.capillary_number=0.01",
                                  "time.integrator=rk2", NULL};
  const char *const own_sets[] = {mesh, "membrane.damage=", "flow.capillary_number=0.01", NULL};
  Status status;
  RunCost rk2 = run_to(&end, rk2_sets), own = run_to(&end, own_sets);
  bench_tell(bench, "Ca 0.01");
  TRY(benchmark_run(&own, bench->error));
  TRY(benchmark_run(&rk2, bench->error));
  TRY(text_append(bench->page, bench->error,
                  "- Ca = 0.01 without damage to t = 1, %d elements: %lld evaluations with rk2 at its limit, "
                  "%lld with rkc3 (ratio %.1f), D12 = %.6f and %.6f.\n",
                  usual_elements(bench), rk2.evaluations, own.evaluations,
                  (double)rk2.evaluations / (double)own.evaluations, rk2.state[0].D12, own.state[0].D12));
cleanup:
  return status;
}

static Status bench_symmetry(Bench *bench, const char *damage, const char *words) {
  static const double end = 10;
  const char *mesh = usual_mesh(bench);
  const char *const whole_sets[] = {mesh, "symmetry=off", damage, NULL}, *const sets[] = {mesh, damage, NULL};
  Status status;
  RunCost whole = run_to(&end, whole_sets), part = run_to(&end, sets);
  bench_tell(bench, "a quarter against the whole");
  TRY(benchmark_run(&whole, bench->error));
  TRY(benchmark_run(&part, bench->error));
  const WorkError error = work_error(&part.state[0], &whole.state[0]);
  TRY(text_append(bench->page, bench->error,
                  "- Ca = 0.7 %s damage to t = 10, %d elements, a quarter by symmetry against the whole: the "
                  "shape differs by %.1e, d_max by %.1e; %.2f s against %.2f s.\n",
                  words, usual_elements(bench), error.shape, error.d_max, part.seconds, whole.seconds));
cleanup:
  return status;
}

static Status bench_inflation(Bench *bench) {
  Status status;
  static const char scene[] = "schema: 1\n"
                              "membrane:\n"
                              "  law: neo_hookean\n"
                              "  damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: 2.0}}\n"
                              "flow: {kind: inflation, path: [[0, 0], [1, 0.9]]}\n"
                              "time: {end: 1}\n"
                              "output: {history_every: 0.005, snapshot_every: 0}\n";
  ProcessCost cost;
  Text folder = {0}, path = {0}, results = {0};
  TRY(file_join(&folder, bench->options->folder, "inflation", bench->error));
  TRY(file_make_folder(folder.data, bench->error));
  TRY(file_join(&path, folder.data, "scene.yaml", bench->error));
  TRY(file_join(&results, folder.data, "results", bench->error));
  TRY(file_write(path.data, scene, sizeof scene - 1, bench->error));
  TRY(process_measure(
      (const char *const[]){bench->options->program, "run", path.data, "--quiet", "-o", results.data, NULL},
      &cost, bench->error));
  TRY(text_append(
      bench->page, bench->error,
      "- `capsella run`, inflation of 1280 elements with damage, 200 samples: %.3f CPU s, %.3f s for "
      "the whole program.\n",
      cost.cpu_seconds, cost.seconds));
cleanup:
  if (folder.data) file_remove_folder(folder.data);
  text_free(&folder);
  text_free(&path);
  text_free(&results);
  return status;
}

static Status bench_list(Bench *bench) {
  Status status;
  ProcessCost cost;
  TRY(process_measure((const char *const[]){bench->options->program, "laws", "list", NULL}, &cost,
                      bench->error));
  TRY(text_append(bench->page, bench->error, "- `capsella laws list`: %.1f ms for the whole program.\n",
                  1e3 * cost.seconds));
cleanup:
  return status;
}

Status bench_figures(Bench *bench) {
  Status status;
  TRY(bench_say(bench, "Single figures"));
  TRY(bench_D12(bench));
  TRY(bench_stiff(bench));
  TRY(bench_symmetry(bench, "membrane.damage=", "without"));
  TRY(bench_symmetry(bench, NULL, "with"));
  TRY(bench_inflation(bench));
  TRY(bench_list(bench));
cleanup:
  return status;
}
