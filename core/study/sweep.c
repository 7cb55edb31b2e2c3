/* table.csv has one row a case, in the order of the outer product. */
#include "study/sweep.h"

#include "base/array.h"
#include "study/entry.h"
#include "study/label.h"
#include "study/study_run.h"
#include "study/sweep_charts.h"
#include "study/table.h"

static Status request_all(const StudyRun *run, Override *settings, int *cases, Error *error) {
  Status status = STATUS_OK;
  Text label = {0};
  runner_expect(run->runner, (long)run->study->n_points);
  for (size_t i = 0; i < run->study->n_points; i++) {
    label.length = 0;
    study_point(run->study, i, settings);
    TRY(label_append(&label, settings, run->study->n_axes, error));
    TRY(runner_request(run->runner, label.data, settings, run->study->n_axes, &cases[i], error));
  }
cleanup:
  text_free(&label);
  return status;
}

static Status write_table(const StudyRun *run, const int *cases, Error *error) {
  Table table;
  table_begin(&table, error);
  table_axes_header(&table, run->study);
  table_case_header(&table);
  table_end_row(&table);
  for (size_t i = 0; i < run->study->n_points; i++) {
    table_axes(&table, run->study, i);
    table_case(&table, runner_case(run->runner, cases[i]));
    table_end_row(&table);
  }
  return table_write(&table, run->folder, "table.csv");
}

static Status sweep(StudyRun *run, Error *error) {
  Status status = STATUS_OK;
  Override *settings = NULL;
  int *cases = NULL;
  TRY(ARRAY_NEW(&settings, run->study->n_axes, error));
  TRY(ARRAY_NEW(&cases, run->study->n_points, error));
  TRY(request_all(run, settings, cases, error));
  TRY(runner_wait_all(run->runner, error));
  TRY(write_table(run, cases, error));
  TRY(sweep_charts_write(run, cases, error));
cleanup:
  array_free(cases);
  array_free(settings);
  return status;
}

/* A sweep is about the ends of its runs, unless it says otherwise. */
static Status prepare(Study *study, Error *error) {
  static const char *const words[] = {"false", "true", NULL};
  Status status = STATUS_OK;
  int snapshots = 0;
  const YamlNode *node = yaml_tree_find(study->root, "snapshots");
  if (node) TRY(entry_choice(node, "snapshots", words, &snapshots, error));
  TRY(sweep_charts_check(study, error));
  if (!snapshots) TRY(study_set(study, "output.snapshot_every", "0", error));
  TRY(study_check_points(study, error));
cleanup:
  return status;
}

static const char *const KEYS[] = {"snapshots", "charts", NULL};

const StudyKind SWEEP = {
    .name = "sweep", .keys = KEYS, .prepare = prepare, .run = sweep, .keeps_states = true};
