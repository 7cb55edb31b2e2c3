/* One row of the table for each point of the outer product, each criterion, and each way of judging it.
 *
 * Limits are sought by the runs of the rows at other capillary numbers: those in which all criteria look on
 * serve all of them. */
#include "study/compare.h"

#include "base/array.h"
#include "study/compare_results.h"
#include "study/decimal.h"
#include "study/label.h"
#include <math.h>
#include <stdio.h>

/* ---- variants ---- */

/* The contenders of a point whose strength is known, as a list of criteria. */
static Status print_criteria(const Question *question, const Calibrated *strength, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  const char *separator = "";
  TRY(text_append(yaml, error, "["));
  for (size_t i = 0; i < question->n; i++) {
    if (isnan(strength[i].scale)) continue;
    TRY(text_append(yaml, error, "%s", separator));
    TRY(contender_print(&question->contenders[i], question->contenders[i].name, strength[i].scale, yaml,
                        error));
    separator = ", ";
  }
  TRY(text_append(yaml, error, "]"));
cleanup:
  return status;
}

static void variant_set(Variant *variant, const Study *study, const char *key, const char *value) {
  variant->settings[variant->n_settings++] =
      (Override){.key = key, .value = value, .place = study->root->place};
}

/* The scene of a point, with the start of a label. */
static Status variant_new(Variant *variant, const Study *study, size_t point, Error *error) {
  Status status = STATUS_OK;
  enum { OF_A_VARIANT = 3 }; /* damage, criteria, and a value that is tried */
  *variant = (Variant){.n_settings = study->n_axes};
  TRY(ARRAY_NEW(&variant->settings, study->n_axes + OF_A_VARIANT, error));
  study_point(study, point, variant->settings);
  TRY(label_append(&variant->label, variant->settings, study->n_axes, error));
cleanup:
  return status;
}

static void variant_free(Variant *variant) {
  array_free(variant->settings);
  text_free(&variant->criteria);
  text_free(&variant->damage);
  text_free(&variant->label);
}

/* All contenders look on. */
static Status make_passive(Variant *variant, const Study *study, const Question *question,
                           const Calibrated *strength, size_t point, Error *error) {
  Status status = STATUS_OK;
  TRY(variant_new(variant, study, point, error));
  TRY(print_criteria(question, strength, &variant->criteria, error));
  variant_set(variant, study, "observe.criteria", variant->criteria.data);
  TRY(text_append(&variant->label, error, ",passive"));
cleanup:
  return status;
}

/* The contender acts on the membrane, and looks on at itself. */
static Status make_coupled(Variant *variant, const Study *study, const Contender *contender, double scale,
                           size_t point, Error *error) {
  Status status = STATUS_OK;
  TRY(variant_new(variant, study, point, error));
  TRY(text_append(&variant->criteria, error, "["));
  TRY(contender_print(contender, contender->name, scale, &variant->criteria, error));
  TRY(text_append(&variant->criteria, error, "]"));
  TRY(contender_print(contender, NULL, scale, &variant->damage, error));
  variant_set(variant, study, "membrane.damage", variant->damage.data);
  variant_set(variant, study, "observe.criteria", variant->criteria.data);
  TRY(text_append(&variant->label, error, ",coupled=%s", contender->name));
cleanup:
  return status;
}

/* ---- cases ---- */

static const Calibrated *strength_of(const Comparison *c, Mode mode, size_t point) {
  return &c->strength[mode][point * c->question.n];
}

static Status request(Comparison *c, Variant *variant, Error *error) {
  return runner_request(c->run->runner, variant->label.data, variant->settings, variant->n_settings,
                        &variant->number, error);
}

/* A row whose contender is entry number `entry` of the variant's criteria. */
static void add_row(Comparison *c, Mode mode, size_t point, size_t contender, const Variant *variant,
                    size_t entry) {
  Row *row = &c->rows[c->n_rows++];
  *row = (Row){.point = point,
               .contender = contender,
               .mode = mode,
               .strength = strength_of(c, mode, point) + contender,
               .variant = variant};
  snprintf(row->where, sizeof row->where, "criteria.%zu.", entry);
}

static Status request_passive(Comparison *c, size_t point, Variant **variant, Error *error) {
  Status status = STATUS_OK;
  *variant = &c->variants[c->n_variants++];
  TRY(make_passive(*variant, c->run->study, &c->question, strength_of(c, MODE_PASSIVE, point), point, error));
  TRY(request(c, *variant, error));
cleanup:
  return status;
}

static Status request_coupled(Comparison *c, size_t point, size_t i, Error *error) {
  Status status = STATUS_OK;
  Variant *variant = NULL;
  const double scale = strength_of(c, MODE_COUPLED, point)[i].scale;
  if (!isnan(scale)) {
    variant = &c->variants[c->n_variants++];
    TRY(make_coupled(variant, c->run->study, &c->question.contenders[i], scale, point, error));
    TRY(request(c, variant, error));
  }
  add_row(c, MODE_COUPLED, point, i, variant, 0);
cleanup:
  return status;
}

static Status request_point(Comparison *c, size_t point, Error *error) {
  Status status = STATUS_OK;
  const Question *q = &c->question;
  const Calibrated *strength = strength_of(c, MODE_PASSIVE, point);
  Variant *passive = NULL;
  size_t entry = 0;
  if (q->mode == MODE_PASSIVE) TRY(request_passive(c, point, &passive, error));
  for (size_t i = 0; i < q->n; i++) {
    const bool is_known = !isnan(strength[i].scale);
    if (q->mode == MODE_PASSIVE) add_row(c, MODE_PASSIVE, point, i, is_known ? passive : NULL, entry);
    entry += is_known;
    if (q->acts[i]) TRY(request_coupled(c, point, i, error));
  }
cleanup:
  return status;
}

/* ---- limits ---- */

static void begin_searches(Comparison *c) {
  const Plan *plan = &c->question.plan;
  for (size_t k = 0; k < c->n_rows; k++)
    for (size_t t = 0; t < plan->n_targets && c->rows[k].variant; t++) {
      Row *row = &c->rows[k];
      row->search[t] = (Search){.target = &plan->target[t],
                                .settings = row->variant->settings,
                                .n_settings = row->variant->n_settings,
                                .label = row->variant->label.data,
                                .where = row->where};
      search_begin(&row->search[t], plan->low, plan->high, plan->tolerance, NAN,
                   0.25 * (plan->high - plan->low));
    }
}

static Status advance(Comparison *c, bool *moved, bool *over, Error *error) {
  Status status = STATUS_OK;
  for (size_t k = 0; k < c->n_rows; k++)
    for (size_t t = 0; t < c->question.plan.n_targets; t++) {
      Search *search = &c->rows[k].search[t];
      if (!search->begun) continue;
      TRY(search_advance(search, c->run->runner, moved, error));
      *over = *over && search->over;
    }
cleanup:
  return status;
}

static Status find_limits(Comparison *c, Error *error) {
  Status status = STATUS_OK;
  begin_searches(c);
  for (bool over = false; !over && !runner_interrupted(c->run->runner);) {
    bool moved = false;
    over = true;
    TRY(advance(c, &moved, &over, error));
    if (!over && !moved) TRY(runner_wait(c->run->runner, error));
  }
cleanup:
  return status;
}

/* ---- the study ---- */

/* Every scene is read and its laws are opened before the first one runs. */
static Status check_all(const Study *study, const Question *question, const Calibrated *strength,
                        Error *error) {
  Status status = STATUS_OK;
  char value[DECIMAL_SIZE];
  Variant variant = {0};
  decimal_print(question->plan.low, value);
  for (size_t p = 0; p < study->n_points; p++) {
    variant_free(&variant);
    TRY(make_passive(&variant, study, question, strength, p, error));
    variant.settings[study->n_axes].place = yaml_tree_find(study->root, "criteria")->place;
    TRY(study_check(study, variant.settings, variant.n_settings, error));
    if (question->plan.n_targets == 0) continue;
    variant_set(&variant, study, question->plan.target[0].key, value);
    variant.settings[variant.n_settings - 1].place = yaml_tree_find(study->root, "find")->place;
    TRY(study_check(study, variant.settings, variant.n_settings, error));
  }
cleanup:
  variant_free(&variant);
  return status;
}

static Status set_up(Comparison *c, Error *error) {
  Status status = STATUS_OK;
  TRY(question_read(c->run->study, &c->question, error));
  const size_t n = c->question.n * c->run->study->n_points;
  for (int mode = 0; mode < N_MODES; mode++) TRY(ARRAY_NEW(&c->strength[mode], n, error));
  TRY(ARRAY_NEW(&c->variants, n + c->run->study->n_points, error));
  TRY(ARRAY_NEW(&c->rows, N_MODES * n, error));
  for (size_t k = 0; k < n; k++) c->strength[MODE_PASSIVE][k] = (Calibrated){.scale = 1};
cleanup:
  return status;
}

static void tear_down(Comparison *c) {
  for (size_t k = 0; k < c->n_variants; k++) variant_free(&c->variants[k]);
  array_free(c->variants);
  array_free(c->rows);
  for (int mode = 0; mode < N_MODES; mode++) array_free(c->strength[mode]);
  question_free(&c->question);
}

static Status compare(StudyRun *run, Error *error) {
  Status status = STATUS_OK;
  Comparison c = {.run = run};
  const Question *q = &c.question;
  TRY(set_up(&c, error));
  TRY(check_all(run->study, q, c.strength[MODE_PASSIVE], error));
  TRY(calibrate(run, &q->goal, q->contenders, q->n, q->acts, c.strength[MODE_PASSIVE],
                c.strength[MODE_COUPLED], error));
  for (size_t p = 0; p < run->study->n_points; p++) TRY(request_point(&c, p, error));
  TRY(find_limits(&c, error));
  TRY(runner_wait_all(run->runner, error));
  TRY(compare_results_write(&c, error));
cleanup:
  tear_down(&c);
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

static const char *const KEYS[] = {"mode", "criteria", "confirm",   "calibrate",
                                   "find", "bracket",  "tolerance", NULL};

const StudyKind COMPARE = {
    .name = "compare", .keys = KEYS, .prepare = prepare, .run = compare, .keeps_states = true};
