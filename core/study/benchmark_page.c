#include "study/benchmark_page.h"

#include "base/array.h"
#include "base/file.h"
#include "study/benchmark.h"
#include "study/process.h"
#include "study/work_page.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ELASTIC, DAMAGE, N_CASES = BENCHMARK_PICTURES };
enum { THREADS = 2 };
const char *const benchmark_picture_names[N_CASES] = {"benchmarks-elastic.svg", "benchmarks-damage.svg"};

static const double damage_times[] = {1, 2, 5, 10}, elastic_times[] = {1, 2, 5, 8};
static const WorkCase cases[N_CASES] = {
    [ELASTIC] = {"Ca 0.6 elastic",
                 (const char *const[]){"membrane.damage=", "flow.capillary_number=0.6", NULL}, elastic_times,
                 4},
    [DAMAGE] = {"Ca 0.7 with damage", (const char *const[]){NULL}, damage_times, 4},
};
static const char *const titles[N_CASES] = {
    [ELASTIC] = "Ca = 0.6 without damage, at t = 8",
    [DAMAGE] = "Ca = 0.7 with damage, at t = 10",
};

typedef struct {
  const BenchmarkOptions *options;
  Text *page;
  Error *error;
  double kernel_rate;
  WorkPrecision work[N_CASES];
  RunCost paper; /* the paper's algorithm on the case with damage */
} Bench;

static void tell(const Bench *bench, const char *line) {
  if (bench->options->progress) bench->options->progress(line);
}

static Status say(Bench *bench, const char *what) {
  tell(bench, what);
  return text_append(bench->page, bench->error, "\n## %s\n\n", what);
}

/* ---- the single layer ---- */

static const char *const METHODS[] = {"direct", "fast", "reference"};
enum { N_METHODS = sizeof METHODS / sizeof *METHODS };

static Status bench_layer(Bench *bench) {
  static const double shapes[3][3] = {{1, 1, 1}, {2, 1, 0.5}, {3, 1, 1.0 / 3}};
  Status status = STATUS_OK;
  TRY(say(bench, "Error of the single layer"));
  TRY(text_append(
      bench->page, bench->error,
      "A rigid ellipsoid in translation (exact solution), largest error of the velocity over the nodes, "
      "relative to the velocity.\nIn brackets: difference to the method `reference` on the same surface, "
      "which leaves the error of the P2 geometry out.\n\n"
      "| method | elements | 1:1:1 | 2:1:0.5 | 3:1:1/3 |\n|---|---|---|---|---|\n"));
  for (int m = 0; m < N_METHODS; m++)
    for (int level = 2; level <= (bench->options->full ? 4 : 3); level++) {
      TRY(text_append(bench->page, bench->error, "| %s | %d |", METHODS[m], 20 << 2 * level));
      for (int k = 0; k < 3; k++) {
        LayerError layer = {.method = METHODS[m], .subdivisions = level};
        memcpy(layer.axes, shapes[k], sizeof layer.axes);
        TRY(benchmark_layer(&layer, bench->error));
        TRY(text_append(bench->page, bench->error, " %.1e (%.1e) |", layer.error, layer.quadrature));
      }
      TRY(text_append(bench->page, bench->error, "\n"));
    }
cleanup:
  return status;
}

/* ---- one evaluation ---- */

static double rate_of(const EvaluationCost *cost) {
  return 1e3 * (double)(cost->far + cost->near + cost->singular) / cost->milliseconds;
}

static Status row_of_evaluation(Bench *bench, EvaluationCost *cost) {
  Status status = STATUS_OK;
  TRY(benchmark_evaluation(cost, bench->error));
  TRY(text_append(bench->page, bench->error,
                  "| %s | %d | %s | %d | %.3f | %.3f | %lld | %lld | %lld | %.2f |\n", cost->method,
                  cost->elements, cost->symmetric ? "quarter" : "whole", cost->threads, cost->milliseconds,
                  cost->membrane_milliseconds, cost->far, cost->near, cost->singular, 1e-9 * rate_of(cost)));
cleanup:
  return status;
}

static Status summarize_evaluations(Bench *bench, EvaluationCost cost[N_METHODS][2][2]) {
  Status status;
  TRY(text_append(
      bench->page, bench->error,
      "\n| method | share of the bare kernel's rate, one thread | speed-up by two threads, whole | "
      "speed-up by symmetry, one thread | two threads |\n|---|---|---|---|---|\n"));
  for (int m = 0; m < N_METHODS; m++)
    TRY(text_append(bench->page, bench->error, "| %s | %.0f %% | %.2f | %.2f | %.2f |\n", METHODS[m],
                    100 * rate_of(&cost[m][0][0]) / bench->kernel_rate,
                    cost[m][0][0].milliseconds / cost[m][0][1].milliseconds,
                    cost[m][0][0].milliseconds / cost[m][1][0].milliseconds,
                    cost[m][0][1].milliseconds / cost[m][1][1].milliseconds));
cleanup:
  return status;
}

static Status bench_evaluation(Bench *bench) {
  Status status;
  EvaluationCost cost[N_METHODS][2][2]; /* [method][symmetric][threads - 1] */
  TRY(say(bench, "Cost of one velocity evaluation"));
  TRY(text_append(
      bench->page, bench->error,
      "On the ellipsoid 2:1:0.5, median of nine. The membrane is internal force, mass matrix and load.\n\n"
      "| method | elements | nodes summed | threads | ms | of it membrane | far pairs | near pairs | "
      "singular pairs | 10^9 pairs/s |\n|---|---|---|---|---|---|---|---|---|---|\n"));
  for (int m = 0; m < N_METHODS; m++)
    for (int symmetric = 0; symmetric < 2; symmetric++)
      for (int threads = 1; threads <= 2; threads++) {
        EvaluationCost *one = &cost[m][symmetric][threads - 1];
        *one = (EvaluationCost){
            .method = METHODS[m], .subdivisions = 3, .threads = threads, .symmetric = symmetric};
        TRY(row_of_evaluation(bench, one));
      }
  TRY(summarize_evaluations(bench, cost));
cleanup:
  return status;
}

static Status bench_growth(Bench *bench) {
  enum { COARSEST = 2, FITTED = 3, FINEST = 6 };
  Status status;
  double elements[FINEST], milliseconds[FINEST];
  int n = 0;
  TRY(say(bench, "Growth of the cost with the mesh"));
  TRY(text_append(
      bench->page, bench->error,
      "| method | elements | nodes summed | threads | ms | of it membrane | far pairs | near pairs | "
      "singular pairs | 10^9 pairs/s |\n|---|---|---|---|---|---|---|---|---|---|\n"));
  for (int level = COARSEST; level <= (bench->options->full ? FINEST : FINEST - 1); level++) {
    EvaluationCost cost = {.method = "fast", .subdivisions = level, .threads = THREADS, .symmetric = true};
    TRY(row_of_evaluation(bench, &cost));
    if (level < FITTED) continue;
    elements[n] = cost.elements;
    milliseconds[n++] = cost.milliseconds;
  }
  TRY(text_append(bench->page, bench->error,
                  "\nFrom %.0f to %.0f elements the time of an evaluation grows as the number of elements to "
                  "the power %.2f.\n",
                  elements[0], elements[n - 1], work_exponent(n, elements, milliseconds)));
cleanup:
  return status;
}

static Status bench_law(Bench *bench) {
  Status status;
  LawCost law;
  EvaluationCost whole = {.method = "fast", .subdivisions = 3, .threads = 1};
  TRY(say(bench, "Cost of a law in a plugin"));
  TRY(benchmark_law(bench->options->compiled_in, &law, bench->error));
  TRY(benchmark_evaluation(&whole, bench->error));
  TRY(text_append(bench->page, bench->error,
                  "The internal force of 1280 elements on one thread takes %.1f us with the neo-Hookean law "
                  "from its shared object and %.1f us with the same source linked into the program (medians "
                  "of 801, by turns): a difference of %.3f %% of an evaluation.\n",
                  law.plugin_microseconds, law.compiled_in_microseconds,
                  0.1 * (law.plugin_microseconds - law.compiled_in_microseconds) / whole.milliseconds));
cleanup:
  return status;
}

/* ---- run time against error ---- */

static Status bench_case(Bench *bench, int k, Text *picture) {
  Status status;
  WorkPrecision *work = &bench->work[k];
  TRY(work_precision(&cases[k], bench->options->full, THREADS, bench->options->progress, work, bench->error));
  TRY(text_append(bench->page, bench->error, "\n### %s\n\n![Run time against error](%s)\n\n", titles[k],
                  benchmark_picture_names[k]));
  TRY(work_print_picture(work, titles[k], k == DAMAGE && bench->options->full ? &bench->paper : NULL, picture,
                         bench->error));
  TRY(work_print_choices(work, bench->page, bench->error));
cleanup:
  return status;
}

static Status bench_choices(Bench *bench, BenchmarkPage *page) {
  Status status = STATUS_OK;
  TRY(say(bench, "Run time against error: which mesh, method and tolerance"));
  TRY(text_append(
      bench->page, bench->error,
      "Two threads, no output; CPU seconds and seconds are medians of up to five runs (one, when it takes "
      "three seconds).\nThe error of the shape is the largest of those of D12 and the three axes of the "
      "ellipsoid of inertia (relative), of beta/pi and of the area strain, against `fast` on %d elements "
      "with "
      "rkc2 at 1e-5; that of d_max is absolute.\nAll points are in the tables at the end of the page.\n",
      bench->options->full ? 20480 : 5120));
  for (int k = 0; k < N_CASES; k++) TRY(bench_case(bench, k, &page->picture[k]));
cleanup:
  return status;
}

static Status bench_grids(Bench *bench) {
  Status status = STATUS_OK;
  TRY(text_append(
      bench->page, bench->error,
      "\n## All points\n\nParts of the error of the shape, each found by turning one knob: by space, the "
      "mesh (`fast`, rkc2 1e-6) against the reference; by quadrature, the method against `reference` on the "
      "same mesh (rkc2 1e-4); by time, the step against rkc2 1e-6 on the same mesh (`fast`).\n"));
  for (int k = 0; k < N_CASES; k++) {
    TRY(text_append(bench->page, bench->error, "\n### %s\n\n", titles[k]));
    TRY(work_print_grid(&bench->work[k], bench->page, bench->error));
    TRY(text_append(bench->page, bench->error,
                    "\nThe same on each mesh, as far as tolerances go. While the membrane is compressed (t "
                    "below 3) it wrinkles at the scale of the mesh, for it has no bending stiffness.\n\n"));
    TRY(work_print_meshes(&bench->work[k], bench->page, bench->error));
  }
cleanup:
  return status;
}

/* ---- against the paper's algorithm ---- */

/* Largest over all times. */
static WorkError largest_error(const RunCost *run, const RunCost *best) {
  WorkError most = {0};
  for (size_t k = 0; k < run->n_times; k++) {
    const WorkError error = work_error(&run->state[k], &best->state[k]);
    most.D12 = fmax(most.D12, error.D12);
    most.shape = fmax(most.shape, error.shape);
    most.d_max = fmax(most.d_max, error.d_max);
  }
  return most;
}

static Status row_of_run(Bench *bench, RunCost *run, const RunCost *best) {
  Status status;
  if (run != &bench->paper) TRY(benchmark_run(run, bench->error));
  const WorkError error = largest_error(run, best);
  TRY(text_append(bench->page, bench->error,
                  "| %s | %.2f | %.2f | %.1f | %lld | %.3f | %.1e | %.1e | %.1e |\n", run->label,
                  run->seconds, run->cpu_seconds, bench->paper.seconds / run->seconds, run->evaluations,
                  1e-9 * (double)run->pairs, error.D12, error.shape, error.d_max));
cleanup:
  return status;
}

static Status run_paper(Bench *bench) {
  static const char *const sets[] = {"fluid.method=direct", "time.integrator=rk2",     "time.step=0.005",
                                     "symmetry=off",        "fluid.remove_flux=false", NULL};
  bench->paper = (RunCost){.label = "the paper's algorithm",
                           .sets = sets,
                           .times = damage_times,
                           .n_times = bench->options->full ? 4 : 2,
                           .threads = THREADS};
  tell(bench, bench->paper.label);
  return benchmark_run(&bench->paper, bench->error);
}

static Status bench_paper(Bench *bench) {
  Status status;
  static const struct {
    const char *label, *sets[4];
  } runs[] = {
      {"fast, rk2 auto, whole", {"time.integrator=rk2", "symmetry=off"}},
      {"fast, rk2 auto", {"time.integrator=rk2"}},
      {"fast, rkc2 1e-4, whole", {"symmetry=off"}},
      {"fast, rkc2 1e-2", {"time.tolerance=1e-2"}},
      {"fast, rkc2 1e-3", {"time.tolerance=1e-3"}},
      {"fast, rkc2 1e-4", {"time.tolerance=1e-4"}},
      {"fast, rkc2 1e-5", {"time.tolerance=1e-5"}},
      {"direct, rkc2 1e-4", {"fluid.method=direct"}},
  };
  RunCost best = {.sets = (const char *const[]){"fluid.method=reference", "time.tolerance=1e-6", NULL},
                  .times = damage_times,
                  .n_times = bench->paper.n_times,
                  .threads = THREADS};
  const size_t last = bench->paper.n_times - 1;
  TRY(say(bench, "Against the paper's own algorithm"));
  TRY(text_append(
      bench->page, bench->error,
      "Ca = 0.7 with damage, 1280 elements, to t = %g, two threads, no output. The first row is `direct` on "
      "the whole mesh with rk2 at a step of 0.005 and the flux not removed. Errors against the method "
      "`reference` on the same mesh with rkc2 at 1e-6, the largest over t = 1, 2%s.\n\n"
      "| run | seconds | CPU s | ratio to the first | evaluations | 10^9 pairs | error of D12 | of the shape "
      "| "
      "of d_max |\n|---|---|---|---|---|---|---|---|---|\n",
      bench->paper.times[last], bench->options->full ? ", 5, 10" : ""));
  TRY(benchmark_run(&best, bench->error));
  TRY(row_of_run(bench, &bench->paper, &best));
  for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
    RunCost run = {.label = runs[k].label,
                   .sets = runs[k].sets,
                   .times = damage_times,
                   .n_times = bench->paper.n_times,
                   .threads = THREADS};
    tell(bench, run.label);
    TRY(row_of_run(bench, &run, &best));
  }
  TRY(text_append(bench->page, bench->error,
                  "\nThe converged run: D12 = %.6f, beta/pi = %.5f, d_max = %.5f, %lld evaluations.\n",
                  best.state[last].D12, best.state[last].beta / 3.14159265358979, best.state[last].d_max,
                  best.evaluations));
cleanup:
  return status;
}

/* ---- single figures ---- */

static Status bench_D12(Bench *bench) {
  static const double limits[] = {4e-3, 4e-4, 4e-5};
  const WorkPrecision *work = &bench->work[ELASTIC];
  Status status;
  TRY(text_append(bench->page, bench->error, "- Ca = 0.6 without damage, D12(t = 8) = %.5f on %d elements.",
                  work->reference.run.state[3].D12, 20 << 2 * work->reference.knobs.subdivisions));
  for (int k = 0; k < 3; k++) {
    const WorkPoint *point = work_cheapest(work->point, work->n, offsetof(WorkError, D12), limits[k]);
    if (!point)
      TRY(text_append(bench->page, bench->error, " Within %g %%: not reached.", 100 * limits[k]));
    else
      TRY(text_append(
          bench->page, bench->error, " Within %g %%: %.3f CPU s (%d elements, %s, %s %s, %lld evaluations).",
          100 * limits[k], point->run.cpu_seconds, 20 << 2 * point->knobs.subdivisions, point->knobs.method,
          point->knobs.integrator, point->knobs.tolerance, point->run.evaluations));
  }
  TRY(text_append(bench->page, bench->error, "\n"));
cleanup:
  return status;
}

static Status bench_stiff(Bench *bench) {
  static const double end = 1;
  Status status;
  RunCost rk2 = {.sets = (const char *const[]){"membrane.damage=", "flow.capillary_number=0.01",
                                               "time.integrator=rk2", NULL},
                 .times = &end,
                 .n_times = 1,
                 .threads = THREADS};
  RunCost rkc2 = rk2;
  rkc2.sets = (const char *const[]){"membrane.damage=", "flow.capillary_number=0.01", NULL};
  tell(bench, "Ca 0.01");
  TRY(benchmark_run(&rkc2, bench->error));
  TRY(benchmark_run(&rk2, bench->error));
  TRY(text_append(
      bench->page, bench->error,
      "- Ca = 0.01 without damage to t = 1, 1280 elements: %lld evaluations with rk2 at its limit, "
      "%lld with rkc2 (ratio %.1f), D12 = %.6f and %.6f.\n",
      rk2.evaluations, rkc2.evaluations, (double)rk2.evaluations / (double)rkc2.evaluations, rk2.state[0].D12,
      rkc2.state[0].D12));
cleanup:
  return status;
}

static Status bench_symmetry(Bench *bench, bool is_elastic) {
  Status status;
  static const double end = 10;
  const char *whole_sets[8] = {0}, *sets[8] = {0};
  size_t n = 0;
  if (is_elastic) whole_sets[n] = sets[n] = "membrane.damage=", n++;
  whole_sets[n] = "symmetry=off";
  RunCost whole = {.sets = whole_sets, .times = &end, .n_times = 1, .threads = THREADS};
  RunCost part = {.sets = sets, .times = &end, .n_times = 1, .threads = THREADS};
  tell(bench, "a quarter against the whole");
  TRY(benchmark_run(&whole, bench->error));
  TRY(benchmark_run(&part, bench->error));
  TRY(text_append(
      bench->page, bench->error,
      "- Ca = 0.7 %s damage to t = 10, a quarter by symmetry against the whole: the shape differs by "
      "%.1e, d_max by %.1e; %.2f s against %.2f s.\n",
      is_elastic ? "without" : "with", work_error(&part.state[0], &whole.state[0]).shape,
      work_error(&part.state[0], &whole.state[0]).d_max, part.seconds, whole.seconds));
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
  char folder[] = "/tmp/capsella-bench-XXXXXX";
  ProcessCost cost;
  Text path = {0}, results = {0};
  if (!mkdtemp(folder)) return error_set(bench->error, STATUS_IO, "%s: cannot be made", folder);
  TRY(file_join(&path, folder, "scene.yaml", bench->error));
  TRY(file_join(&results, folder, "results", bench->error));
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
  file_remove_folder(folder);
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

static Status bench_figures(Bench *bench) {
  Status status;
  TRY(say(bench, "Single figures"));
  TRY(bench_D12(bench));
  TRY(bench_stiff(bench));
  TRY(bench_symmetry(bench, true));
  TRY(bench_symmetry(bench, false));
  TRY(bench_inflation(bench));
  TRY(bench_list(bench));
cleanup:
  return status;
}

/* ---- the page ---- */

Status benchmark_page(const BenchmarkOptions *options, BenchmarkPage *page, Error *error) {
  Status status;
  Bench *bench = NULL;
  TRY(ARRAY_NEW(&bench, 1, error));
  *bench = (Bench){.options = options, .page = &page->markdown, .error = error};
  bench->kernel_rate = benchmark_kernel_rate();
  TRY(text_append(
      bench->page, error,
      "# Benchmarks\n\nWritten by `capsella bench%s`.\nSeconds are of one machine on one day and noisy; "
      "counts and errors are not.\n\n",
      options->full ? " --full" : ""));
  TRY(benchmark_machine(bench->page, error));
  TRY(text_append(bench->page, error, "- bare kernel: %.2f 10^9 pairs/s on one thread\n",
                  1e-9 * bench->kernel_rate));
  TRY(run_paper(bench));
  TRY(bench_choices(bench, page));
  TRY(bench_figures(bench));
  TRY(bench_paper(bench));
  TRY(bench_evaluation(bench));
  TRY(bench_growth(bench));
  TRY(bench_law(bench));
  TRY(bench_layer(bench));
  TRY(bench_grids(bench));
cleanup:
  array_free(bench);
  return status;
}

void benchmark_page_free(BenchmarkPage *page) {
  text_free(&page->markdown);
  for (int k = 0; k < BENCHMARK_PICTURES; k++) text_free(&page->picture[k]);
}
