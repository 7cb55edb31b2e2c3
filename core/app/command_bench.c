/* capsella bench: run time against error on this machine, as a page of Markdown. */
#include "app/commands.h"
#include "base/file.h"
#include "study/benchmark.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const char USAGE[] =
    "usage: capsella bench [--full] [-o DIR]\n"
    "\n"
    "Measures the accuracy of the single layer, the cost of one evaluation and whole runs of the reference "
    "case, and\n"
    "writes benchmarks.md into DIR (default: standard output).\n"
    "\n"
    "  --full   runs to t = 10 and finer meshes: up to an hour (without: to t = 2, a minute or two)\n";

static const char *const METHODS[] = {"direct", "fast", "reference"};
enum { N_METHODS = sizeof METHODS / sizeof *METHODS };

typedef struct {
  Text page;
  bool full;
  Error error;
} Bench;

static Status say(Bench *bench, const char *what) {
  fprintf(stderr, "capsella bench: %s\n", what);
  return text_append(&bench->page, &bench->error, "\n## %s\n\n", what);
}

/* ---- the single layer ---- */

static Status bench_layer(Bench *bench) {
  static const double shapes[3][3] = {{1, 1, 1}, {2, 1, 0.5}, {3, 1, 1.0 / 3}};
  Status status = STATUS_OK;
  Error *error = &bench->error;
  TRY(say(bench, "Error of the single layer"));
  TRY(text_append(
      &bench->page, error,
      "A rigid ellipsoid in translation (exact solution), largest error of the velocity over the nodes, "
      "relative to the velocity.\nIn brackets: difference to the method `reference` on the same surface, "
      "which leaves the error of the P2 geometry out.\n\n"
      "| method | elements | 1:1:1 | 2:1:0.5 | 3:1:1/3 |\n|---|---|---|---|---|\n"));
  for (int m = 0; m < N_METHODS; m++)
    for (int level = 2; level <= (bench->full ? 4 : 3); level++) {
      TRY(text_append(&bench->page, error, "| %s | %d |", METHODS[m], 20 << 2 * level));
      for (int k = 0; k < 3; k++) {
        LayerError layer = {.method = METHODS[m], .subdivisions = level};
        memcpy(layer.axes, shapes[k], sizeof layer.axes);
        TRY(benchmark_layer(&layer, error));
        TRY(text_append(&bench->page, error, " %.1e (%.1e) |", layer.error, layer.quadrature));
      }
      TRY(text_append(&bench->page, error, "\n"));
    }
cleanup:
  return status;
}

/* ---- one evaluation ---- */

static Status row_of_evaluation(Bench *bench, EvaluationCost cost) {
  Status status = STATUS_OK;
  TRY(benchmark_evaluation(&cost, &bench->error));
  const long long pairs = cost.far + cost.near + cost.singular;
  TRY(text_append(&bench->page, &bench->error,
                  "| %s | %d | %s | %d | %.3f | %.3f | %lld | %lld | %lld | %.2f |\n", cost.method,
                  cost.elements, cost.symmetric ? "quarter" : "whole", cost.threads, cost.milliseconds,
                  cost.membrane_milliseconds, cost.far, cost.near, cost.singular,
                  1e-6 * (double)pairs / cost.milliseconds));
cleanup:
  return status;
}

static Status bench_evaluation(Bench *bench) {
  Status status = STATUS_OK;
  TRY(say(bench, "Cost of one velocity evaluation"));
  TRY(text_append(
      &bench->page, &bench->error,
      "On the ellipsoid 2:1:0.5, median of nine. The membrane is internal force, mass matrix and load.\n\n"
      "| method | elements | nodes summed | threads | ms | of it membrane | far pairs | near pairs | "
      "singular pairs | 10^9 pairs/s |\n|---|---|---|---|---|---|---|---|---|---|\n"));
  for (int m = 0; m < N_METHODS; m++)
    for (int symmetric = 0; symmetric < 2; symmetric++)
      for (int threads = 1; threads <= 2; threads++)
        TRY(row_of_evaluation(
            bench, (EvaluationCost){
                       .method = METHODS[m], .subdivisions = 3, .threads = threads, .symmetric = symmetric}));
  for (int level = 2; level <= (bench->full ? 6 : 4); level++)
    if (level != 3)
      TRY(row_of_evaluation(
          bench, (EvaluationCost){.method = "fast", .subdivisions = level, .threads = 2, .symmetric = true}));
cleanup:
  return status;
}

/* ---- whole runs ---- */

static double error_of(const RunCost *run, const RunCost *best) {
  double most = fmax(fabs(run->D12 - best->D12), fabs(run->beta - best->beta) / 3.14159265358979);
  for (int i = 0; i < 3; i++) most = fmax(most, fabs(run->L[i] - best->L[i]));
  return fmax(most, fabs(run->area_strain - best->area_strain));
}

static Status bench_runs(Bench *bench) {
  Status status = STATUS_OK;
  Error *error = &bench->error;
  const char *end = bench->full ? "time.end=10" : "time.end=2";
  RunCost best = {.sets = (const char *const[]){end, "fluid.method=reference", "time.tolerance=1e-6", NULL},
                  .threads = 2};
  RunCost runs[] = {
      {.label = "the paper's algorithm: direct, rk2 at 0.005, whole",
       .sets = (const char *const[]){end, "fluid.method=direct", "time.integrator=rk2", "time.step=0.005",
                                     "symmetry=off", "fluid.remove_flux=false", NULL}},
      {.label = "fast, rk2 auto, whole",
       .sets = (const char *const[]){end, "time.integrator=rk2", "symmetry=off", NULL}},
      {.label = "fast, rk2 auto", .sets = (const char *const[]){end, "time.integrator=rk2", NULL}},
      {.label = "fast, rkc2 1e-4, whole", .sets = (const char *const[]){end, "symmetry=off", NULL}},
      {.label = "fast, rkc2 1e-2", .sets = (const char *const[]){end, "time.tolerance=1e-2", NULL}},
      {.label = "fast, rkc2 1e-3", .sets = (const char *const[]){end, "time.tolerance=1e-3", NULL}},
      {.label = "fast, rkc2 1e-4", .sets = (const char *const[]){end, "time.tolerance=1e-4", NULL}},
      {.label = "fast, rkc2 1e-5", .sets = (const char *const[]){end, "time.tolerance=1e-5", NULL}},
      {.label = "direct, rkc2 1e-4", .sets = (const char *const[]){end, "fluid.method=direct", NULL}},
  };
  TRY(say(bench, "Whole runs of the reference case"));
  TRY(text_append(
      &bench->page, error,
      "Ca = 0.7, damage, 1280 elements, %s, two threads, no output. Errors against the method `reference` "
      "with rkc2 at tolerance 1e-6: of the shape, the largest of |D12|, |beta|/pi, |L_i|, |area strain|; "
      "and of d_max.\n\n"
      "| run | seconds | CPU s | ratio to the first | evaluations | 10^9 pairs | error of D12 | of the "
      "shape | of d_max |\n|---|---|---|---|---|---|---|---|---|\n",
      end));
  TRY(benchmark_run(&best, error));
  for (size_t i = 0; i < sizeof runs / sizeof *runs; i++) {
    RunCost *run = &runs[i];
    run->threads = 2;
    fprintf(stderr, "  %s\n", run->label);
    TRY(benchmark_run(run, error));
    TRY(text_append(&bench->page, error, "| %s | %.2f | %.2f | %.1f | %lld | %.3f | %.1e | %.1e | %.1e |\n",
                    run->label, run->seconds, run->cpu_seconds, runs[0].seconds / run->seconds,
                    run->evaluations, 1e-9 * (double)run->pairs, fabs(run->D12 - best.D12),
                    error_of(run, &best), fabs(run->d_max - best.d_max)));
  }
  TRY(text_append(&bench->page, error,
                  "\nThe converged run: D12 = %.6f, beta/pi = %.5f, d_max = %.5f, %lld evaluations.\n",
                  best.D12, best.beta / 3.14159265358979, best.d_max, best.evaluations));
cleanup:
  return status;
}

/* ---- the page ---- */

static Status measure(Bench *bench) {
  Status status = STATUS_OK;
  TRY(text_append(
      &bench->page, &bench->error,
      "# Benchmarks\n\nWritten by `capsella bench%s`.\nSeconds are of one machine on one day and noisy; "
      "counts and errors are not.\n\n",
      bench->full ? " --full" : ""));
  TRY(benchmark_machine(&bench->page, &bench->error));
  TRY(bench_layer(bench));
  TRY(bench_evaluation(bench));
  TRY(bench_runs(bench));
cleanup:
  return status;
}

static Status deliver(Bench *bench, const char *folder) {
  Status status = STATUS_OK;
  Text path = {0};
  if (!folder) {
    fputs(bench->page.data, stdout);
    return STATUS_OK;
  }
  TRY(file_make_folder(folder, &bench->error));
  TRY(file_join(&path, folder, "benchmarks.md", &bench->error));
  TRY(file_write(path.data, bench->page.data, bench->page.length, &bench->error));
  printf("%s\n", path.data);
cleanup:
  text_free(&path);
  return status;
}

int command_bench(int argc, char **argv) {
  Bench bench = {0};
  const char *folder = NULL;
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--full") == 0) {
      bench.full = true;
    } else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
      folder = argv[++i];
    } else {
      const bool help = strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0;
      fputs(USAGE, help ? stdout : stderr);
      return help ? EXIT_DONE : EXIT_INPUT;
    }
  }
  Status status = measure(&bench);
  if (status == STATUS_OK) status = deliver(&bench, folder);
  if (status != STATUS_OK) fprintf(stderr, "%s\n", bench.error.text);
  text_free(&bench.page);
  return exit_code(status);
}
