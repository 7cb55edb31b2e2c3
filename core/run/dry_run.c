/* The cost is extrapolated from the first steps, with all that a step brings but files. */
#include "run/dry_run.h"

#include "base/file.h"
#include "base/timer.h"
#include "run/march.h"
#include "run/output.h"
#include "run/record.h"
#include <errno.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* The first steps are taken for this long, and no more than so many. */
static const double PROBE_SECONDS = 1.5;
enum { PROBE_STEPS = 24 };

typedef struct {
  Scene scene;
  Simulation simulation;
  Record record;
  Output output;
  Text folder;
  bool is_new, holds_results, resumes;
  double t0, t;                                    /* first and last time of the steps taken */
  double seconds, evaluations, last, last_seconds; /* of all; evaluations and seconds of the last step */
  int steps;
} DryRun;

/* ---- The folder ---- */

static Status cannot_write(const char *path, const char *why, Error *error) {
  return error_set(error, STATUS_IO, "%s: results cannot be written there: %s", path, why);
}

/* The nearest folder above that is there must let one be made. */
static Status check_parents(const char *path, Error *error) {
  Status status = STATUS_OK;
  Text above = {0}, next = {0};
  struct stat there;
  TRY(file_folder(&above, path, error));
  while (stat(above.data, &there) != 0 && errno == ENOENT) {
    next.length = 0;
    TRY(file_folder(&next, above.data, error));
    const Text swapped = above;
    above = next;
    next = swapped;
  }
  if (access(above.data, W_OK | X_OK) != 0) TRY(cannot_write(above.data, strerror(errno), error));
cleanup:
  text_free(&above);
  text_free(&next);
  return status;
}

static bool holds(const char *folder, const char *name) {
  Text path = {0};
  Error ignored;
  const bool found = file_join(&path, folder, name, &ignored) == STATUS_OK && file_exists(path.data);
  text_free(&path);
  return found;
}

static Status check_folder(const RunOptions *options, DryRun *dry, Error *error) {
  Status status;
  struct stat there;
  TRY(options->folder ? text_append(&dry->folder, error, "%s", options->folder)
                      : text_append(&dry->folder, error, "results/%s", dry->scene.name));
  const char *folder = dry->folder.data;
  dry->is_new = stat(folder, &there) != 0 && errno == ENOENT;
  if (dry->is_new) return check_parents(folder, error);
  if (!S_ISDIR(there.st_mode)) TRY(cannot_write(folder, "it is not a folder", error));
  if (access(folder, W_OK | X_OK) != 0) TRY(cannot_write(folder, strerror(errno), error));
  dry->holds_results = holds(folder, "history.csv") || holds(folder, "resolved.yaml");
cleanup:
  return status;
}

/* ---- The first steps ---- */

static double evaluations(const DryRun *dry) {
  return (double)dry->simulation.motion->evaluations(dry->simulation.motion);
}

/* Brings the simulation to where the run would start. */
static Status start(const RunOptions *options, DryRun *dry, Error *error) {
  Status status = STATUS_OK;
  int number = -1;
  if (options->resume && !dry->is_new)
    TRY(output_restore(&dry->output, &dry->simulation, &dry->record, NULL, &number, error));
  dry->resumes = number >= 0;
  dry->evaluations = -evaluations(dry); /* of earlier processes */
  if (!dry->resumes) TRY(simulation_start(&dry->simulation, error));
  TRY(record_begin(&dry->record, dry->resumes, error));
  dry->t0 = dry->t = dry->simulation.motion->t;
  while (output_next_snapshot(&dry->output, &dry->simulation) <= dry->t) dry->output.next_snapshot++;
  dry->evaluations += evaluations(dry);
cleanup:
  return status;
}

static Status step(DryRun *dry, Error *error) {
  Status status;
  bool ruptured;
  Motion *motion = dry->simulation.motion;
  const double begun = timer_wall_seconds(), before = evaluations(dry);
  const double limit = fmin(output_next_snapshot(&dry->output, &dry->simulation), dry->scene.time.end);
  TRY(march_propose(&dry->record, limit, NULL, &ruptured, error));
  TRY(march_accept(&dry->record, error));
  if (motion->t >= limit) dry->output.next_snapshot++; /* steps end on these times */
  dry->t = motion->t;
  dry->steps++;
  dry->last = evaluations(dry) - before;
  dry->last_seconds = timer_wall_seconds() - begun;
  dry->seconds += dry->last_seconds;
  dry->evaluations += dry->last;
cleanup:
  return status;
}

static Status probe(const RunOptions *options, DryRun *dry, Error *error) {
  Status status = STATUS_OK;
  while (dry->t < dry->scene.time.end && dry->steps < PROBE_STEPS && dry->seconds < PROBE_SECONDS &&
         !(options->interrupt && *options->interrupt))
    TRY(step(dry, error));
cleanup:
  return status;
}

/* ---- The report ---- */

static Status print_scene(const DryRun *dry, Text *report, Error *error) {
  Status status;
  const Simulation *s = &dry->simulation;
  TRY(text_append(report, error, "scene    %s, to t = %g\n", dry->scene.name, dry->scene.time.end));
  if (!simulation_is_inflation(s))
    TRY(text_append(report, error, "flow     Ca = %.6g\n", dry->scene.flow.capillary_number));
  TRY(text_append(report, error, "mesh     %d elements, %d nodes\n", s->mesh.n_elements, s->mesh.n_nodes));
  TRY(text_append(report, error, "laws     %s\n", s->material.elastic.file));
  if (material_has_damage(&s->material))
    TRY(text_append(report, error, "         %s\n", s->material.damage.file));
  for (size_t i = 0; i < s->n_criteria; i++)
    TRY(text_append(report, error, "         %s, which looks on\n", s->criterion[i].damage.file));
  for (size_t i = 0; i < s->n_skipped; i++)
    TRY(text_append(report, error, "%s%s\n", i ? "         " : "skips    ", s->skipped[i]));
cleanup:
  return status;
}

static const char *folder_state(const DryRun *dry) {
  if (dry->is_new) return "will be made";
  if (dry->resumes) return "holds the snapshot to go on from";
  return dry->holds_results ? "holds results, which the run REPLACES" : "is there";
}

/* How many multiples of `every` lie from the start to the end. */
static double count(const DryRun *dry, double every) {
  return every > 0 ? floor((dry->scene.time.end - dry->t0) / every * (1 + 1e-12)) + 1 : 1;
}

static Status print_output(const DryRun *dry, Text *report, Error *error) {
  Status status;
  TRY(text_append(report, error, "folder   %s %s\n", dry->folder.data, folder_state(dry)));
  TRY(text_append(report, error, "writes   %.0f rows of history.csv, %.0f snapshots%s\n",
                  count(dry, dry->scene.output.history_every), count(dry, dry->scene.output.snapshot_every),
                  dry->scene.output.report ? ", report.html" : ""));
cleanup:
  return status;
}

static Status print_duration(double seconds, Text *report, Error *error) {
  if (seconds < 100) return text_append(report, error, "%.2g s", seconds);
  if (seconds < 6000) return text_append(report, error, "%.0f min", seconds / 60);
  return text_append(report, error, "%.1f h", seconds / 3600);
}

/* The steps to come are taken to be like the last. */
static Status print_cost(const DryRun *dry, Text *report, Error *error) {
  Status status;
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  TRY(text_append(report, error, "memory   %.0f MB on %d threads\n", (double)usage.ru_maxrss / 1024,
                  omp_get_max_threads()));
  if (dry->steps == 0)
    TRY(text_append(report, error, "cost     none: the run is at its end, t = %g\n", dry->t));
  if (dry->steps == 0) goto cleanup;
  const double h = dry->simulation.motion->last_step, steps = ceil((dry->scene.time.end - dry->t) / h);
  TRY(text_append(report, error, "cost     about %.0f steps, ", dry->steps + steps));
  if (!simulation_is_inflation(&dry->simulation))
    TRY(text_append(report, error, "%.0f evaluations of the velocity, ",
                    dry->evaluations + steps * dry->last));
  TRY(print_duration(dry->seconds + steps * dry->last_seconds, report, error));
  TRY(text_append(
      report, error,
      "\n         from the first %d steps, to t = %.3g; less where rupture or a steady state stop it\n",
      dry->steps, dry->t));
cleanup:
  return status;
}

Status run_dry(const RunOptions *options, Text *report, Error *error) {
  Status status = STATUS_OK;
  DryRun dry = {0};
  if (options->threads > 0) omp_set_num_threads(options->threads);
  TRY(scene_read(&dry.scene, options->scene_path, options->sets, options->n_sets, error));
  TRY(check_folder(options, &dry, error));
  TRY(simulation_new(&dry.simulation, &dry.scene, NULL, error));
  TRY(record_new(&dry.record, &dry.simulation, error));
  TRY(output_open(&dry.output, dry.folder.data, &dry.simulation, error));
  TRY(start(options, &dry, error));
  TRY(probe(options, &dry, error));
  TRY(print_scene(&dry, report, error));
  TRY(print_output(&dry, report, error));
  TRY(print_cost(&dry, report, error));
cleanup:
  output_close(&dry.output);
  record_free(&dry.record);
  simulation_free(&dry.simulation);
  scene_free(&dry.scene);
  text_free(&dry.folder);
  return status;
}
