#include "laws/replay.h"

#include "base/array.h"
#include "base/file.h"
#include "config/yaml_tree.h"
#include "laws/conformance_kernel.h"
#include "laws/loader.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

typedef struct {
  char *law, *message;
  char *plugin;
  uint64_t hash;
  double t, dt;
  ptrdiff_t n;
  double *param, *in; /* [n_params][n], [n_rows][n] */
  size_t n_params, n_rows;
} Batch;

static void batch_free(Batch *batch) {
  array_free(batch->law);
  array_free(batch->message);
  array_free(batch->plugin);
  array_free(batch->param);
  array_free(batch->in);
}

static const YamlNode *entry(const YamlNode *root, const char *key, YamlKind kind, Error *error) {
  const YamlNode *node = yaml_tree_find(root, key);
  if (node && node->kind == kind) return node;
  place_error(node ? &node->place : &root->place, error, "expected %s under `%s`, found %s",
              kind == YAML_TREE_LIST ? "a list" : "a text", key, node ? yaml_tree_found(node).text : "none");
  return NULL;
}

static Status read_text(const YamlNode *root, const char *key, char **text, Error *error) {
  const YamlNode *node = entry(root, key, YAML_TREE_TEXT, error);
  if (!node) return error->code;
  *text = text_copy(node->text, error);
  return *text ? STATUS_OK : error->code;
}

/* Any double, also one that is not finite. */
static Status read_number(const YamlNode *node, double *value, Error *error) {
  char *end = NULL;
  if (node->kind == YAML_TREE_TEXT) *value = strtod(node->text, &end);
  if (end && end != node->text && !*end) return STATUS_OK;
  return place_error(&node->place, error, "expected a number, found %s", yaml_tree_found(node).text);
}

static Status read_numbers(const YamlNode *node, size_t count, double *values, Error *error) {
  if (node->kind != YAML_TREE_LIST || node->count != count)
    return place_error(&node->place, error, "expected a list of %zu numbers, found %s", count,
                       yaml_tree_found(node).text);
  Status status = STATUS_OK;
  for (size_t i = 0; i < count && status == STATUS_OK; i++)
    status = read_number(node->items[i], &values[i], error);
  return status;
}

static Status read_rows(const YamlNode *node, size_t n, double **values, size_t *rows, Error *error) {
  Status status;
  *rows = node->count;
  TRY(ARRAY_NEW(values, node->count * n, error));
  for (size_t row = 0; row < node->count; row++)
    TRY(read_numbers(node->items[row], n, *values + row * n, error));
cleanup:
  return status;
}

static Status read_tree(const YamlNode *root, Batch *batch, Error *error) {
  Status status;
  double time[2];
  char *hash = NULL;
  const YamlNode *parameters = NULL, *inputs = NULL, *times = NULL;
  TRY(read_text(root, "law", &batch->law, error));
  TRY(read_text(root, "file", &batch->plugin, error));
  TRY(read_text(root, "message", &batch->message, error));
  TRY(read_text(root, "hash", &hash, error));
  batch->hash = strtoull(hash, NULL, 16);
  if (!(times = entry(root, "time", YAML_TREE_LIST, error)) ||
      !(parameters = entry(root, "parameters", YAML_TREE_LIST, error)) ||
      !(inputs = entry(root, "inputs", YAML_TREE_LIST, error)))
    TRY(error->code);
  TRY(read_numbers(times, 2, time, error));
  batch->t = time[0];
  batch->dt = time[1];
  const size_t n = inputs->count ? inputs->items[0]->count : 0;
  if (n == 0 || n > MAX_LD)
    TRY(place_error(&inputs->place, error, "expected rows of 1 to %d points under `inputs`, found %zu",
                    MAX_LD, n));
  batch->n = (ptrdiff_t)n;
  TRY(read_rows(parameters, n, &batch->param, &batch->n_params, error));
  TRY(read_rows(inputs, n, &batch->in, &batch->n_rows, error));
cleanup:
  array_free(hash);
  return status;
}

static Status read_batch(const char *file, Batch *batch, Error *error) {
  Status status;
  Text text = {0};
  YamlNode *root = NULL;
  status = file_read(file, YAML_TREE_BYTES, &text, error);
  if (status == STATUS_IO) status = error->code = STATUS_INPUT; /* a wrong path is wrong input */
  TRY(status);
  TRY(yaml_tree_parse(&root, file, true, text.data, text.length, error));
  if (root->kind != YAML_TREE_MAPPING || !yaml_tree_find(root, "law_failure"))
    TRY(error_set(error, STATUS_INPUT, "%s: expected the file of a law that failed, found another", file));
  TRY(read_tree(root, batch, error));
cleanup:
  yaml_tree_free(root);
  text_free(&text);
  return status;
}

/* ---- Evaluating ---- */

/* A value that no law computes: marks what was not written. */
static const uint64_t MARK = UINT64_C(0x7ff8dead0000beef);

static bool is_mark(double value) {
  uint64_t pattern;
  memcpy(&pattern, &value, sizeof pattern);
  return pattern == MARK;
}

typedef struct {
  const Subject *subject;
  const Batch *batch;
  Text *report;
  size_t faults;
} Replay;

/* Points first .. first + n - 1 as a batch of their own; out [kernel_outputs][n]. */
static int evaluate(const Replay *replay, ptrdiff_t first, ptrdiff_t n, double *out, mlaw_error *err) {
  const Batch *batch = replay->batch;
  mlaw_field field[MAX_PARAMS];
  double in[TABLE];
  for (size_t k = 0; k < batch->n_params; k++)
    field[k] = (mlaw_field){batch->param + (ptrdiff_t)k * batch->n + first, 1};
  for (size_t row = 0; row < batch->n_rows; row++)
    memcpy(in + (ptrdiff_t)row * n, batch->in + (ptrdiff_t)row * batch->n + first, (size_t)n * sizeof *in);
  for (ptrdiff_t i = 0; i < kernel_outputs(replay->subject) * n; i++) memcpy(&out[i], &MARK, sizeof MARK);
  KernelCall call = {
      .n = n, .ld = n, .param = field, .in = in, .out = out, .without = -1, .t = batch->t, .dt = batch->dt};
  const int status = kernel_call(replay->subject, &call);
  *err = call.err;
  err->text[sizeof err->text - 1] = '\0';
  return status;
}

/* A line of the report; the first twenty tell enough. */
static Status note(Replay *replay, Error *error, const char *where, ptrdiff_t point, const char *what,
                   double value) {
  enum { LONGEST = 20 };
  if (++replay->faults > LONGEST) return STATUS_OK;
  Status status;
  const Batch *batch = replay->batch;
  TRY(text_append(replay->report, error, "%s, point %td: %s", where, point, what));
  if (!isnan(value) || strstr(what, "not finite")) TRY(text_append(replay->report, error, " (%.17g)", value));
  TRY(text_append(replay->report, error, "\n  inputs"));
  for (size_t row = 0; row < batch->n_rows; row++)
    TRY(text_append(replay->report, error, " %.17g", batch->in[(ptrdiff_t)row * batch->n + point]));
  TRY(text_append(replay->report, error, "\n"));
cleanup:
  return status;
}

static Status judge_value(Replay *replay, const char *where, ptrdiff_t point, int row, double value,
                          Error *error) {
  Text what = {0};
  Status status = STATUS_OK;
  const char *name = kernel_output_name(replay->subject, row);
  if (is_mark(value)) {
    TRY(text_append(&what, error, "%s is not written", name));
    TRY(note(replay, error, where, point, what.data, NAN));
  } else if (!isfinite(value)) {
    TRY(text_append(&what, error, "%s is not finite", name));
    TRY(note(replay, error, where, point, what.data, value));
  }
cleanup:
  text_free(&what);
  return status;
}

/* Damage that a general law takes back, beyond rounding. */
static Status judge_healing(Replay *replay, const char *where, ptrdiff_t point, double d1, Error *error) {
  const Subject *subject = replay->subject;
  if (!subject->damage || !subject->damage->update) return STATUS_OK;
  const ptrdiff_t row = kernel_inputs(subject) - 1 - (ptrdiff_t)subject->table.n_vars;
  const double d0 = replay->batch->in[row * replay->batch->n + point];
  if (!(d1 < d0 - 1e-12)) return STATUS_OK;
  return note(replay, error, where, point, "damage falls", d1);
}

/* The answer [kernel_outputs][n] to points first .. first + n - 1. */
static Status judge(Replay *replay, const char *where, ptrdiff_t first, ptrdiff_t n, int code,
                    const mlaw_error *err, const double *out, Error *error) {
  Status status = STATUS_OK;
  if (code != MLAW_OK) {
    const bool known = err->point >= 0 && err->point < n;
    Text what = {0};
    status = text_append(&what, error, "the law refuses with status %d: %s", code,
                         err->text[0] ? err->text : "no reason given");
    if (status == STATUS_OK)
      status = note(replay, error, where, first + (known ? (ptrdiff_t)err->point : 0), what.data, NAN);
    text_free(&what);
    return status;
  }
  for (ptrdiff_t i = 0; i < n; i++) {
    for (int row = 0; row < kernel_outputs(replay->subject); row++)
      TRY(judge_value(replay, where, first + i, row, out[row * n + i], error));
    TRY(judge_healing(replay, where, first + i, out[i], error));
  }
cleanup:
  return status;
}

/* Equal up to what vector and scalar instructions may do to the last digits. */
static bool differs(double a, double b) {
  return isfinite(a) && isfinite(b) && fabs(a - b) > 1e-12 * (1 + fabs(b));
}

static Status evaluate_all(Replay *replay, Error *error) {
  Status status;
  const ptrdiff_t n = replay->batch->n;
  const int rows = kernel_outputs(replay->subject);
  double whole[TABLE], alone[MAX_ROWS];
  mlaw_error err;
  const int code = evaluate(replay, 0, n, whole, &err);
  TRY(judge(replay, "batch", 0, n, code, &err, whole, error));
  for (ptrdiff_t i = 0; i < n; i++) {
    const int code_alone = evaluate(replay, i, 1, alone, &err);
    TRY(judge(replay, "alone", i, 1, code_alone, &err, alone, error));
    for (int row = 0; code == MLAW_OK && code_alone == MLAW_OK && row < rows; row++)
      if (differs(whole[row * n + i], alone[row]))
        TRY(note(replay, error, "alone", i, "the answer differs from that in the batch", alone[row]));
  }
cleanup:
  return status;
}

/* ---- The report ---- */

static Status check_shape(const Batch *batch, const Subject *subject, Error *error) {
  if (batch->n_params == subject->table.n_params && (int)batch->n_rows == kernel_inputs(subject) &&
      batch->n_params <= MAX_PARAMS && batch->n_rows <= MAX_ROWS && kernel_outputs(subject) <= MAX_ROWS)
    return STATUS_OK;
  return error_set(
      error, STATUS_INPUT,
      "expected a law with %zu parameters and %zu inputs, found %u and %d in %s: its tables have "
      "changed since",
      batch->n_params, batch->n_rows, subject->table.n_params, kernel_inputs(subject), batch->plugin);
}

static Status load(const Batch *batch, LoadedLaw *law, Subject *subject, Error *error) {
  Status status;
  Text request = {0};
  const LawSearch nowhere = {0};
  TRY(text_append(&request, error, "%s#%s", batch->plugin, batch->law));
  TRY(law_load(law, LAW_ANY, request.data, &nowhere, error));
  *subject = (Subject){.file = law->file,
                       .plugin = law->plugin,
                       .energy = law->energy,
                       .damage = law->damage,
                       .table = law_describe(law)};
  TRY(check_shape(batch, subject, error));
cleanup:
  text_free(&request);
  return status;
}

static Status print_head(const Batch *batch, const LoadedLaw *law, Text *report, Error *error) {
  Status status;
  TRY(text_append(report, error, "law %s of %s, %td points from t = %g to %g\nthe run said: %s\n", batch->law,
                  law->file, batch->n, batch->t, batch->t + batch->dt, batch->message));
  if (law->hash != batch->hash)
    TRY(text_append(report, error,
                    "the plugin has changed since: hash %016" PRIx64 " then, %016" PRIx64 " now\n",
                    batch->hash, law->hash));
cleanup:
  return status;
}

Status law_replay(const char *file, Text *report, bool *is_bad, Error *error) {
  Status status;
  Batch batch = {0};
  LoadedLaw law = {0};
  Subject subject;
  Replay replay = {.subject = &subject, .batch = &batch, .report = report};
  TRY(read_batch(file, &batch, error));
  TRY(load(&batch, &law, &subject, error));
  TRY(print_head(&batch, &law, report, error));
  TRY(evaluate_all(&replay, error));
  *is_bad = replay.faults > 0;
  if (*is_bad)
    TRY(text_append(report, error, "%zu faults\n", replay.faults));
  else
    TRY(text_append(report, error, "the law answers every point, in the batch and alone\n"));
cleanup:
  law_release(&law);
  batch_free(&batch);
  return status;
}
