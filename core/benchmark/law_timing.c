#include "benchmark/law_timing.h"

#include "base/array.h"
#include "base/timer.h"
#include "laws/conformance_sample.h"
#include <stdlib.h>

const int law_batch_points[LAW_BATCHES] = {6, 96, 1536};

enum { LARGEST = 1536, REPEATS = 9 };
static const double SHORTEST = 5e-4; /* seconds of one measurement: a thousand times the timer's resolution */

/* A batch of a law, with the points of a sample over and over. */
typedef struct {
  Subject subject;
  mlaw_field field[MAX_PARAMS];
  Sample sample;
  double in[MAX_ROWS * LARGEST], out[MAX_ROWS * LARGEST];
  int n;
} Load;

static void fill(Load *load, int n) {
  load->n = n;
  for (int row = 0; row < kernel_inputs(&load->subject); row++)
    for (int i = 0; i < n; i++)
      load->in[row * n + i] = load->sample.in[row * load->sample.ld + i % load->sample.n];
}

/* The evolution alone, as a run calls it: the kernel of the conformance suite asks for the threshold too. */
static int call_evolution(Load *load, mlaw_error *err) {
  const double *chan[MLAW_N_CHANNELS] = {[MLAW_Y] = load->in};
  const mlaw_damage_args arguments = {.size = sizeof arguments,
                                      .n_channels = MLAW_N_CHANNELS,
                                      .n = load->n,
                                      .ld = load->n,
                                      .param = load->field,
                                      .chan = chan,
                                      .d0 = load->in + load->n,
                                      .zeta = load->out,
                                      .err = err};
  return load->subject.damage->evolution(&arguments);
}

static int call(Load *load) {
  KernelCall kernel = {.n = load->n,
                       .ld = load->n,
                       .param = load->field,
                       .in = load->in,
                       .out = load->out,
                       .without = load->subject.energy && load->subject.energy->flags & MLAW_HESSIAN ? 3 : -1,
                       .dt = 1e-3};
  const bool is_explicit = load->subject.damage && load->subject.damage->evolution;
  return is_explicit ? call_evolution(load, &kernel.err) : kernel_call(&load->subject, &kernel);
}

static double time_calls(Load *load, long calls) {
  const double start = timer_wall_seconds();
  for (long k = 0; k < calls; k++) call(load);
  return timer_wall_seconds() - start;
}

static int rising(const void *a, const void *b) {
  const double p = *(const double *)a, q = *(const double *)b;
  return (p > q) - (p < q);
}

static double measure(Load *load) {
  double seconds[REPEATS];
  long calls = 1;
  while (time_calls(load, calls) < SHORTEST) calls *= 2;
  for (int k = 0; k < REPEATS; k++) seconds[k] = time_calls(load, calls);
  qsort(seconds, REPEATS, sizeof *seconds, rising);
  return 1e9 * seconds[REPEATS / 2] / ((double)calls * load->n);
}

Status law_timing(const LoadedLaw *law, LawTiming *timing, Error *error) {
  Load *load = NULL;
  Status status = ARRAY_NEW(&load, 1, error);
  if (status != STATUS_OK) return status;
  load->subject = (Subject){.file = law->file,
                            .plugin = law->plugin,
                            .energy = law->energy,
                            .damage = law->damage,
                            .table = law_describe(law)};
  const Verdict made = sample_make(&load->subject, 0, MAX_LD, MAX_LD, &load->sample);
  if (made.outcome != CONFORMANCE_PASSED)
    TRY(error_set(error, STATUS_FAILED, "law %s: %s", load->subject.table.id, made.text));
  kernel_fields(&load->subject, load->sample.value, load->field);
  for (int k = 0; k < LAW_BATCHES; k++) {
    fill(load, law_batch_points[k]);
    if (call(load) != MLAW_OK)
      TRY(error_set(error, STATUS_FAILED, "law %s refuses the points of the conformance suite",
                    load->subject.table.id));
    timing->nanoseconds[k] = measure(load);
  }
cleanup:
  array_free(load);
  return status;
}

/* ---- The table ---- */

typedef struct {
  double evaluation_nanoseconds;
  int points;
  Text *markdown;
} Table;

static Status print_law(const Table *table, const LoadedLaw *law, Error *error) {
  Status status;
  LawTiming timing;
  TRY(law_timing(law, &timing, error));
  TRY(text_append(table->markdown, error, "| `%s` | %s |", law_describe(law).id,
                  law_kind_name(law->energy ? LAW_ENERGY : LAW_DAMAGE)));
  for (int k = 0; k < LAW_BATCHES; k++)
    TRY(text_append(table->markdown, error, " %.1f |", timing.nanoseconds[k]));
  TRY(text_append(table->markdown, error, " %.2f %% |\n",
                  100 * timing.nanoseconds[1] * table->points / table->evaluation_nanoseconds));
cleanup:
  return status;
}

static Status print_plugin(const Table *table, const char *file, Error *error) {
  Status status = STATUS_OK;
  const mlaw_plugin *plugin;
  TRY(plugin_open(file, &plugin, error));
  for (uint32_t k = 0; k < plugin->n_energy; k++)
    TRY(print_law(table, &(LoadedLaw){.plugin = plugin, .energy = plugin->energy[k]}, error));
  for (uint32_t k = 0; k < plugin->n_damage; k++)
    TRY(print_law(table, &(LoadedLaw){.plugin = plugin, .damage = plugin->damage[k]}, error));
cleanup:
  return status;
}

Status law_timing_print(double evaluation_milliseconds, int points, Text *markdown, Error *error) {
  Status status;
  LawSearch search = {0};
  LawFiles files = {0};
  const Table table = {1e6 * evaluation_milliseconds, points, markdown};
  TRY(law_search_default(&search, NULL, error));
  TRY(law_search_files(&search, &files, error));
  TRY(text_append(markdown, error,
                  "| law | kind | ns per point, batch of 6 | of 96 | of 1536 | of 96: share of an evaluation "
                  "|\n|---|---|---|---|---|---|\n"));
  for (size_t i = 0; i < files.n; i++) TRY(print_plugin(&table, files.path[i], error));
cleanup:
  law_files_free(&files);
  law_search_free(&search);
  return status;
}
