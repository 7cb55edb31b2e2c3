/* A factor is sought on a ladder of exponents of 2, whose rungs are tried side by side: the step between the
 * last rung where the event comes and the first where it does not is the ladder of the next round. */
#include "study/calibration.h"

#include "base/array.h"
#include "study/entry.h"
#include "study/label.h"
#include "study/study_run.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_STEPS = 16 };

typedef struct {
  int rounds, steps; /* steps of each round */
  double low, high;  /* exponents of the first round, on top of where the search stands */
} Ladder;

/* Factors 1/16 to 16, to 2^(1/512). */
static const Ladder PASSIVE = {3, 16, -4, 4};
/* With feedback: from the factor without it to 32 times that, to 2^(1/51).  A run a rung, hence by halves. */
static const Ladder COUPLED = {8, 2, 0, 5};

typedef struct {
  double exponent;
  bool is_allowed; /* by the law: parameters have ranges */
  int number;      /* of the case; -1: none */
  size_t entry;    /* in its list of criteria */
} Rung;

/* The search for one factor. */
typedef struct {
  double low, high;    /* exponents; the event comes at `low`, once there has been a round */
  bool is_high_barred; /* by the law: the event may come there too */
  const char *reason;  /* why there is no factor */
  Rung rung[MOST_STEPS + 1];
  int n_rungs;
} Search;

typedef struct {
  const StudyRun *run;
  const CalibrationGoal *goal;
  const Contender *contenders;
  size_t n;
  Search *search;     /* [n_points][n] */
  Override *settings; /* [n_axes + 3] of a case */
  size_t n_settings;  /* without those of the contenders */
  Text text, label;   /* scratch */
} Calibration;

Status calibration_read(const YamlNode *node, CalibrationGoal *goal, Error *error) {
  static const char *const keys[] = {"Ca_c", "Ca_l", NULL};
  double ignored;
  Status status = STATUS_OK;
  *goal = (CalibrationGoal){.is_asked = node != NULL};
  if (!node) return STATUS_OK;
  if (node->kind != YAML_TREE_MAPPING || node->count != 1)
    return place_error(&node->place, error, "expected `{Ca_c: }` or `{Ca_l: }` for `calibrate`, found %s",
                       yaml_tree_found(node).text);
  TRY(entry_check_keys(node, keys, NULL, error));
  goal->Ca = node->items[0];
  goal->onset = strcmp(goal->Ca->key, keys[0]) == 0;
  if (goal->Ca->kind == YAML_TREE_TEXT && strcmp(goal->Ca->text, "scene") == 0) goto cleanup;
  TRY(entry_number(goal->Ca, goal->Ca->key, &ignored, error));
cleanup:
  return status;
}

/* ---- cases ---- */

/* The settings of a point at the capillary number of the calibration. */
static void place(Calibration *c, size_t point) {
  static const char KEY[] = "flow.capillary_number";
  const Study *study = c->run->study;
  study_point(study, point, c->settings);
  c->n_settings = study->n_axes;
  if (strcmp(c->goal->Ca->text, "scene") == 0) return;
  size_t at = 0;
  while (at < study->n_axes && strcmp(c->settings[at].key, KEY) != 0) at++;
  c->settings[at] = (Override){.key = KEY, .value = c->goal->Ca->text, .place = c->goal->Ca->place};
  if (at == study->n_axes) c->n_settings++;
}

static Status start_label(Calibration *c, Error *error) {
  c->label.length = 0;
  return label_append(&c->label, c->settings, c->n_settings, error);
}

static void add_setting(Calibration *c, size_t *n, const char *key, const char *value) {
  c->settings[(*n)++] = (Override){.key = key, .value = value, .place = c->run->study->root->place};
}

/* Whether the law takes the contender's parameters at this factor. */
static Status ask_law(Calibration *c, const Contender *contender, Rung *rung, Error *error) {
  Status status = STATUS_OK;
  Error why;
  size_t n = c->n_settings;
  c->text.length = 0;
  TRY(text_append(&c->text, error, "["));
  TRY(contender_print(contender, "c", exp2(rung->exponent), &c->text, error));
  TRY(text_append(&c->text, error, "]"));
  add_setting(c, &n, "observe.criteria", c->text.data);
  rung->is_allowed = study_check(c->run->study, c->settings, n, &why) == STATUS_OK;
cleanup:
  return status;
}

/* One case in which all contenders of a point look on at all their factors. */
static Status request_passive(Calibration *c, size_t point, int round, Error *error) {
  Status status = STATUS_OK;
  size_t n = c->n_settings, entry = 0;
  int number;
  Search *search = c->search + point * c->n;
  char name[48];
  c->text.length = 0;
  TRY(text_append(&c->text, error, "["));
  for (size_t i = 0; i < c->n; i++)
    for (int k = 0; k < search[i].n_rungs; k++) {
      if (!search[i].rung[k].is_allowed) continue;
      snprintf(name, sizeof name, "c%zu-%d", i, k);
      search[i].rung[k].entry = entry;
      TRY(text_append(&c->text, error, "%s", entry++ ? ", " : ""));
      TRY(contender_print(&c->contenders[i], name, exp2(search[i].rung[k].exponent), &c->text, error));
    }
  if (entry == 0) goto cleanup;
  TRY(text_append(&c->text, error, "]"));
  add_setting(c, &n, "observe.criteria", c->text.data);
  TRY(start_label(c, error));
  TRY(text_append(&c->label, error, ",calibration=%d", round + 1));
  TRY(runner_request(c->run->runner, c->label.data, c->settings, n, &number, error));
  for (size_t i = 0; i < c->n; i++)
    for (int k = 0; k < search[i].n_rungs; k++)
      if (search[i].rung[k].is_allowed) search[i].rung[k].number = number;
cleanup:
  return status;
}

/* One case for each factor: the contender acts on the membrane, and looks on at itself. */
static Status request_coupled(Calibration *c, size_t point, size_t i, Error *error) {
  Status status = STATUS_OK;
  Search *search = &c->search[point * c->n + i];
  Text list = {0};
  for (int k = 0; k < search->n_rungs; k++) {
    Rung *rung = &search->rung[k];
    size_t n = c->n_settings;
    if (!rung->is_allowed) continue;
    c->text.length = list.length = 0;
    TRY(contender_print(&c->contenders[i], NULL, exp2(rung->exponent), &c->text, error));
    TRY(text_append(&list, error, "["));
    TRY(contender_print(&c->contenders[i], "c", exp2(rung->exponent), &list, error));
    TRY(text_append(&list, error, "]"));
    add_setting(c, &n, "membrane.damage", c->text.data);
    add_setting(c, &n, "observe.criteria", list.data);
    TRY(start_label(c, error));
    TRY(text_append(&c->label, error, ",calibration=%s,exponent=%.9g", c->contenders[i].name,
                    rung->exponent));
    TRY(runner_request(c->run->runner, c->label.data, c->settings, n, &rung->number, error));
    rung->entry = 0;
  }
cleanup:
  text_free(&list);
  return status;
}

/* ---- rounds ---- */

static Status make_rungs(Calibration *c, size_t point, int round, int steps, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < c->n; i++) {
    Search *search = &c->search[point * c->n + i];
    search->n_rungs = 0;
    if (search->reason) continue;
    const int first = round > 0, last = round > 0 ? steps - 1 : steps; /* the ends are known by then */
    for (int k = first; k <= last; k++) {
      Rung rung = {.exponent = search->low + (search->high - search->low) * k / steps, .number = -1};
      TRY(ask_law(c, &c->contenders[i], &rung, error));
      search->rung[search->n_rungs++] = rung;
    }
  }
cleanup:
  return status;
}

/* -1: not known, the case has not ended well. */
static int has_come(const Calibration *c, const Rung *rung) {
  char key[48];
  if (!rung->is_allowed) return 0;
  const Case *item = rung->number < 0 ? NULL : runner_case(c->run->runner, rung->number);
  if (!item || item->state != CASE_DONE) return -1;
  snprintf(key, sizeof key, "criteria.%zu.%s", rung->entry, c->goal->onset ? "t_c" : "t_l");
  return !isnan(case_number(item, key));
}

static const char *const NOT_ENDED = "a run of the calibration has not ended";
static const char *const NEVER = "the event does not come even at the least strength that was tried";
static const char *const ALWAYS = "the event still comes at the greatest strength that was tried";
static const char *const BARRED = "the event still comes at the greatest strength that the law allows";

/* To the last rung at which the event comes, and the one above it. */
static void narrow(const Calibration *c, Search *search, int round) {
  int last = -1;
  for (int k = 0; k < search->n_rungs && !search->reason; k++) {
    const int answer = has_come(c, &search->rung[k]);
    if (answer < 0) search->reason = NOT_ENDED;
    if (answer > 0) last = k;
  }
  if (search->reason) return;
  if (last < 0 && round == 0) search->reason = NEVER;
  if (last + 1 == search->n_rungs && round == 0) search->reason = ALWAYS;
  if (last >= 0) search->low = search->rung[last].exponent;
  if (last + 1 == search->n_rungs) return;
  search->high = search->rung[last + 1].exponent;
  search->is_high_barred = !search->rung[last + 1].is_allowed;
}

/* The rounds of all searches that have found no reason against it. */
static Status climb(Calibration *c, const Ladder *ladder, Error *error) {
  Status status = STATUS_OK;
  const size_t points = c->run->study->n_points, count = points * c->n;
  for (size_t k = 0; k < count; k++) {
    c->search[k].high = c->search[k].low + ladder->high;
    c->search[k].low += ladder->low;
  }
  for (int round = 0; round < ladder->rounds; round++) {
    for (size_t p = 0; p < points; p++) {
      place(c, p);
      TRY(make_rungs(c, p, round, ladder->steps, error));
      if (ladder == &PASSIVE) TRY(request_passive(c, p, round, error));
      for (size_t i = 0; ladder == &COUPLED && i < c->n; i++) TRY(request_coupled(c, p, i, error));
    }
    TRY(runner_wait_all(c->run->runner, error));
    for (size_t k = 0; k < count; k++) narrow(c, &c->search[k], round);
  }
  for (size_t k = 0; k < count; k++)
    if (!c->search[k].reason && c->search[k].is_high_barred) c->search[k].reason = BARRED;
cleanup:
  return status;
}

static void tell(const Calibration *c, Calibrated *result) {
  for (size_t k = 0; k < c->run->study->n_points * c->n; k++)
    result[k] = (Calibrated){.scale = c->search[k].reason ? NAN : exp2(c->search[k].low),
                             .reason = c->search[k].reason};
}

Status calibrate(const StudyRun *run, const CalibrationGoal *goal, const Contender *contenders, size_t n,
                 const bool *acts, Calibrated *passive, Calibrated *coupled, Error *error) {
  static const char *const NOT_ASKED = "";
  Status status = STATUS_OK;
  const size_t count = run->study->n_points * n;
  Calibration c = {.run = run, .goal = goal, .contenders = contenders, .n = n};
  for (size_t k = 0; k < count; k++) passive[k] = coupled[k] = (Calibrated){.scale = 1};
  if (!goal->is_asked) return STATUS_OK;
  TRY(ARRAY_NEW(&c.search, count, error));
  TRY(ARRAY_NEW(&c.settings, run->study->n_axes + 3, error));
  TRY(climb(&c, &PASSIVE, error));
  tell(&c, passive);
  for (size_t k = 0; k < count; k++)
    if (!acts[k % n]) c.search[k].reason = NOT_ASKED;
  if (!goal->onset) TRY(climb(&c, &COUPLED, error)); /* there is no feedback before the onset */
  tell(&c, coupled);
cleanup:
  text_free(&c.text);
  text_free(&c.label);
  array_free(c.settings);
  array_free(c.search);
  return status;
}
