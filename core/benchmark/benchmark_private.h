/* What the files that write the page of benchmarks share. */
#ifndef CAPSELLA_BENCHMARK_BENCHMARK_PRIVATE_H
#define CAPSELLA_BENCHMARK_BENCHMARK_PRIVATE_H

#include "benchmark/benchmark.h"
#include "benchmark/benchmark_page.h"
#include "benchmark/work_precision.h"

enum { ELASTIC, DAMAGE, N_CASES = BENCHMARK_PICTURES };
enum { BENCHMARK_THREADS = 2 };

typedef enum { PAPER, GRID_ELASTIC, GRID_DAMAGE, PRESETS, FIGURES, RATIOS, COSTS, N_PARTS } BenchPart;

typedef struct {
  const BenchmarkOptions *options;
  Text *page;
  Error *error;
  BenchPart part; /* under way */
  double kernel_rate;
  WorkPrecision work[N_CASES];
  RunCost paper; /* the paper's algorithm on the case with damage */
} Bench;

/* Names what is measured next to who waits for it. */
void bench_tell(Bench *bench, const char *line);
/* The same, as the title of a section. */
Status bench_say(Bench *bench, const char *what);

/* Sections, in benchmark_costs.c: */
Status bench_evaluation(Bench *bench);
Status bench_growth(Bench *bench);
Status bench_law(Bench *bench);
Status bench_layer(Bench *bench);
/* and in benchmark_figures.c: */
Status bench_presets(Bench *bench);
Status bench_figures(Bench *bench);

#endif
