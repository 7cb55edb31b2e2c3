#include "run/output.h"

#include "base/array.h"
#include "base/file.h"
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- resolved.yaml ---- */

static Status describe_law(Text *text, const char *role, const LoadedLaw *law, Error *error) {
  const char *id = law->energy ? law->energy->id : law->damage->id;
  return text_append(text, error, "%s law: %s, plugin %s %s, file %s, fnv1a64 %016" PRIx64 "\n", role, id,
                     law->plugin->id, law->plugin->version, law->file, law->hash);
}

static Status print_resolved(Output *output, const Simulation *s, Error *error) {
  Status status = STATUS_OK;
  Text comments = {0};
  TRY(text_append(&comments, error,
                  "Written by capsella " CAPSELLA_VERSION ": the scene with every default.\n"));
  TRY(describe_law(&comments, "elastic", &s->material.elastic, error));
  if (material_has_damage(&s->material)) TRY(describe_law(&comments, "damage", &s->material.damage, error));
  for (size_t i = 0; i < s->n_criteria; i++)
    TRY(describe_law(&comments, "observing", &s->criterion[i].damage, error));
  TRY(scene_print(s->scene, comments.data, &output->resolved, error));
cleanup:
  text_free(&comments);
  return status;
}

static Status join(Text *path, const Output *output, const char *name, Error *error) {
  return file_join(path, output->folder, name, error);
}

static Status write_resolved(const Output *output, Error *error) {
  Text path = {0};
  Status status = STATUS_OK;
  TRY(join(&path, output, "resolved.yaml", error));
  TRY(file_write(path.data, output->resolved.data, output->resolved.length, error));
cleanup:
  text_free(&path);
  return status;
}

/* ---- opening ---- */

static HistoryKind history_kind(const Simulation *s) {
  return simulation_is_inflation(s) ? HISTORY_INFLATION : HISTORY_FLOW;
}

Status output_open(Output *output, const char *folder, const Simulation *s, Error *error) {
  Status status = STATUS_OK;
  *output = (Output){.folder = folder, .last_row_t = NAN, .last_snapshot_t = NAN};
  TRY(print_resolved(output, s, error));
  TRY(parameter_cells_new(&output->parameters, s, error));
  TRY(nodal_fields_new(&output->nodal, s, error));
cleanup:
  if (status != STATUS_OK) output_close(output);
  return status;
}

void output_close(Output *output) {
  Error ignored;
  history_close(&output->history, &ignored);
  series_free(&output->series);
  parameter_cells_free(&output->parameters);
  text_free(&output->resolved);
  nodal_fields_free(&output->nodal);
  *output = (Output){0};
}

static Status remove_old(const char *path, Error *error) {
  if (remove(path) == 0 || errno == ENOENT) return STATUS_OK;
  return error_set(error, STATUS_IO, "%s: the file of an earlier run cannot be removed: %s", path,
                   strerror(errno));
}

static Status remove_named(const Output *output, const char *name, Error *error) {
  Text path = {0};
  Status status = STATUS_OK;
  TRY(join(&path, output, name, error));
  TRY(remove_old(path.data, error));
cleanup:
  text_free(&path);
  return status;
}

/* Removes what an earlier run has left in the folder: it would pass for a result of this one. */
static Status clear_folder(const Output *output, Error *error) {
  static const char *const names[] = {"summary.json", "report.html", "series.xdmf",  "snapshots.hdf.series",
                                      "capsule.svg",  "curves.svg",  "criteria.csv", "law_failure.yaml"};
  Status status = STATUS_OK;
  int *numbers = NULL;
  size_t count;
  Text path = {0};
  TRY(snapshot_list(output->folder, &numbers, &count, error));
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) TRY(remove_named(output, names[i], error));
  for (size_t i = 0; i < count; i++) {
    text_free(&path);
    TRY(snapshot_path(&path, output->folder, numbers[i], error));
    TRY(remove_old(path.data, error));
  }
cleanup:
  text_free(&path);
  array_free(numbers);
  return status;
}

Status output_start(Output *output, const Simulation *s, Error *error) {
  Text path = {0};
  Status status = STATUS_OK;
  TRY(clear_folder(output, error));
  TRY(write_resolved(output, error));
  TRY(join(&path, output, "history.csv", error));
  TRY(history_open(&output->history, path.data, history_kind(s), error));
cleanup:
  text_free(&path);
  return status;
}

static double start_time(const Simulation *s) {
  return simulation_is_inflation(s) ? s->scene->flow.path[0][0] : 0;
}

/* A multiple of `every` that misses the end of the run by round-off is the end: no crumb of a step before it.
 */
static double due(const Simulation *s, long long next, double every) {
  if (!(every > 0)) return INFINITY;
  /* Decimal multiples are written as such: 0.3, not 3 * 0.1. */
  const double t = start_time(s) + rint((double)next * every * 1e12) / 1e12, end = s->scene->time.end;
  return fabs(t - end) <= 1e-9 * every ? end : t;
}

double output_next_sample(const Output *output, const Simulation *s) {
  return due(s, output->next_sample, s->scene->output.history_every);
}

double output_next_snapshot(const Output *output, const Simulation *s) {
  return due(s, output->next_snapshot, s->scene->output.snapshot_every);
}

/* Number of the first time that is due after t; `next` is a guess. */
static long long first_after(const Simulation *s, double t, long long next, double every) {
  if (!(every > 0)) return next;
  while (next > 0 && due(s, next - 1, every) > t) next--;
  while (due(s, next, every) <= t) next++;
  return next;
}

/* The scene may have other intervals, or a later end, than the one that the snapshot was written with. */
static void count_anew(Output *output, const Simulation *s) {
  const double t = s->motion->t;
  output->next_sample = first_after(s, t, output->next_sample, s->scene->output.history_every);
  output->next_snapshot = first_after(s, t, output->next_snapshot, s->scene->output.snapshot_every);
}

Status output_row(Output *output, const HistoryRow *row, Error *error) {
  output->last_row_t = row->t;
  return history_append(&output->history, row, error);
}

/* ---- snapshots ---- */

enum { MAX_RESTART_ITEMS = MOTION_RESTART_ITEMS + MLAW_N_CHANNELS + 15 };

/* One list serves writing and reading. */
static size_t restart_items(Output *output, Simulation *s, Record *record, RestartItem *items) {
  static const char *const channel_names[MLAW_N_CHANNELS] = {
      "channel_Y", "channel_I1", "channel_I2", "channel_l1", "channel_l2", "channel_T1", "channel_T2"};
  size_t n = s->motion->restart_items(s->motion, items);
  const size_t points = (size_t)membrane_points(s->membrane);
  const MembraneHistory *history = membrane_restored(s->membrane);
  if (history->d) {
    items[n++] = (RestartItem){.name = "Ymax", .count = points, .doubles = history->Ymax};
    items[n++] = (RestartItem){.name = "d", .count = points, .doubles = history->d};
  }
  if (history->elastic_state)
    items[n++] = (RestartItem){.name = "elastic_state",
                               .count = points * (size_t)material_elastic_vars(&s->material),
                               .doubles = history->elastic_state};
  if (history->damage_state)
    items[n++] = (RestartItem){.name = "damage_state",
                               .count = points * (size_t)material_damage_vars(&s->material),
                               .doubles = history->damage_state};
  if (history->Y) items[n++] = (RestartItem){.name = "Y", .count = points, .doubles = history->Y};
  for (int c = 0; c < MLAW_N_CHANNELS; c++)
    if (history->channel[c])
      items[n++] = (RestartItem){.name = channel_names[c], .count = points, .doubles = history->channel[c]};
  items[n++] = (RestartItem){
      .name = "record", .count = sizeof record->data / sizeof(double), .doubles = &record->data.t_c};
  const Criteria *criteria = &record->criteria;
  if (criteria->observers.n > 0) {
    items[n++] = (RestartItem){
        .name = "criteria", .count = criteria->observers.size, .doubles = criteria->observers.accepted};
    items[n++] = (RestartItem){.name = "findings",
                               .count = criteria->observers.n * sizeof(Finding) / sizeof(double),
                               .doubles = &criteria->finding->t_c};
  }
  items[n++] = (RestartItem){.name = "history_bytes", .count = 1, .integers = &output->history.bytes};
  items[n++] = (RestartItem){.name = "last_row_t", .count = 1, .doubles = &output->last_row_t};
  items[n++] = (RestartItem){.name = "next_sample", .count = 1, .integers = &output->next_sample};
  items[n++] = (RestartItem){.name = "next_snapshot", .count = 1, .integers = &output->next_snapshot};
  items[n++] = (RestartItem){.name = "snapshot_number", .count = 1, .integers = &output->snapshot_number};
  return n;
}

Status output_snapshot(Output *output, Simulation *s, Record *record, Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  RestartItem items[MAX_RESTART_ITEMS];
  const int number =
      (int)output->snapshot_number++; /* counted first: the file names the one that comes next */
  TRY(record_probe(record, s->motion->t, error));
  nodal_fields_measure(&output->nodal, s);
  TRY(history_sync(&output->history, error));
  const SnapshotField fields[] = {
      {.name = "q", .components = 3, .values = s->motion->q},
      {.name = "velocity", .components = 3, .values = record->v},
      {.name = "d", .components = 1, .values = output->nodal.d},
      {.name = "Y", .components = 1, .values = output->nodal.Y},
      {.name = "T1", .components = 1, .values = output->nodal.T1},
      {.name = "T2", .components = 1, .values = output->nodal.T2},
  };
  const Snapshot snapshot = {
      .mesh = &s->mesh,
      .t = s->motion->t,
      .x = record->x,
      .fields = fields,
      .n_fields = sizeof fields / sizeof *fields,
      .cells = output->parameters.cells,
      .n_cells = output->parameters.n,
      .restart = items,
      .n_restart = restart_items(output, s, record, items),
      .scene = output->resolved.data,
  };
  TRY(snapshot_path(&path, output->folder, number, error));
  TRY(snapshot_write(path.data, &snapshot, error));
  TRY(series_add(&output->series, output->folder, number, &snapshot, error));
  output->last_snapshot_t = snapshot.t;
cleanup:
  text_free(&path);
  return status;
}

/* ---- resume ---- */

static Status compare_scenes(const Output *output, const char *snapshot, Log *log, Error *error) {
  Text before = {0};
  Status status = STATUS_OK;
  TRY(snapshot_read_scene(snapshot, &before, NULL, error));
  if (strcmp(before.data, output->resolved.data) != 0)
    log_warning(log,
                "the scene or a law differs from the one that %s was written with; going on with the new one",
                snapshot);
cleanup:
  text_free(&before);
  return status;
}

/* `number` is -1 when there is no snapshot. */
Status output_restore(Output *output, Simulation *s, Record *record, Log *log, int *number, Error *error) {
  Status status = STATUS_OK;
  Text snapshot = {0};
  RestartItem items[MAX_RESTART_ITEMS];
  TRY(snapshot_find_newest(output->folder, &snapshot, number, log, error));
  if (*number < 0) goto cleanup;
  TRY(compare_scenes(output, snapshot.data, log, error));
  TRY(snapshot_read_restart(snapshot.data, items, restart_items(output, s, record, items), error));
cleanup:
  text_free(&snapshot);
  return status;
}

Status output_resume(Output *output, Simulation *s, Record *record, Log *log, bool *found, Error *error) {
  Status status = STATUS_OK;
  Text history = {0};
  int number;
  TRY(output_restore(output, s, record, log, &number, error));
  *found = number >= 0;
  if (!*found) goto cleanup;
  output->last_snapshot_t = s->motion->t;
  count_anew(output, s);
  TRY(remove_named(output, "summary.json", error)); /* of how the earlier part ended */
  TRY(remove_named(output, "report.html", error));
  TRY(write_resolved(output, error));
  TRY(join(&history, output, "history.csv", error));
  TRY(history_resume(&output->history, history.data, history_kind(s), output->history.bytes, error));
  TRY(series_restore(&output->series, output->folder, number, log, error));
cleanup:
  text_free(&history);
  return status;
}
