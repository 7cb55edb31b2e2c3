#include "study/question.h"

#include "base/array.h"
#include "study/entry.h"
#include <string.h>

const char *const MODES[] = {"passive", "coupled", NULL};

void question_free(Question *question) {
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

/* Limits are capillary numbers, which the study then leaves to the search. */
static Status read_plan(const Study *study, Question *question, Error *error) {
  Status status = STATUS_OK;
  const YamlNode *find = yaml_tree_find(study->root, "find");
  if (!find && !yaml_tree_find(study->root, "bracket") && !yaml_tree_find(study->root, "tolerance"))
    return STATUS_OK;
  TRY(plan_read(study, &question->plan, error));
  for (size_t t = 0; t < question->plan.n_targets; t++) {
    if (find->items[t]->kind != YAML_TREE_TEXT)
      TRY(place_error(&find->items[t]->place, error,
                      "expected `Ca_c` or `Ca_l` in `find` of a comparison, found %s",
                      yaml_tree_found(find->items[t]).text));
    for (size_t a = 0; a < study->n_axes; a++)
      if (strcmp(study->axes[a].key, question->plan.target[t].key) == 0)
        TRY(place_error(&find->items[t]->place, error,
                        "expected `vary` to leave the capillary number to `find`, found it there"));
  }
cleanup:
  return status;
}

Status question_read(const Study *study, Question *question, Error *error) {
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
  TRY(read_plan(study, question, error));
  for (size_t i = 0; question->mode == MODE_COUPLED && i < question->n; i++) question->acts[i] = true;
  TRY(check_strengths(question, calibrate_node, error));
cleanup:
  if (status != STATUS_OK) question_free(question);
  return status;
}
