#include "study/study_run.h"

#include "base/file.h"
#include "base/timer.h"
#include "study/study_page.h"
#include <stdio.h>

Status study_write(const StudyRun *run, const char *name, const Text *text, Error *error) {
  Text path = {0};
  Status status = file_join(&path, run->folder, name, error);
  if (status == STATUS_OK) status = file_write(path.data, text->data, text->length, error);
  text_free(&path);
  return status;
}

static Status find_folder(const StudyOptions *options, const Study *study, Text *folder, Error *error) {
  Status status;
  TRY(options->folder ? text_append(folder, error, "%s", options->folder)
                      : text_append(folder, error, "results/%s", study->name));
  if (options->parts > 0)
    TRY(text_append(folder, error, "/part_%0*d", snprintf(NULL, 0, "%d", options->parts), options->part));
  TRY(file_make_folder(folder->data, error));
cleanup:
  return status;
}

/* Costs stand last: the rest is the same however the study was run. */
static void summarize(Json *json, const StudyEnd *end, double seconds) {
  json_string(json, "status", end->interrupted ? "interrupted" : "done");
  json_integer(json, "cases", end->count.cases);
  json_integer(json, "failed", end->count.failed);
  json_integer(json, "shared_requests", end->count.shared);
  json_number(json, "evaluations", end->count.evaluations);
  json_open_object(json, "this_process");
  json_integer(json, "cases_taken_over", end->count.taken_over);
  json_integer(json, "jobs", end->count.jobs);
  json_number(json, "wall_seconds", seconds);
  json_close(json);
  json_close(json);
}

static Status work(const StudyOptions *options, const Study *study, const char *folder, StudyEnd *end,
                   Error *error) {
  Status status = STATUS_OK;
  Text text = {0};
  Json json;
  StudyRun run = {.study = study, .folder = folder, .summary = &json, .found = &end->found};
  const double start = timer_wall_seconds();
  TRY(runner_new(&run.runner, study, folder, &options->runner, error));
  json_begin(&json, &text, error);
  json_open_object(&json, NULL);
  json_string(&json, "study", study->kind->name);
  json_string(&json, "name", study->name);
  TRY(study->kind->run(&run, error));
  end->interrupted = runner_interrupted(run.runner);
  end->count = runner_count(run.runner);
  summarize(&json, end, timer_wall_seconds() - start);
  TRY(json_end(&json));
  TRY(study_write(&run, "summary.json", &text, error));
  TRY(study_page_write(folder, error));
cleanup:
  runner_free(run.runner);
  text_free(&text);
  return status;
}

Status study_open(const StudyOptions *options, Study *study, Error *error) {
  Status status = study_read(study, options->path, options->sets, options->n_sets, error);
  if (status != STATUS_OK || options->parts == 0) return status;
  status = study_take_part(study, options->part, options->parts, error);
  if (status != STATUS_OK) study_free(study);
  return status;
}

Status study_run(const StudyOptions *options, Text *folder, StudyEnd *end, Error *error) {
  Status status = STATUS_OK;
  Study study = {0};
  *end = (StudyEnd){0};
  TRY(study_open(options, &study, error));
  TRY(find_folder(options, &study, folder, error));
  TRY(work(options, &study, folder->data, end, error));
cleanup:
  study_free(&study);
  return status;
}
