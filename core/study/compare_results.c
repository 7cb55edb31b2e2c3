#include "study/compare_results.h"

#include "base/array.h"
#include "observe/chart.h"
#include "study/sites.h"
#include "study/table.h"
#include <math.h>
#include <stdio.h>

/* ---- figures ---- */

static const Case *case_of(const Comparison *c, const Row *row) {
  return row->variant ? runner_case(c->run->runner, row->variant->number) : NULL;
}

static double figure(const Comparison *c, const Row *row, const char *key) {
  char path[80];
  const Case *item = case_of(c, row);
  snprintf(path, sizeof path, "%s%s", row->where, key);
  return item ? case_number(item, path) : NAN;
}

static double component(const Comparison *c, const Row *row, const char *key, size_t k) {
  char path[80];
  const Case *item = case_of(c, row);
  snprintf(path, sizeof path, "%s%s", row->where, key);
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

static void put_header(Table *table, const Study *study, const Question *question) {
  static const char *const first[] = {"criterion", "law", "mode", "strength", "case", "status", "region"};
  static const char *const axes[] = {"1", "2", "3"};
  table_axes_header(table, study);
  for (size_t k = 0; k < sizeof first / sizeof *first; k++) table_text(table, first[k]);
  for (int k = 0; k < N_FIGURES; k++) table_text(table, FIGURES[k].column);
  for (int k = 0; k < 3; k++) table_component(table, "X", axes[k]);
  for (int k = 0; k < 3; k++) table_component(table, "x", axes[k]);
  for (size_t t = 0; t < question->plan.n_targets; t++) answer_header(table, question->plan.target[t].name);
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
  for (size_t t = 0; t < c->question.plan.n_targets; t++) {
    const Answer answer = search_answer(&row->search[t]);
    answer_put(table, &answer);
  }
  table_text(table, row->strength->reason ? row->strength->reason : item ? item->reason : NULL);
  table_end_row(table);
}

static Status write_table(const Comparison *c, Error *error) {
  Table table;
  table_begin(&table, error);
  put_header(&table, c->run->study, &c->question);
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
    for (size_t t = 0; t < c->question.plan.n_targets; t++)
      json_number(json, c->question.plan.target[t].name, search_answer(&row->search[t]).value);
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

Status compare_results_write(const Comparison *comparison, Error *error) {
  Status status = STATUS_OK;
  TRY(write_table(comparison, error));
  summarize(comparison);
  TRY(draw(comparison, error));
cleanup:
  return status;
}
