#include "study/trial_search.h"

#include "base/array.h"
#include "study/decimal.h"
#include "study/label.h"
#include <math.h>
#include <string.h>

void search_begin(Search *search, double low, double high, double tolerance, double guess, double reach) {
  bracket_start(&search->bracket, low, high, tolerance, guess, reach);
  search->begun = true;
}

/* Of the case with settings [n_settings + 1], the last of which is tried. */
static Status print_label(const Search *search, const Override *settings, Text *label, Error *error) {
  Status status = STATUS_OK;
  label->length = 0;
  if (!search->label) return label_append(label, settings, search->n_settings + 1, error);
  TRY(text_append(label, error, "%s,", search->label));
  TRY(label_append(label, settings + search->n_settings, 1, error));
cleanup:
  return status;
}

static Status request(Search *search, Runner *runner, Error *error) {
  Status status = STATUS_OK;
  Text label = {0};
  Override *settings = NULL;
  const size_t n = search->n_settings;
  TRY(ARRAY_NEW(&settings, n + 1, error));
  for (size_t i = 0; i < n; i++) settings[i] = search->settings[i];
  for (int i = 0; i < search->n_trials; i++) {
    char value[DECIMAL_SIZE];
    decimal_print(search->trial[i], value);
    settings[n] = (Override){.key = search->target->key, .value = value};
    TRY(print_label(search, settings, &label, error));
    TRY(runner_request(runner, label.data, settings, n + 1, &search->cases[i], error));
    search->runs++;
  }
cleanup:
  array_free(settings);
  text_free(&label);
  return status;
}

static void learn(Search *search, const Case *item, double value) {
  if (item->state == CASE_FAILED) {
    search->reason = item->reason;
    return;
  }
  const bool holds = target_holds(search->target, item, search->where);
  search->unsettled += !holds && strcmp(case_status(item), "end") == 0;
  bracket_learn(&search->bracket, value, holds);
}

static const char *why_open(const Bracket *bracket) {
  if (isnan(bracket->no)) return "the condition holds in the whole bracket";
  if (isnan(bracket->yes)) return "the condition holds nowhere in the bracket";
  return NULL;
}

Status search_advance(Search *search, Runner *runner, bool *moved, Error *error) {
  if (search->over) return STATUS_OK;
  for (int i = 0; i < search->n_trials; i++)
    if (!case_ended(runner_case(runner, search->cases[i]))) return STATUS_OK;
  *moved = true;
  for (int i = 0; i < search->n_trials; i++)
    learn(search, runner_case(runner, search->cases[i]), search->trial[i]);
  search->n_trials = search->reason ? 0 : bracket_next(&search->bracket, search->trial);
  search->over = search->n_trials == 0;
  if (search->over && !search->reason) search->reason = why_open(&search->bracket);
  return request(search, runner, error);
}

Answer search_answer(const Search *search) {
  if (!search->begun) return (Answer){NAN, NAN, NAN, NAN, 0, search->reason ? search->reason : "not run"};
  const Bracket *bracket = &search->bracket;
  const double value = bracket_value(bracket);
  return (Answer){.value = value,
                  .low = bracket->no,
                  .high = bracket->yes,
                  .error = isnan(value) ? NAN : decimal_digits(0.5 * (bracket->yes - bracket->no), 2),
                  .runs = search->runs,
                  .note = search->reason};
}
