/* One row of the table for each point of the outer product, each criterion, and each way of judging it. */
#include "study/compare.h"

#include "base/array.h"
#include "observe/chart.h"
#include "study/calibration.h"
#include "study/contender.h"
#include "study/entry.h"
#include "study/label.h"
#include "study/sites.h"
#include "study/study_run.h"
#include "study/table.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef enum { MODE_PASSIVE, MODE_COUPLED } Mode;
static const char *const MODES[] = {"passive", "coupled", NULL};

/* What the study's file asks for. */
typedef struct {
  Mode mode;
  Contender *contenders; /* [n] */
  size_t n;
  bool *acts; /* [n] on the membrane in a run of its own */
  CalibrationGoal goal;
} Question;

/* One verdict: of a contender, at a point, in a mode. */
typedef struct {
  size_t point, contender;
  Mode mode;
  const Calibrated *strength;
  int number;   /* of the case; -1: none was asked for */
  size_t entry; /* in the case's list of criteria */
} Row;

typedef struct {
  StudyRun *run;
  Question question;
  Calibrated *strength[2]; /* of each mode: [n_points][n] */
  Row *rows;
  size_t n_rows;
  Override *settings; /* [n_axes + 2] */
  Text text, label;   /* scratch */
} Comparison;

/* ---- the question ---- */

static void question_free(Question *question) {
  array_free(question->contenders);
  array_free(question->acts);
  *question = (Question){0};
}

static Status read_confirm(const Study *study, Question *question, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *list = yaml_tree_find(study->root, "confirm");
  if (!list) return STATUS_OK;
  if (list->kind != YAML_TREE_LIST || question->mode == MODE_COUPLED)
    return place_error(&list->place, error,
                       "expected a list of criteria for `confirm`, in the mode `passive`, found %s",
                       question->mode == MODE_COUPLED ? "the mode `coupled`" : yaml_tree_found(list).text);
  for (size_t k = 0; k < list->count; k++) {
    size_t i;
    TRY(contender_find(question->contenders, question->n, list->items[k], &i, error));
    question->acts[i] = true;
  }
cleanup:
  return status;
}

/* A calibration needs to know what to scale. */
static Status check_strengths(const Question *question, const YamlNode *calibrate, Error *error) {
  for (size_t i = 0; calibrate && i < question->n; i++)
    if (!question->contenders[i].strength)
      return place_error(
          &calibrate->place, error,
          "expected a `strength: [...]` of the criterion `%s`, which the calibration would scale, "
          "found none",
          question->contenders[i].name);
  return STATUS_OK;
}

static Status question_read(const Study *study, Question *question, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *mode = yaml_tree_find(study->root, "mode"),
                 *calibrate_node = yaml_tree_find(study->root, "calibrate");
  int choice = MODE_PASSIVE;
  *question = (Question){0};
  if (mode) TRY(entry_choice(mode, "mode", MODES, &choice, error));
  question->mode = (Mode)choice;
  TRY(contenders_read(study, &question->contenders, &question->n, error));
  TRY(ARRAY_NEW(&question->acts, question->n, error));
  TRY(read_confirm(study, question, error));
  TRY(calibration_read(calibrate_node, &question->goal, error));
  for (size_t i = 0; question->mode == MODE_COUPLED && i < question->n; i++) question->acts[i] = true;
  TRY(check_strengths(question, calibrate_node, error));
cleanup:
  if (status != STATUS_OK) question_free(question);
  return status;
}

/* ---- cases ---- */

static const Calibrated *strength_of(const Comparison *c, Mode mode, size_t point, size_t contender) {
  return &c->strength[mode][point * c->question.n + contender];
}

/* The contenders whose strength is known, as a list of criteria. */
static Status print_criteria(Comparison *c, size_t point, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  const Question *q = &c->question;
  const char *separator = "";
  yaml->length = 0;
  TRY(text_append(yaml, error, "["));
  for (size_t i = 0; i < q->n; i++) {
    const double scale = strength_of(c, MODE_PASSIVE, point, i)->scale;
    if (isnan(scale)) continue;
    TRY(text_append(yaml, error, "%s", separator));
    TRY(contender_print(&q->contenders[i], q->contenders[i].name, scale, yaml, error));
    separator = ", ";
  }
  TRY(text_append(yaml, error, "]"));
cleanup:
  return status;
}

static Status start_label(Comparison *c, Error *error) {
  c->label.length = 0;
  return label_append(&c->label, c->settings, c->run->study->n_axes, error);
}

static void put_setting(Comparison *c, size_t k, const char *key, const char *value) {
  c->settings[c->run->study->n_axes + k] =
      (Override){.key = key, .value = value, .place = c->run->study->root->place};
}

static Status request_passive(Comparison *c, size_t point, int *number, Error *error) {
  Status status = STATUS_OK;
  study_point(c->run->study, point, c->settings);
  TRY(print_criteria(c, point, &c->text, error));
  put_setting(c, 0, "observe.criteria", c->text.data);
  TRY(start_label(c, error));
  TRY(text_append(&c->label, error, ",passive"));
  TRY(runner_request(c->run->runner, c->label.data, c->settings, c->run->study->n_axes + 1, number, error));
cleanup:
  return status;
}

/* The contender acts on the membrane, and looks on at itself. */
static Status request_coupled(Comparison *c, size_t point, size_t i, int *number, Error *error) {
  Status status = STATUS_OK;
  Text damage = {0};
  const Contender *contender = &c->question.contenders[i];
  study_point(c->run->study, point, c->settings);
  const double scale = strength_of(c, MODE_COUPLED, point, i)->scale;
  c->text.length = 0;
  TRY(text_append(&c->text, error, "["));
  TRY(contender_print(contender, contender->name, scale, &c->text, error));
  TRY(text_append(&c->text, error, "]"));
  TRY(contender_print(contender, NULL, scale, &damage, error));
  put_setting(c, 0, "membrane.damage", damage.data);
  put_setting(c, 1, "observe.criteria", c->text.data);
  TRY(start_label(c, error));
  TRY(text_append(&c->label, error, ",coupled=%s", contender->name));
  TRY(runner_request(c->run->runner, c->label.data, c->settings, c->run->study->n_axes + 2, number, error));
cleanup:
  text_free(&damage);
  return status;
}

/* A row; `number` is that of its case, if its strength is known. */
static Row *add_row(Comparison *c, Mode mode, size_t point, size_t contender) {
  Row *row = &c->rows[c->n_rows++];
  *row = (Row){.point = point,
               .contender = contender,
               .mode = mode,
               .strength = strength_of(c, mode, point, contender),
               .number = -1};
  return row;
}

static Status request_point(Comparison *c, size_t point, Error *error) {
  Status status = STATUS_OK;
  const Question *q = &c->question;
  int passive = -1;
  size_t entry = 0;
  if (q->mode == MODE_PASSIVE) TRY(request_passive(c, point, &passive, error));
  for (size_t i = 0; i < q->n; i++) {
    if (q->mode == MODE_PASSIVE) {
      Row *row = add_row(c, MODE_PASSIVE, point, i);
      if (!isnan(row->strength->scale)) {
        row->number = passive;
        row->entry = entry++;
      }
    }
    if (q->acts[i]) {
      Row *row = add_row(c, MODE_COUPLED, point, i);
      if (!isnan(row->strength->scale)) TRY(request_coupled(c, point, i, &row->number, error));
    }
  }
cleanup:
  return status;
}

/* ---- figures ---- */

static const Case *case_of(const Comparison *c, const Row *row) {
  return row->number < 0 ? NULL : runner_case(c->run->runner, row->number);
}

static double figure(const Comparison *c, const Row *row, const char *key) {
  char path[80];
  const Case *item = case_of(c, row);
  snprintf(path, sizeof path, "criteria.%zu.%s", row->entry, key);
  return item ? case_number(item, path) : NAN;
}

static double component(const Comparison *c, const Row *row, const char *key, size_t k) {
  char path[80];
  const Case *item = case_of(c, row);
  snprintf(path, sizeof path, "criteria.%zu.%s", row->entry, key);
  return item ? case_component(item, path, k) : NAN;
}

/* "ruptured", "damaged" or "whole"; or what has become of the case. */
static const char *status_of(const Comparison *c, const Row *row) {
  const Case *item = case_of(c, row);
  if (!item || !case_ended(item)) return "not run";
  if (item->state == CASE_FAILED) return "failed";
  if (!isnan(figure(c, row, "t_l"))) return "ruptured";
  return isnan(figure(c, row, "t_c")) ? "whole" : "damaged";
}

static const char *region_of(const Comparison *c, const Row *row) {
  return site_region(figure(c, row, "site.angle_to_vorticity_deg"),
                     figure(c, row, "site.angle_to_major_axis_deg"));
}

/* ---- results ---- */

static const struct {
  const char *column, *key;
} FIGURES[] = {
    {"t_c", "t_c"},
    {"t_l", "t_l"},
    {"d_max", "d_max"},
    {"angle_to_vorticity_deg", "site.angle_to_vorticity_deg"},
    {"angle_to_major_axis_deg", "site.angle_to_major_axis_deg"},
    {"damaged_area_fraction", "damaged_area_fraction"},
    {"thickness_min", "thinnest.thickness"},
    {"thinnest_angle_to_vorticity_deg", "thinnest.angle_to_vorticity_deg"},
    {"thinnest_angle_to_major_axis_deg", "thinnest.angle_to_major_axis_deg"},
    {"T1_max", "tensest.T1"},
    {"tensest_angle_to_vorticity_deg", "tensest.angle_to_vorticity_deg"},
    {"tensest_angle_to_major_axis_deg", "tensest.angle_to_major_axis_deg"},
};
enum { N_FIGURES = sizeof FIGURES / sizeof *FIGURES };

static void put_header(Table *table, const Study *study) {
  static const char *const first[] = {"criterion", "law", "mode", "strength", "case", "status", "region"};
  static const char *const axes[] = {"1", "2", "3"};
  table_axes_header(table, study);
  for (size_t k = 0; k < sizeof first / sizeof *first; k++) table_text(table, first[k]);
  for (int k = 0; k < N_FIGURES; k++) table_text(table, FIGURES[k].column);
  for (int k = 0; k < 3; k++) table_component(table, "X", axes[k]);
  for (int k = 0; k < 3; k++) table_component(table, "x", axes[k]);
  table_text(table, "reason");
  table_end_row(table);
}

static void put_row(Table *table, const Comparison *c, const Row *row) {
  const Contender *contender = &c->question.contenders[row->contender];
  const Case *item = case_of(c, row);
  table_axes(table, c->run->study, row->point);
  table_text(table, contender->name);
  table_text(table, contender->law->text);
  table_text(table, MODES[row->mode]);
  table_number(table, row->strength->scale);
  table_text(table, item ? item->label : NULL);
  table_text(table, status_of(c, row));
  table_text(table, region_of(c, row));
  for (int k = 0; k < N_FIGURES; k++) table_number(table, figure(c, row, FIGURES[k].key));
  for (size_t k = 0; k < 3; k++) table_number(table, component(c, row, "site.X", k));
  for (size_t k = 0; k < 3; k++) table_number(table, component(c, row, "site.x", k));
  table_text(table, row->strength->reason ? row->strength->reason : item ? item->reason : NULL);
  table_end_row(table);
}

static Status write_table(const Comparison *c, Error *error) {
  Table table;
  table_begin(&table, error);
  put_header(&table, c->run->study);
  for (size_t k = 0; k < c->n_rows; k++) put_row(&table, c, &c->rows[k]);
  return table_write(&table, c->run->folder, "table.csv");
}

static void summarize(const Comparison *c) {
  Json *json = c->run->summary;
  json_string(json, "mode", MODES[c->question.mode]);
  json_open_array(json, "criteria");
  for (size_t k = 0; k < c->n_rows; k++) {
    const Row *row = &c->rows[k];
    json_open_object(json, NULL);
    json_string(json, "name", c->question.contenders[row->contender].name);
    json_string(json, "mode", MODES[row->mode]);
    json_integer(json, "point", (long long)row->point);
    json_number(json, "strength", row->strength->scale);
    json_string(json, "status", status_of(c, row));
    json_string(json, "region", region_of(c, row));
    for (int f = 0; f < N_FIGURES; f++) json_number(json, FIGURES[f].column, figure(c, row, FIGURES[f].key));
    json_close(json);
  }
  json_close(json);
}

/* The maps of one point: the rows of the study's own mode, on the last state of the first case. */
static Status draw_point(const Comparison *c, size_t point, Error *error) {
  Status status = STATUS_OK;
  const Case *item = NULL;
  SiteMark *marks = NULL;
  size_t n = 0;
  char suffix[32] = "";
  TRY(ARRAY_NEW(&marks, c->question.n, error));
  for (size_t k = 0; k < c->n_rows; k++) {
    const Row *row = &c->rows[k];
    if (row->point != point || row->mode != c->question.mode) continue;
    const Case *own = case_of(c, row);
    if (!item && own && own->state == CASE_DONE) item = own;
    SiteMark *mark = &marks[n++];
    mark->name = c->question.contenders[row->contender].name;
    for (size_t a = 0; a < 3; a++) {
      mark->X[a] = component(c, row, "site.X", a);
      mark->x[a] = component(c, row, "site.x", a);
    }
  }
  if (c->run->study->n_points > 1) snprintf(suffix, sizeof suffix, "_%zu", point + 1);
  if (item) TRY(sites_write(item, marks, n, c->run->folder, suffix, error));
cleanup:
  array_free(marks);
  return status;
}

/* Angle of the site to an axis of the capsule, over the one key that is varied. */
static Status draw_angles(const Comparison *c, const char *key, const char *label, const char *name,
                          Error *error) {
  Status status = STATUS_OK;
  const Study *study = c->run->study;
  const Question *q = &c->question;
  double *angles = NULL;
  ChartSeries *series = NULL;
  Text svg = {0};
  TRY(ARRAY_NEW(&angles, study->n_points * q->n, error));
  TRY(ARRAY_NEW(&series, q->n, error));
  for (size_t k = 0; k < c->n_rows; k++)
    if (c->rows[k].mode == q->mode)
      angles[c->rows[k].contender * study->n_points + c->rows[k].point] = figure(c, &c->rows[k], key);
  for (size_t i = 0; i < q->n; i++)
    series[i] = (ChartSeries){.label = q->contenders[i].name,
                              .x = study->axes[0].numbers,
                              .y = angles + i * study->n_points,
                              .n = study->n_points,
                              .style = CHART_LINE_AND_MARKS};
  const Chart chart = {.x = {.label = study->axes[0].key},
                       .y = {.label = label, .minimum = 0, .maximum = 90},
                       .series = series,
                       .n_series = q->n};
  TRY(chart_print(&chart, &svg, error));
  TRY(study_write(c->run, name, &svg, error));
cleanup:
  text_free(&svg);
  array_free(series);
  array_free(angles);
  return status;
}

static Status draw(const Comparison *c, Error *error) {
  Status status = STATUS_OK;
  const Study *study = c->run->study;
  for (size_t p = 0; p < study->n_points; p++) TRY(draw_point(c, p, error));
  if (study->n_axes != 1 || !study->axes[0].is_numeric || study->n_points < 2) goto cleanup;
  TRY(draw_angles(c, "site.angle_to_major_axis_deg", "angle to the major axis (degrees)",
                  "angle_to_major.svg", error));
  TRY(draw_angles(c, "site.angle_to_vorticity_deg", "angle to the vorticity axis (degrees)",
                  "angle_to_vorticity.svg", error));
cleanup:
  return status;
}

/* ---- the study ---- */

/* Every scene is read and its laws are opened before the first one runs. */
static Status check_all(Comparison *c, Error *error) {
  Status status = STATUS_OK;
  const Study *study = c->run->study;
  const YamlNode *list = yaml_tree_find(study->root, "criteria");
  for (size_t k = 0; k < study->n_points * c->question.n; k++)
    c->strength[MODE_PASSIVE][k] = (Calibrated){.scale = 1};
  for (size_t p = 0; p < study->n_points; p++) {
    study_point(study, p, c->settings);
    TRY(print_criteria(c, p, &c->text, error));
    put_setting(c, 0, "observe.criteria", c->text.data);
    c->settings[study->n_axes].place = list->place;
    TRY(study_check(study, c->settings, study->n_axes + 1, error));
  }
cleanup:
  return status;
}

static Status compare(StudyRun *run, Error *error) {
  Status status = STATUS_OK;
  const Study *study = run->study;
  Comparison c = {.run = run};
  TRY(question_read(study, &c.question, error));
  const size_t n = c.question.n * study->n_points;
  for (int mode = 0; mode < 2; mode++) TRY(ARRAY_NEW(&c.strength[mode], n, error));
  TRY(ARRAY_NEW(&c.rows, 2 * n, error));
  TRY(ARRAY_NEW(&c.settings, study->n_axes + 2, error));
  TRY(check_all(&c, error));
  TRY(calibrate(run, &c.question.goal, c.question.contenders, c.question.n, c.question.acts,
                c.strength[MODE_PASSIVE], c.strength[MODE_COUPLED], error));
  for (size_t p = 0; p < study->n_points; p++) TRY(request_point(&c, p, error));
  TRY(runner_wait_all(run->runner, error));
  TRY(write_table(&c, error));
  summarize(&c);
  TRY(draw(&c, error));
cleanup:
  text_free(&c.text);
  text_free(&c.label);
  array_free(c.settings);
  array_free(c.rows);
  for (int mode = 0; mode < 2; mode++) array_free(c.strength[mode]);
  question_free(&c.question);
  return status;
}

static Status prepare(Study *study, Error *error) {
  Question question;
  Status status = question_read(study, &question, error);
  if (status != STATUS_OK) return status;
  status = study_set(study, "output.snapshot_every", "0", error);
  if (status == STATUS_OK && question.mode == MODE_COUPLED) /* where each law acts by itself */
    status = study_set(study, "membrane.damage", "", error);
  question_free(&question);
  return status;
}

static const char *const KEYS[] = {"mode", "criteria", "confirm", "calibrate", NULL};

const StudyKind COMPARE = {
    .name = "compare", .keys = KEYS, .prepare = prepare, .run = compare, .keeps_states = true};
