#include "run/run.h"

#include "base/array.h"
#include "base/file.h"
#include "base/log.h"
#include "base/timer.h"
#include "observe/progress.h"
#include "run/contact_guard.h"
#include "run/march.h"
#include "run/output.h"
#include "run/record.h"
#include "run/run_page.h"
#include "run/simulation.h"
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

/* Fixed steps whose error is so many times the tolerance of automatic ones are warned of. */
static const double LARGE_STEP_ERROR = 10;
/* Amplitude of wrinkles, in mean edges at rest, that is told: smooth capsules leave less on 1280 elements. */
static const double LARGE_WRINKLES = 0.01;

typedef struct {
  const RunOptions *options;
  Scene scene;
  Log log;
  Simulation simulation;
  Record record;
  Output output;
  Progress progress;
  ProgressState shown;
  double started; /* wall clock */
  Outcome outcome;
  bool done;
} Run;

/* ---- observing ---- */

static double wall_seconds(const Run *run) {
  return run->record.data.wall_seconds + timer_wall_seconds() - run->started;
}

/* Where the run stands now; D12 and d_max are those of the last row. */
static const ProgressState *progress_state(Run *run, double t, double step) {
  run->shown.t = t;
  run->shown.step = step;
  run->shown.steps = run->simulation.motion->steps(run->simulation.motion);
  run->shown.wall_seconds = timer_wall_seconds() - run->started;
  return &run->shown;
}

/* One row of the history at time t of the proposed step (or at the accepted time). */
static Status sample(Run *run, double t, Error *error) {
  Status status = STATUS_OK;
  HistoryRow row;
  Shape shape;
  TRY(record_probe(&run->record, t, error));
  TRY(record_row(&run->record, &row, &shape, error));
  TRY(output_row(&run->output, &row, error));
  march_watch_steady(&run->record, &row);
  march_watch_wrinkles(&run->record, &row);
  run->shown.D12 = row.D12;
  run->shown.d_max = row.d_max;
  progress_sample(&run->progress, progress_state(run, row.t, row.step));
cleanup:
  return status;
}

static Status take_samples(Run *run, double t1, Error *error) {
  Status status = STATUS_OK;
  for (;;) {
    const double t = output_next_sample(&run->output, &run->simulation);
    if (t > t1 || t > run->scene.time.end) break;
    TRY(sample(run, t, error));
    run->output.next_sample++;
  }
cleanup:
  return status;
}

/* ---- starting ---- */

static void log_parts(Run *run) {
  const Simulation *s = &run->simulation;
  log_note(&run->log, "%d elements, %d nodes; G_s = %g, K_s = %g", s->mesh.n_elements, s->mesh.n_nodes,
           s->material.shear_modulus, s->material.dilatation_modulus);
  log_note(&run->log, "elastic law %s", s->material.elastic.file);
  if (material_has_damage(&s->material)) log_note(&run->log, "damage law %s", s->material.damage.file);
  for (size_t i = 0; i < s->n_criteria; i++)
    log_note(&run->log, "observing law %s", s->criterion[i].damage.file);
  for (size_t i = 0; i < s->n_skipped; i++) log_note(&run->log, "skipped: %s", s->skipped[i]);
}

static Status start(Run *run, Error *error) {
  Status status = STATUS_OK;
  bool found = false;
  if (run->options->resume)
    TRY(output_resume(&run->output, &run->simulation, &run->record, &run->log, &found, error));
  if (found) {
    log_note(&run->log, "resumed at t = %g", run->simulation.motion->t);
    TRY(record_begin(&run->record, true, error));
    contact_guard_resume(&run->record);
    goto cleanup;
  }
  if (run->options->resume)
    log_warning(&run->log, "%s holds no snapshot to resume from: the run starts anew", run->output.folder);
  TRY(simulation_start(&run->simulation, error));
  if (!simulation_is_inflation(&run->simulation))
    log_note(&run->log, "spectral radius %.4g: steps of %s are stable up to %.3g",
             run->simulation.stepper.memory.rho, run->simulation.stepper.integrator->name,
             stepper_stability_limit(&run->simulation.stepper));
  TRY(output_start(&run->output, &run->simulation, error));
  log_drop_earlier(&run->log);
  TRY(record_begin(&run->record, false, error));
  TRY(march_renew_load(&run->record, run->simulation.motion->t,
                       error)); /* after the estimate of the spectral radius */
  TRY(take_samples(run, run->simulation.motion->t, error));
  if (isfinite(output_next_snapshot(&run->output, &run->simulation))) {
    run->output.next_snapshot++;
    TRY(output_snapshot(&run->output, &run->simulation, &run->record, error));
  }
cleanup:
  return status;
}

/* ---- one step ---- */

static void finish(Run *run, Outcome outcome) {
  run->outcome = outcome;
  run->done = true;
}

/* A run that is resumed may have nothing left to do. */
static void finish_what_is_over(Run *run) {
  if (run->simulation.motion->t >= run->scene.time.end) finish(run, OUTCOME_END);
  if (run->scene.stop.rupture == RUPTURE_STOP && !isnan(run->record.data.t_l)) finish(run, OUTCOME_RUPTURED);
}

static Status advance(Run *run, Error *error) {
  Status status = STATUS_OK;
  Simulation *s = &run->simulation;
  bool ruptured;
  const double t_limit = fmin(output_next_snapshot(&run->output, s), run->scene.time.end);
  TRY(march_propose(&run->record, t_limit, &run->log, &ruptured, error));
  if (ruptured) finish(run, OUTCOME_RUPTURED);
  TRY(take_samples(run, run->record.t1, error));
  TRY(march_accept(&run->record, error));
  progress_step(&run->progress, progress_state(run, s->motion->t, s->motion->last_step));

  if (s->motion->t >= t_limit && t_limit < run->scene.time.end) {
    run->output.next_snapshot++;
    TRY(output_snapshot(&run->output, s, &run->record, error));
  }
  if (run->done) goto cleanup;
  if (s->motion->t >= run->scene.time.end)
    finish(run, OUTCOME_END);
  else if (march_is_steady(&run->record))
    finish(run, OUTCOME_STEADY);
  else if (run->options->interrupt && *run->options->interrupt)
    finish(run, OUTCOME_INTERRUPTED);
cleanup:
  return status;
}

/* ---- ending ---- */

static Status write_criteria(const Run *run, const Verdict *verdicts, Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  TRY(file_join(&path, run->output.folder, "criteria.csv", error));
  TRY(verdicts_write(verdicts, run->simulation.n_criteria, path.data, error));
cleanup:
  text_free(&path);
  return status;
}

static Status write_summary(Run *run, Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  Verdict *verdicts = NULL;
  Summary summary;
  const Motion *motion = run->simulation.motion;
  TRY(record_probe(&run->record, motion->t, error));
  TRY(record_summary(&run->record, &summary, error));
  if (run->simulation.n_criteria > 0) {
    TRY(ARRAY_NEW(&verdicts, run->simulation.n_criteria, error));
    TRY(criteria_verdicts(&run->record, verdicts, error));
    TRY(write_criteria(run, verdicts, error));
    summary.criteria = verdicts;
    summary.n_criteria = run->simulation.n_criteria;
  }
  summary.status = run->outcome;
  const bool has_stepper = !simulation_is_inflation(&run->simulation);
  const StepperMemory *memory = &run->simulation.stepper.memory;
  summary.step_error_max = has_stepper ? memory->error_max : NAN;
  summary.unstable_steps = has_stepper ? (long long)memory->unstable_steps : 0;
  summary.steps = motion->steps(motion);
  summary.rejected_steps = motion->rejected(motion);
  summary.evaluations = motion->evaluations(motion);
  summary.stage_evaluations = motion->stage_evaluations(motion);
  summary.wall_seconds = wall_seconds(run);
  summary.threads = omp_get_max_threads();
  TRY(file_join(&path, run->output.folder, "summary.json", error));
  TRY(summary_write(&summary, path.data, error));
cleanup:
  array_free(verdicts);
  text_free(&path);
  return status;
}

/* Fixed steps go on whatever their error: what they are worth is told. */
static void warn_of_steps(Run *run) {
  const Stepper *stepper = &run->simulation.stepper;
  if (simulation_is_inflation(&run->simulation) || stepper->options.is_auto) return;
  const double ratio = stepper->memory.error_max / stepper->options.tolerance;
  if (stepper->memory.unstable_steps > 0)
    log_warning(&run->log,
                "%.0f of %.0f steps were beyond the stability limit: shape and damage, rupture above all, "
                "may be of the steps alone; write `time.step: auto`",
                stepper->memory.unstable_steps, stepper->memory.steps);
  if (ratio > LARGE_STEP_ERROR)
    log_warning(&run->log,
                "the error of the fixed steps reaches %.3g, that is %.3g times time.tolerance; write "
                "`time.step: auto`, or a smaller step",
                stepper->memory.error_max, ratio);
}

/* The shape may be right all the same, but what is seen on the scale of an element is not the membrane's. */
static void tell_of_wrinkles(Run *run) {
  const RecordData *data = &run->record.data;
  const double edge = mesh_edge_length(&run->simulation.mesh, run->simulation.mesh.X);
  if (data->wrinkle_max > LARGE_WRINKLES * edge)
    log_note(
        &run->log,
        "the shape is rough on the scale of the mesh, by %.2g a or %.2g of an edge at t = %.4g: wrinkles, "
        "where the membrane is compressed, or a shape sharper than the mesh",
        data->wrinkle_max, data->wrinkle_max / edge, data->wrinkle_t);
}

/* The last state: a row, a snapshot, the summary.  Also after a failure, from the last accepted state. */
static Status conclude(Run *run, Error *error) {
  Status status = STATUS_OK;
  const double t = run->simulation.motion->t;
  /* An interrupted run will go on: it gets no row that an uninterrupted one would not have. */
  const bool has_row = run->output.last_row_t >= t; /* false for NAN */
  if (!has_row && run->outcome != OUTCOME_INTERRUPTED) TRY(sample(run, t, error));
  run->record.data.wall_seconds = wall_seconds(run);
  run->started = timer_wall_seconds();
  /* A run that is resumed may have had nothing left to do. */
  if (run->output.last_snapshot_t != t)
    TRY(output_snapshot(&run->output, &run->simulation, &run->record, error));
  TRY(write_summary(run, error));
  warn_of_steps(run);
  tell_of_wrinkles(run);
  log_note(&run->log, "%s at t = %.6g, %lld evaluations, %.3g s", outcome_name(run->outcome), t,
           run->simulation.motion->evaluations(run->simulation.motion), run->record.data.wall_seconds);
cleanup:
  progress_clear(&run->progress);
  return status;
}

static const char FAILURE_FILE[] = "law_failure.yaml";

/* When it was a law that failed, what it was handed goes into a file of the folder, which the message names.
 */
static void keep_law_failure(const Run *run, Error *error) {
  const Membrane *membrane = run->simulation.membrane;
  Text path = {0}, yaml = {0};
  Error ignored;
  const bool is_kept = membrane && membrane_law_failure(membrane)->n > 0 &&
                       law_failure_print(membrane_law_failure(membrane), &yaml, &ignored) == STATUS_OK &&
                       file_join(&path, run->output.folder, FAILURE_FILE, &ignored) == STATUS_OK &&
                       file_write(path.data, yaml.data, yaml.length, &ignored) == STATUS_OK;
  if (is_kept) {
    const size_t length = strlen(error->text);
    snprintf(error->text + length, sizeof error->text - length,
             "\nwhat the law was handed: capsella laws check --replay %s", path.data);
  }
  text_free(&path);
  text_free(&yaml);
}

/* Concludes at the accepted state. */
static void conclude_failed(Run *run) {
  Error ignored;
  run->outcome = OUTCOME_FAILED;
  if (march_fall_back(&run->record, &ignored) == STATUS_OK && conclude(run, &ignored) == STATUS_OK) return;
  log_note(&run->log, "while concluding: %s", ignored.text);
  /* A disk too full for a snapshot may have room for the summary. */
  if (write_summary(run, &ignored) != STATUS_OK) log_note(&run->log, "while concluding: %s", ignored.text);
}

/* The page shows what is on disk already: without it the run is whole. */
static void write_page(Run *run) {
  Error ignored;
  if (run_page_write(run->output.folder, &run->log, &ignored) != STATUS_OK)
    log_warning(&run->log, "report.html is missing: %s", ignored.text);
}

static Status open_folder(Run *run, Text *folder, Error *error) {
  Status status = STATUS_OK;
  Text log_path = {0};
  if (run->options->folder)
    TRY(text_append(folder, error, "%s", run->options->folder));
  else
    TRY(text_append(folder, error, "results/%s", run->scene.name));
  TRY(file_make_folder(folder->data, error));
  TRY(file_join(&log_path, folder->data, "log.txt", error));
  TRY(log_open(&run->log, log_path.data, run->options->quiet, error));
  log_note(&run->log, "capsella " CAPSELLA_VERSION ", scene %s", run->options->scene_path);
cleanup:
  text_free(&log_path);
  return status;
}

Status run_scene(const RunOptions *options, Outcome *outcome, Text *folder, Error *error) {
  Status status = STATUS_OK;
  Run run = {.options = options, .started = timer_wall_seconds(), .outcome = OUTCOME_FAILED};
  if (options->threads > 0) omp_set_num_threads(options->threads);
  TRY(scene_read(&run.scene, options->scene_path, options->sets, options->n_sets, error));
  TRY(open_folder(&run, folder, error));
  TRY(simulation_new(&run.simulation, &run.scene, &run.log, error));
  membrane_watch_laws(run.simulation.membrane, options->law_watch);
  TRY(record_new(&run.record, &run.simulation, error));
  log_parts(&run);
  TRY(output_open(&run.output, folder->data, &run.simulation, error));
  progress_start(&run.progress, options->progress, options->quiet, 0, run.scene.time.end);
  status = start(&run, error);
  if (status != STATUS_OK) {
    keep_law_failure(&run, error);
    goto cleanup;
  }
  progress_start(&run.progress, options->progress, options->quiet, run.simulation.motion->t,
                 run.scene.time.end);
  finish_what_is_over(&run);
  while (status == STATUS_OK && !run.done) status = advance(&run, error);
  if (status == STATUS_OK) status = conclude(&run, error);
  if (status != STATUS_OK) {
    keep_law_failure(&run, error);
    conclude_failed(&run);
  }
  if (run.scene.output.report) write_page(&run);
cleanup:
  if (status != STATUS_OK) log_note(&run.log, "%s", error->text);
  *outcome = run.outcome;
  output_close(&run.output);
  record_free(&run.record);
  simulation_free(&run.simulation);
  log_close(&run.log);
  scene_free(&run.scene);
  return status;
}
