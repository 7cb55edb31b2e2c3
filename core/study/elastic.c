#include "study/elastic.h"

#include "base/array.h"
#include "study/decimal.h"
#include "study/label.h"
#include <math.h>
#include <string.h>

enum { FIRST_TRIALS = 6, KEPT_SETTINGS = 2 /* besides those of the point: the key, and no damage */ };

/* The parabola's root is far better than its distance to the line's where the curve is smooth: a quarter of
 * the tolerance is safe there. */
static const double SHARE = 0.25;

static bool is_of_damage(const Override *setting) {
  static const char damage[] = "membrane.damage";
  const size_t length = sizeof damage - 1;
  return strncmp(setting->key, damage, length) == 0 &&
         (setting->key[length] == '\0' || setting->key[length] == '.');
}

Status elastic_new(Elastic *elastic, const char *key, const Override *settings, size_t n, double low,
                   double high, double tolerance, Error *error) {
  Status status = STATUS_OK;
  *elastic = (Elastic){.key = key, .low = low, .high = high, .tolerance = tolerance};
  TRY(ARRAY_NEW(&elastic->settings, n + KEPT_SETTINGS, error));
  for (size_t i = 0; i < n; i++)
    if (!is_of_damage(&settings[i])) elastic->settings[elastic->n_settings++] = settings[i];
cleanup:
  return status;
}

void elastic_free(Elastic *elastic) {
  level_curve_free(&elastic->curve);
  array_free(elastic->settings);
  array_free(elastic->levels);
  array_free(elastic->reason);
  *elastic = (Elastic){0};
}

bool elastic_is_of(const Elastic *elastic, const char *key, const Override *settings, size_t n) {
  size_t k = 0;
  if (strcmp(key, elastic->key) != 0) return false;
  for (size_t i = 0; i < n; i++) {
    if (is_of_damage(&settings[i])) continue;
    if (k == elastic->n_settings || strcmp(settings[i].key, elastic->settings[k].key) != 0 ||
        strcmp(settings[i].value, elastic->settings[k].value) != 0)
      return false;
    k++;
  }
  return k == elastic->n_settings;
}

Status elastic_add_level(Elastic *elastic, double level, Error *error) {
  if (elastic->n_levels == elastic->capacity) {
    const size_t capacity = elastic->capacity ? 2 * elastic->capacity : 32;
    double *levels;
    const Status status = ARRAY_NEW(&levels, capacity, error);
    if (status != STATUS_OK) return status;
    if (elastic->n_levels) memcpy(levels, elastic->levels, elastic->n_levels * sizeof *levels);
    array_free(elastic->levels);
    elastic->levels = levels;
    elastic->capacity = capacity;
  }
  elastic->levels[elastic->n_levels++] = level;
  return STATUS_OK;
}

LevelCrossing elastic_cross(const Elastic *elastic, double level) {
  return level_curve_cross(&elastic->curve, level);
}

/* ---- rounds ---- */

static double rounded(const Elastic *elastic, double x) {
  return fmin(fmax(decimal_multiple(x, decimal_unit(elastic->tolerance)), elastic->low), elastic->high);
}

static bool is_tried(const Elastic *elastic, double x) {
  for (size_t i = 0; i < elastic->n_trials; i++)
    if (elastic->trial[i] == x) return true;
  for (size_t i = 0; i < elastic->curve.n; i++)
    if (elastic->curve.x[i] == x) return true;
  return false;
}

static void add_trial(Elastic *elastic, double x) {
  x = rounded(elastic, x);
  if (is_tried(elastic, x)) return;
  if (elastic->n_trials < ELASTIC_TRIALS) elastic->trial[elastic->n_trials++] = x;
}

/* A coarse mesh can put a kink into the curve that far samples do not show: one within the tolerance of the
 * answer must bear it out. */
static bool is_known(const Elastic *elastic, LevelCrossing crossing) {
  if (isnan(crossing.low) || isnan(crossing.high)) return true; /* never passed in low .. high */
  const double nearest = fmin(crossing.x - crossing.low, crossing.high - crossing.x);
  return crossing.high - crossing.low <= elastic->tolerance ||
         (crossing.error <= SHARE * elastic->tolerance && nearest <= elastic->tolerance);
}

/* One trial in each interval that holds levels not known well enough: at the middle one of them, or, where
 * that is an end of the interval, as at a jump of the curve, halfway. */
static void ask_for_levels(Elastic *elastic) {
  for (size_t i = 0; i + 1 < elastic->curve.n; i++) {
    double sum = 0;
    int n = 0;
    for (size_t k = 0; k < elastic->n_levels; k++) {
      const LevelCrossing crossing = elastic_cross(elastic, elastic->levels[k]);
      if (crossing.low != elastic->curve.x[i] || is_known(elastic, crossing)) continue;
      sum += crossing.x;
      n++;
    }
    if (n == 0) continue;
    const double x = sum / n, halfway = 0.5 * (elastic->curve.x[i] + elastic->curve.x[i + 1]);
    add_trial(elastic, is_tried(elastic, rounded(elastic, x)) ? halfway : x);
  }
}

/* Evenly spaced logarithms, for which the curve is nearly straight. */
static void ask_first(Elastic *elastic) {
  const double ratio = log(elastic->high / elastic->low);
  for (int k = 0; k < FIRST_TRIALS; k++)
    add_trial(elastic, elastic->low * exp(ratio * k / (FIRST_TRIALS - 1)));
}

static Status request(Elastic *elastic, Runner *runner, Error *error) {
  Status status = STATUS_OK;
  Text label = {0};
  const size_t n = elastic->n_settings;
  for (size_t i = 0; i < elastic->n_trials; i++) {
    char value[DECIMAL_SIZE];
    decimal_print(elastic->trial[i], value);
    elastic->settings[n] = (Override){.key = elastic->key, .value = value};
    elastic->settings[n + 1] = (Override){.key = "membrane.damage", .value = ""};
    label.length = 0;
    TRY(text_append(&label, error, "elastic,"));
    TRY(label_append(&label, elastic->settings, n + 1, error));
    TRY(runner_request(runner, label.data, elastic->settings, n + 2, &elastic->cases[i], error));
    elastic->runs++;
  }
cleanup:
  text_free(&label);
  return status;
}

static Status learn(Elastic *elastic, const Runner *runner, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < elastic->n_trials; i++) {
    const Case *item = runner_case(runner, elastic->cases[i]);
    const double Y = case_number(item, "Y_max");
    if (item->state == CASE_DONE && Y > 0) {
      TRY(level_curve_add(&elastic->curve, elastic->trial[i], Y, error));
    } else if (!elastic->reason) {
      elastic->reason = text_copy(item->reason ? item->reason : "no Y_max", error);
      if (!elastic->reason) TRY(error->code);
    }
  }
  elastic->n_trials = 0;
cleanup:
  return status;
}

static bool all_ended(const Elastic *elastic, const Runner *runner) {
  for (size_t i = 0; i < elastic->n_trials; i++)
    if (!case_ended(runner_case(runner, elastic->cases[i]))) return false;
  return true;
}

Status elastic_advance(Elastic *elastic, Runner *runner, bool *moved, Error *error) {
  Status status = STATUS_OK;
  if (elastic->over || !all_ended(elastic, runner)) return STATUS_OK;
  *moved = true;
  TRY(learn(elastic, runner, error));
  if (!elastic->begun)
    ask_first(elastic);
  else
    ask_for_levels(elastic);
  elastic->begun = true;
  elastic->over = elastic->n_trials == 0;
  TRY(request(elastic, runner, error));
cleanup:
  return status;
}
