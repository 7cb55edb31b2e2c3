/* Sections of the page of benchmarks: the single layer, one evaluation, a law. */
#include "benchmark/benchmark_private.h"
#include "benchmark/law_timing.h"
#include <string.h>

/* ---- the single layer ---- */

static const char *const METHODS[] = {"direct", "fast", "reference"};
enum { N_METHODS = sizeof METHODS / sizeof *METHODS };

Status bench_layer(Bench *bench) {
  static const double shapes[3][3] = {{1, 1, 1}, {2, 1, 0.5}, {3, 1, 1.0 / 3}};
  Status status;
  TRY(bench_say(bench, "Error of the single layer"));
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
  Status status;
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

Status bench_evaluation(Bench *bench) {
  Status status;
  EvaluationCost cost[N_METHODS][2][2]; /* [method][symmetric][threads - 1] */
  TRY(bench_say(bench, "Cost of one velocity evaluation"));
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

Status bench_growth(Bench *bench) {
  enum { COARSEST = 2, FITTED = 3, FINEST = 6 };
  Status status;
  double elements[FINEST], milliseconds[FINEST];
  int n = 0;
  TRY(bench_say(bench, "Growth of the cost with the mesh"));
  TRY(text_append(
      bench->page, bench->error,
      "| method | elements | nodes summed | threads | ms | of it membrane | far pairs | near pairs | "
      "singular pairs | 10^9 pairs/s |\n|---|---|---|---|---|---|---|---|---|---|\n"));
  for (int level = COARSEST; level <= (bench->options->full ? FINEST : FINEST - 1); level++) {
    EvaluationCost cost = {
        .method = "fast", .subdivisions = level, .threads = BENCHMARK_THREADS, .symmetric = true};
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

Status bench_law(Bench *bench) {
  Status status;
  LawCost law;
  EvaluationCost whole = {.method = "fast", .subdivisions = 3, .threads = 1};
  TRY(bench_say(bench, "Cost of a law in a plugin"));
  TRY(benchmark_law(bench->options->compiled_in, &law, bench->error));
  TRY(benchmark_evaluation(&whole, bench->error));
  TRY(text_append(bench->page, bench->error,
                  "The internal force of 1280 elements on one thread takes %.1f us with the neo-Hookean law "
                  "from its shared object and %.1f us with the same source linked into the program (medians "
                  "of 801, by turns): a difference of %.3f %% of an evaluation.\n",
                  law.plugin_microseconds, law.compiled_in_microseconds,
                  0.1 * (law.plugin_microseconds - law.compiled_in_microseconds) / whole.milliseconds));
  TRY(text_append(bench->page, bench->error,
                  "\nCalls of the laws that ship, on one thread (shares are of an evaluation of all 1280 "
                  "elements, 7680 points):\n\n"));
  TRY(law_timing_print(whole.milliseconds, 7680, bench->page, bench->error));
cleanup:
  return status;
}
