#include "benchmark/benchmark_page.h"

#include "base/array.h"
#include "benchmark/benchmark_private.h"
#include "benchmark/work_page.h"
#include <math.h>

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

/* ---- time left ---- */

/* About how long the parts took, without and with `full`, when docs/benchmarks.md was written. */
static const double part_seconds[N_PARTS][2] = {
    [PAPER] = {19, 96},  [GRID_ELASTIC] = {55, 320}, [GRID_DAMAGE] = {62, 385}, [PRESETS] = {8, 45},
    [FIGURES] = {8, 42}, [RATIOS] = {9, 42},         [COSTS] = {6, 30}};

/* The share of all that has passed when `share` of the part under way has. */
static double share_of_all(const Bench *bench, double share) {
  const int column = bench->options->full;
  double passed = share * part_seconds[bench->part][column], all = 0;
  for (int k = 0; k < N_PARTS; k++) {
    if (k < (int)bench->part) passed += part_seconds[k][column];
    all += part_seconds[k][column];
  }
  return passed / all;
}

static void tell_part(void *context, const char *line, double share) {
  const Bench *bench = context;
  const WorkProgress *progress = &bench->options->progress;
  if (progress->tell) progress->tell(progress->context, line, share_of_all(bench, share));
}

void bench_tell(Bench *bench, const char *line) {
  tell_part(bench, line, 0);
}

Status bench_say(Bench *bench, const char *what) {
  bench_tell(bench, what);
  return text_append(bench->page, bench->error, "\n## %s\n\n", what);
}

/* ---- run time against error ---- */

static Status bench_case(Bench *bench, int k, Text *picture) {
  Status status;
  WorkPrecision *work = &bench->work[k];
  bench->part = k == ELASTIC ? GRID_ELASTIC : GRID_DAMAGE;
  TRY(work_precision(&cases[k], bench->options->full, BENCHMARK_THREADS, (WorkProgress){tell_part, bench},
                     work, bench->error));
  TRY(text_append(bench->page, bench->error, "\n### %s\n\n![Run time against error](%s)\n\n", titles[k],
                  benchmark_picture_names[k]));
  TRY(work_print_picture(work, titles[k], k == DAMAGE && bench->options->full ? &bench->paper : NULL, picture,
                         bench->error));
  TRY(work_print_choices(work, bench->page, bench->error));
cleanup:
  return status;
}

static Status bench_choices(Bench *bench, BenchmarkPage *page) {
  Status status;
  TRY(bench_say(bench, "Run time against error: which mesh, method and tolerance"));
  TRY(text_append(
      bench->page, bench->error,
      "Two threads, no output; CPU seconds and seconds are medians of up to five runs (one, when it takes a "
      "second).\nThe error of the shape is the largest of those of D12 and the three axes of the "
      "ellipsoid of inertia (relative), of beta/pi and of the area strain, against `fast` on %d elements "
      "with "
      "rkc3 at 1e-5; that of d_max is absolute.\nAn error counts no less than its "
      "largest part (by space, quadrature or time), so that parts that happen to cancel are no merit.\n"
      "`quartic` is `membrane.interpolation: quartic`, which pays where the membrane is smooth, not where it "
      "is "
      "compressed and wrinkles ([decision](decisions/quartic.md)).\nAll points are in the tables at the end "
      "of "
      "the page.\n",
      bench->options->full ? 20480 : 5120));
  for (int k = 0; k < N_CASES; k++) TRY(bench_case(bench, k, &page->picture[k]));
cleanup:
  return status;
}

static Status bench_grids(Bench *bench) {
  Status status;
  TRY(text_append(
      bench->page, bench->error,
      "\n## All points\n\nParts of the error of the shape, each found by turning one knob: by space, the "
      "mesh (`fast`, rkc3 1e-6) against the reference; by quadrature, the method against `reference` on the "
      "same mesh (rkc3 1e-3); by time, the step against rkc3 1e-6 on the same mesh (`fast`).\n"));
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
                           .threads = BENCHMARK_THREADS};
  bench_tell(bench, bench->paper.label);
  return benchmark_run(&bench->paper, bench->error);
}

static Status bench_paper(Bench *bench) {
  Status status;
  static const struct {
    const char *label, *sets[4];
  } runs[] = {
      {"fast, rk2 auto, whole", {"time.integrator=rk2", "symmetry=off"}},
      {"fast, rk2 auto", {"time.integrator=rk2"}},
      {"fast, rkc3 1e-4, whole", {"symmetry=off"}},
      {"fast, rkc3 1e-2", {"time.tolerance=1e-2"}},
      {"fast, rkc3 1e-3", {"time.tolerance=1e-3"}},
      {"fast, rkc3 1e-4", {"time.tolerance=1e-4"}},
      {"fast, rkc3 1e-5", {"time.tolerance=1e-5"}},
      {"fast, rkc2 1e-3", {"time.integrator=rkc2", "time.tolerance=1e-3"}},
      {"fast, rkc2 1e-4", {"time.integrator=rkc2"}},
      {"direct, rkc3 1e-4", {"fluid.method=direct"}},
  };
  RunCost best = {.sets = (const char *const[]){"fluid.method=reference", "time.tolerance=1e-6", NULL},
                  .times = damage_times,
                  .n_times = bench->paper.n_times,
                  .threads = BENCHMARK_THREADS};
  const size_t last = bench->paper.n_times - 1;
  TRY(bench_say(bench, "Against the paper's own algorithm"));
  TRY(text_append(
      bench->page, bench->error,
      "Ca = 0.7 with damage, 1280 elements, to t = %g, two threads, no output. The first row is `direct` on "
      "the whole mesh with rk2 at a step of 0.005 and the flux not removed. Errors against the method "
      "`reference` on the same mesh with rkc3 at 1e-6, the largest over t = 1, 2%s.\n\n"
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
                   .threads = BENCHMARK_THREADS};
    bench_tell(bench, run.label);
    TRY(row_of_run(bench, &run, &best));
  }
  TRY(text_append(bench->page, bench->error,
                  "\nThe converged run: D12 = %.6f, beta/pi = %.5f, d_max = %.5f, %lld evaluations.\n",
                  best.state[last].D12, best.state[last].beta / 3.14159265358979, best.state[last].d_max,
                  best.evaluations));
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
  bench->part = PRESETS;
  TRY(bench_presets(bench));
  bench->part = FIGURES;
  TRY(bench_figures(bench));
  bench->part = RATIOS;
  TRY(bench_paper(bench));
  bench->part = COSTS;
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
