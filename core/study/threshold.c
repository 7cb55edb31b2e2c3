/* One search for each target and point.  Those for the onset of damage are read off elastic runs where the
 * damage law allows it; the others begin where their neighbours, or the elastic runs and the law, let expect
 * the answer. */
#include "study/threshold.h"

#include "base/array.h"
#include "study/answer.h"
#include "study/decimal.h"
#include "study/elastic.h"
#include "study/neighbours.h"
#include "study/onset.h"
#include "study/plan.h"
#include "study/study_chart.h"
#include "study/table.h"
#include "study/trial_search.h"
#include <math.h>
#include <string.h>

/* Share of the elastic severity at which capsules give way: the membrane around a weak point carries a part
 * of its load.  It serves first guesses only. */
static const double RELIEF = 1.2;
/* How far from such a guess, relative to it, the first trials are made. */
static const double FIRST_REACH = 0.08;

typedef struct {
  Override *settings; /* [n_axes] */
  bool knows_onset;
  DamageOnset onset;
  Elastic *elastic; /* of its group; NULL: none serves */
} Point;

typedef struct {
  StudyRun *run;
  Plan plan;
  Point *points;    /* [n_points] */
  Search *searches; /* [n_targets][n_points]; not begun where the elastic runs answer */
  double *ratio;    /* [n_targets][n_points] of the answer to the first guess; NAN: not known */
  Elastic *groups;  /* [n_groups] */
  size_t n_groups;
} Threshold;

/* ---- the study file ---- */

/* The scenes at both ends of the bracket, for each target and point. */
static Status check(const Study *study, const Plan *plan, Error *error) {
  Status status = STATUS_OK;
  Override *settings = NULL;
  TRY(ARRAY_NEW(&settings, study->n_axes + 1, error));
  for (size_t point = 0; point < study->n_points; point++)
    for (size_t t = 0; t < 2 * plan->n_targets; t++) {
      char value[DECIMAL_SIZE];
      decimal_print(t % 2 ? plan->high : plan->low, value);
      study_point(study, point, settings);
      settings[study->n_axes] = (Override){.key = plan->target[t / 2].key,
                                           .value = value,
                                           .place = yaml_tree_find(study->root, "bracket")->place};
      TRY(study_check(study, settings, study->n_axes + 1, error));
    }
cleanup:
  array_free(settings);
  return status;
}

/* Runs are made until rupture or a steady state, and nothing but their ends is of interest. */
static Status prepare(Study *study, Error *error) {
  static const char *const settings[][2] = {
      {"stop.rupture", "stop"}, {"stop.steady", "5e-4"}, {"output.history_every", "0.05"}};
  Status status = STATUS_OK;
  Plan plan;
  TRY(plan_read(study, &plan, error));
  for (size_t i = 0; i < sizeof settings / sizeof *settings; i++)
    if (!study_scene_gives(study, settings[i][0]))
      TRY(study_set(study, settings[i][0], settings[i][1], error));
  TRY(study_set(study, "output.snapshot_every", "0", error));
  TRY(check(study, &plan, error));
cleanup:
  return status;
}

/* ---- setting up ---- */

/* What the damage law of a point says, with the searched key at the low end. */
static Status ask_law(const Threshold *threshold, Point *point, Error *error) {
  Status status = STATUS_OK;
  const Study *study = threshold->run->study;
  const Plan *plan = &threshold->plan;
  Override *settings = NULL;
  Scene scene = {0};
  Simulation laws = {0};
  char value[DECIMAL_SIZE];
  decimal_print(plan->low, value);
  TRY(ARRAY_NEW(&settings, study->n_axes + 1, error));
  memcpy(settings, point->settings, study->n_axes * sizeof *settings);
  settings[study->n_axes] = (Override){.key = plan->target[0].key, .value = value};
  TRY(study_scene(study, settings, study->n_axes + 1, &scene, &laws, error));
  TRY(damage_onset(&laws.material, &point->knows_onset, &point->onset, error));
cleanup:
  simulation_free(&laws);
  scene_free(&scene);
  array_free(settings);
  return status;
}

static bool is_of_damage(const char *key) {
  return strncmp(key, "membrane.damage", strlen("membrane.damage")) == 0;
}

/* The target that elastic runs answer, or NULL: the onset of damage along a key of the undamaged capsule. */
static const Target *onset_target(const Plan *plan) {
  for (size_t t = 0; t < plan->n_targets; t++)
    if (plan->target[t].condition == WHEN_DAMAGED && !is_of_damage(plan->target[t].key))
      return &plan->target[t];
  return NULL;
}

static Status join_group(Threshold *threshold, Point *point, Error *error) {
  Status status = STATUS_OK;
  const Plan *plan = &threshold->plan;
  const Target *target = onset_target(plan);
  const size_t n = threshold->run->study->n_axes;
  if (!target || !point->knows_onset) return STATUS_OK;
  for (size_t g = 0; g < threshold->n_groups && !point->elastic; g++)
    if (elastic_is_of(&threshold->groups[g], target->key, point->settings, n))
      point->elastic = &threshold->groups[g];
  if (!point->elastic) {
    point->elastic = &threshold->groups[threshold->n_groups];
    TRY(elastic_new(point->elastic, target->key, point->settings, n, plan->low, plan->high, plan->tolerance,
                    error));
    threshold->n_groups++;
  }
  TRY(elastic_add_level(point->elastic, point->onset.onset, error));
cleanup:
  return status;
}

static Status set_up(Threshold *threshold, StudyRun *run, Error *error) {
  Status status = STATUS_OK;
  const Study *study = run->study;
  *threshold = (Threshold){.run = run};
  TRY(plan_read(study, &threshold->plan, error));
  const size_t searches = threshold->plan.n_targets * study->n_points;
  TRY(ARRAY_NEW(&threshold->points, study->n_points, error));
  TRY(ARRAY_NEW(&threshold->groups, study->n_points, error));
  TRY(ARRAY_NEW(&threshold->searches, searches, error));
  TRY(ARRAY_NEW(&threshold->ratio, searches, error));
  for (size_t p = 0; p < study->n_points; p++) {
    Point *point = &threshold->points[p];
    TRY(ARRAY_NEW(&point->settings, study->n_axes, error));
    study_point(study, p, point->settings);
    TRY(ask_law(threshold, point, error));
    TRY(join_group(threshold, point, error));
  }
  for (size_t s = 0; s < searches; s++) {
    threshold->searches[s].target = &threshold->plan.target[s / study->n_points];
    threshold->searches[s].settings = threshold->points[s % study->n_points].settings;
    threshold->searches[s].n_settings = study->n_axes;
    threshold->ratio[s] = NAN;
  }
cleanup:
  return status;
}

static void tear_down(Threshold *threshold) {
  for (size_t p = 0; threshold->points && p < threshold->run->study->n_points; p++)
    array_free(threshold->points[p].settings);
  for (size_t g = 0; g < threshold->n_groups; g++) elastic_free(&threshold->groups[g]);
  array_free(threshold->points);
  array_free(threshold->groups);
  array_free(threshold->searches);
  array_free(threshold->ratio);
}

/* ---- searching ---- */

static bool is_elastic(const Threshold *threshold, size_t t, size_t p) {
  return threshold->points[p].elastic && &threshold->plan.target[t] == onset_target(&threshold->plan);
}

/* The elastic run in which the sound membrane would reach what the law bears, somewhat relieved. */
static double guess_from_law(const Threshold *threshold, size_t t, size_t p) {
  const Point *point = &threshold->points[p];
  const Target *target = &threshold->plan.target[t];
  if (!point->elastic || target->condition != WHEN_RUPTURED || strcmp(target->key, point->elastic->key) != 0)
    return NAN;
  const LevelCrossing crossing = elastic_cross(point->elastic, RELIEF * point->onset.severity);
  if (!isnan(crossing.x)) return crossing.x;
  return isnan(crossing.low) ? threshold->plan.low : threshold->plan.high;
}

/* Whether all that a search may lean on is known. */
static bool may_begin(const Threshold *threshold, size_t t, size_t p) {
  const Study *study = threshold->run->study;
  if (threshold->points[p].elastic && !threshold->points[p].elastic->over) return false;
  for (size_t other = 0; other < study->n_points; other++)
    if (neighbours_lean(study, p, other) && !is_elastic(threshold, t, other) &&
        !threshold->searches[t * study->n_points + other].over)
      return false;
  return true;
}

static void begin(Threshold *threshold, size_t t, size_t p) {
  const Plan *plan = &threshold->plan;
  const size_t n = threshold->run->study->n_points;
  const double scale = guess_from_law(threshold, t, p), base = isnan(scale) ? 1 : scale;
  const double expected = neighbours_expect(threshold->run->study, p, threshold->ratio + t * n);
  Search *search = &threshold->searches[t * n + p];
  if (!isnan(expected))
    search_begin(search, plan->low, plan->high, plan->tolerance, expected * base, 0.5 * plan->tolerance);
  else if (!isnan(scale))
    search_begin(search, plan->low, plan->high, plan->tolerance, scale, FIRST_REACH * scale);
  else
    search_begin(search, plan->low, plan->high, plan->tolerance, NAN, 0.25 * (plan->high - plan->low));
}

static void keep_ratio(Threshold *threshold, size_t t, size_t p) {
  const size_t s = t * threshold->run->study->n_points + p;
  const double scale = guess_from_law(threshold, t, p);
  threshold->ratio[s] = bracket_value(&threshold->searches[s].bracket) / (isnan(scale) ? 1 : scale);
}

static Status advance(Threshold *threshold, bool *moved, Error *error) {
  Status status = STATUS_OK;
  const size_t n = threshold->run->study->n_points;
  for (size_t g = 0; g < threshold->n_groups; g++)
    TRY(elastic_advance(&threshold->groups[g], threshold->run->runner, moved, error));
  for (size_t s = 0; s < threshold->plan.n_targets * n; s++) {
    Search *search = &threshold->searches[s];
    if (search->over || is_elastic(threshold, s / n, s % n)) continue;
    if (!search->begun && !may_begin(threshold, s / n, s % n)) continue;
    if (!search->begun) begin(threshold, s / n, s % n);
    TRY(search_advance(search, threshold->run->runner, moved, error));
    if (search->over) keep_ratio(threshold, s / n, s % n);
  }
cleanup:
  return status;
}

static bool is_over(const Threshold *threshold) {
  const size_t n = threshold->run->study->n_points;
  for (size_t g = 0; g < threshold->n_groups; g++)
    if (!threshold->groups[g].over) return false;
  for (size_t s = 0; s < threshold->plan.n_targets * n; s++)
    if (!threshold->searches[s].over && !is_elastic(threshold, s / n, s % n)) return false;
  return true;
}

/* For the time left: a search takes three runs when its guess is good. */
static long expected_cases(const Threshold *threshold) {
  const size_t n = threshold->run->study->n_points;
  long cases = 0;
  for (size_t g = 0; g < threshold->n_groups; g++) cases += threshold->groups[g].over ? 0 : 4;
  for (size_t g = 0; g < threshold->n_groups; g++) cases += threshold->groups[g].runs;
  for (size_t s = 0; s < threshold->plan.n_targets * n; s++) {
    const Search *search = &threshold->searches[s];
    if (is_elastic(threshold, s / n, s % n)) continue;
    cases += search->over || search->runs > 3 ? search->runs : 3;
  }
  return cases;
}

static Status search_all(Threshold *threshold, Error *error) {
  Status status = STATUS_OK;
  Runner *runner = threshold->run->runner;
  while (!is_over(threshold) && !runner_interrupted(runner)) {
    bool moved = false;
    TRY(advance(threshold, &moved, error));
    runner_expect(runner, expected_cases(threshold));
    if (!moved) TRY(runner_wait(runner, error));
  }
cleanup:
  return status;
}

/* ---- results ---- */

static Answer elastic_answer(const Point *point) {
  const LevelCrossing crossing = elastic_cross(point->elastic, point->onset.onset);
  Answer answer = {.value = decimal_digits(crossing.x, 6),
                   .low = crossing.low,
                   .high = crossing.high,
                   .error = decimal_digits(crossing.error, 2)};
  if (isnan(crossing.x))
    answer.note =
        point->elastic->reason ? point->elastic->reason : "damage does not begin inside the bracket";
  return answer;
}

static Answer answer_of(const Threshold *threshold, size_t t, size_t p) {
  if (is_elastic(threshold, t, p)) return elastic_answer(&threshold->points[p]);
  return search_answer(&threshold->searches[t * threshold->run->study->n_points + p]);
}

static void put_header(Table *table, const Threshold *threshold) {
  table_axes_header(table, threshold->run->study);
  for (size_t t = 0; t < threshold->plan.n_targets; t++) answer_header(table, threshold->plan.target[t].name);
  table_end_row(table);
}

static Status write_table(const Threshold *threshold, Error *error) {
  Table table;
  const Study *study = threshold->run->study;
  table_begin(&table, error);
  put_header(&table, threshold);
  for (size_t p = 0; p < study->n_points; p++) {
    table_axes(&table, study, p);
    for (size_t t = 0; t < threshold->plan.n_targets; t++) {
      const Answer answer = answer_of(threshold, t, p);
      answer_put(&table, &answer);
    }
    table_end_row(&table);
  }
  return table_write(&table, threshold->run->folder, "table.csv");
}

static void summarize(const Threshold *threshold) {
  Json *json = threshold->run->summary;
  const Plan *plan = &threshold->plan;
  const size_t searches = plan->n_targets * threshold->run->study->n_points;
  long elastic = 0, own = 0, unsettled = 0;
  for (size_t g = 0; g < threshold->n_groups; g++) elastic += threshold->groups[g].runs;
  for (size_t s = 0; s < searches; s++) {
    own += threshold->searches[s].runs;
    unsettled += threshold->searches[s].unsettled;
  }
  const long plain = (long)searches * bracket_plain_trials(plan->low, plan->high, plan->tolerance);
  json_integer(json, "points", (long long)threshold->run->study->n_points);
  json_integer(json, "elastic_runs", elastic);
  json_integer(json, "trial_runs", own);
  json_integer(json, "trial_runs_unsettled", unsettled);
  json_integer(json, "runs_by_plain_halving", plain);
  json_integer(json, "runs_saved", plain - elastic - own);
}

static Status draw(const Threshold *threshold, Error *error) {
  Status status = STATUS_OK;
  const size_t n = threshold->run->study->n_points;
  Curve curves[MOST_TARGETS];
  double *values = NULL;
  TRY(ARRAY_NEW(&values, threshold->plan.n_targets * n, error));
  for (size_t t = 0; t < threshold->plan.n_targets; t++) {
    curves[t] = (Curve){threshold->plan.target[t].name, values + t * n};
    for (size_t p = 0; p < n; p++) values[t * n + p] = answer_of(threshold, t, p).value;
  }
  TRY(study_chart_write(threshold->run, "diagram.svg", threshold->plan.target[0].key, curves,
                        threshold->plan.n_targets, error));
cleanup:
  array_free(values);
  return status;
}

/* The value of a single point, or of how many points there is none. */
static Status tell(const Threshold *threshold, Error *error) {
  Status status = STATUS_OK;
  const size_t n = threshold->run->study->n_points;
  Text *found = threshold->run->found;
  for (size_t t = 0; t < threshold->plan.n_targets; t++) {
    const char *name = threshold->plan.target[t].name;
    const Answer first = answer_of(threshold, t, 0);
    size_t missing = 0;
    for (size_t p = 0; p < n; p++) missing += isnan(answer_of(threshold, t, p).value);
    if (n > 1 && missing > 0)
      TRY(text_append(found, error, "%s: none found at %zu of %zu points; %s_note in table.csv says why\n",
                      name, missing, n, name));
    if (n == 1 && missing == 0)
      TRY(text_append(found, error, "%s = %g, between %g and %g\n", name, first.value, first.low,
                      first.high));
    if (n == 1 && missing > 0)
      TRY(text_append(found, error, "%s: none found: %s\n", name, first.note ? first.note : "interrupted"));
  }
cleanup:
  return status;
}

static Status find_thresholds(StudyRun *run, Error *error) {
  Status status = STATUS_OK;
  Threshold threshold;
  TRY(set_up(&threshold, run, error));
  TRY(search_all(&threshold, error));
  TRY(write_table(&threshold, error));
  summarize(&threshold);
  TRY(tell(&threshold, error));
  TRY(draw(&threshold, error));
cleanup:
  tear_down(&threshold);
  return status;
}

static const char *const KEYS[] = {"find", "bracket", "tolerance", NULL};

const StudyKind THRESHOLD = {.name = "threshold", .keys = KEYS, .prepare = prepare, .run = find_thresholds};
