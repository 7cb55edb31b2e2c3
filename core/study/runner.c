/* One list of cases in the order of their requests, one journal, one launcher. */
#include "study/runner.h"

#include "base/array.h"
#include "base/file.h"
#include "base/timer.h"
#include "config/yaml_print.h"
#include "study/journal.h"
#include "study/label.h"
#include "study/launcher.h"
#include "study/ranks.h"
#include "study/study_progress.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct Runner {
  RunnerOptions options;
  const char *folder;
  bool keep_states;
  Text scene_path, plugin_path;
  uint64_t scene_hash;
  Journal journal;
  Launcher *launcher;
  int *in_slot; /* [slots] number of the case; -1: free */
  Case **cases; /* [n] */
  size_t n, capacity;
  size_t next; /* no case before it is waiting */
  long shared, taken_over;
  int running;
  StudyProgress progress;
};

/* ---- cases ---- */

const Case *runner_case(const Runner *runner, int number) {
  return runner->cases[number];
}

/* ---- requests ---- */

static Status conclude(Runner *runner, Case *item, CaseState state, const char *reason, Error *error) {
  Status status = STATUS_OK;
  item->state = state;
  if (reason && !(item->reason = text_copy(reason, error))) TRY(error->code);
  study_progress_ended(&runner->progress,
                       &(ProgressCase){item->label, case_status(item), item->reason, item->seconds});
cleanup:
  return status;
}

static Status finish_done(Runner *runner, Case *item, Error *error) {
  Status status = STATUS_OK;
  if (!runner->keep_states) TRY(case_remove_snapshots(item, error));
  TRY(journal_add(&runner->journal, JOURNAL_DONE, item->label, item->identity, NULL, error));
  TRY(conclude(runner, item, CASE_DONE, NULL, error));
cleanup:
  return status;
}

/* A process that an earlier study has left alone holds its lock until it has stopped. */
static Status await_orphan(const Case *item, Error *error) {
  Text path = {0};
  Status status = file_join(&path, item->folder, ".lock", error);
  if (status == STATUS_OK) launcher_await_lock(path.data);
  text_free(&path);
  return status;
}

/* What the folder knows of a case from an earlier process. */
static Status take_over(Runner *runner, Case *item, Error *error) {
  Status status = STATUS_OK;
  const JournalEntry *entry = journal_find(&runner->journal, item->label);
  if (entry && entry->state == JOURNAL_STARTED) TRY(await_orphan(item, error));
  if (!entry || entry->identity != item->identity) return case_clear(item, error);
  TRY(case_read_summary(item, error));
  if (entry->state == JOURNAL_FAILED) {
    runner->taken_over++;
    TRY(conclude(runner, item, CASE_FAILED, entry->reason, error));
  } else if (case_has_result(item)) {
    runner->taken_over++;
    TRY(entry->state == JOURNAL_STARTED ? finish_done(runner, item, error)
                                        : conclude(runner, item, CASE_DONE, NULL, error));
  } else if (entry->state == JOURNAL_STARTED) {
    item->has_begun = true;
  } else {
    TRY(case_clear(item, error));
  }
cleanup:
  return status;
}

static Status grow(Runner *runner, Error *error) {
  if (runner->n < runner->capacity) return STATUS_OK;
  const size_t capacity = runner->capacity ? 2 * runner->capacity : 64;
  Case **cases;
  const Status status = ARRAY_NEW(&cases, capacity, error);
  if (status != STATUS_OK) return status;
  if (runner->n) memcpy(cases, runner->cases, runner->n * sizeof *cases);
  array_free(runner->cases);
  runner->cases = cases;
  runner->capacity = capacity;
  return STATUS_OK;
}

Status runner_request(Runner *runner, const char *label, const Override *settings, size_t n, int *number,
                      Error *error) {
  Status status = STATUS_OK;
  Case *item = NULL;
  TRY(case_new(&item, runner->folder, runner->scene_hash, label, settings, n, error));
  for (size_t i = 0; i < runner->n; i++) {
    if (strcmp(runner->cases[i]->label, label) != 0) continue;
    if (runner->cases[i]->identity != item->identity)
      TRY(error_set(error, STATUS_FAILED, "two cases of the study are called %s", label));
    runner->shared++;
    *number = (int)i;
    goto cleanup;
  }
  TRY(grow(runner, error));
  TRY(take_over(runner, item, error));
  *number = (int)runner->n;
  runner->cases[runner->n++] = item;
  runner_expect(runner, (long)runner->n);
  return STATUS_OK;
cleanup:
  case_free(item);
  return status;
}

void runner_expect(Runner *runner, long cases) {
  if (cases > runner->progress.expected) runner->progress.expected = cases;
}

/* ---- processes ---- */

enum { FIXED_ARGUMENTS = 8 };

static Status start(Runner *runner, int slot, int number, Error *error) {
  Status status = STATUS_OK;
  Case *item = runner->cases[number];
  char threads[16];
  char program[] = "capsella", run[] = "run", quiet[] = "--quiet", folder[] = "-o", set[] = "--set",
       thread_option[] = "--threads", resume[] = "--resume";
  char **arguments = NULL;
  Text lock = {0}, messages = {0};
  size_t n = 0;
  snprintf(threads, sizeof threads, "%d", runner->options.threads);
  TRY(file_join(&lock, item->folder, ".lock", error));
  TRY(file_join(&messages, item->folder, "messages.txt", error));
  TRY(ARRAY_NEW(&arguments, FIXED_ARGUMENTS + 2 + 2 * item->n_sets, error));
  arguments[n++] = program;
  arguments[n++] = run;
  arguments[n++] = runner->scene_path.data;
  arguments[n++] = quiet;
  arguments[n++] = thread_option;
  arguments[n++] = threads;
  arguments[n++] = folder;
  arguments[n++] = item->folder;
  if (item->has_begun) arguments[n++] = resume;
  for (size_t i = 0; i < item->n_sets; i++) {
    arguments[n++] = set;
    arguments[n++] = item->sets[i];
  }
  TRY(journal_add(&runner->journal, JOURNAL_STARTED, item->label, item->identity, NULL, error));
  TRY(launcher_start(runner->launcher, slot,
                     &(Job){arguments, lock.data, messages.data, runner->plugin_path.data}, error));
  item->state = CASE_RUNNING;
  item->started = timer_wall_seconds();
  runner->in_slot[slot] = number;
  runner->running++;
cleanup:
  array_free(arguments);
  text_free(&messages);
  text_free(&lock);
  return status;
}

static Status fill_slots(Runner *runner, Error *error) {
  Status status = STATUS_OK;
  for (int slot = 0; slot < launcher_slots(runner->launcher); slot++) {
    if (runner->in_slot[slot] >= 0) continue;
    while (runner->next < runner->n && runner->cases[runner->next]->state != CASE_WAITING) runner->next++;
    if (runner->next == runner->n) break;
    TRY(start(runner, slot, (int)runner->next, error));
  }
cleanup:
  return status;
}

/* What the process said, on one line; the file goes when there is nothing in it. */
static Status read_messages(const Case *item, Text *said, Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  enum { MOST = 1 << 16 };
  TRY(file_join(&path, item->folder, "messages.txt", error));
  TRY(file_read(path.data, MOST, said, error));
  while (said->length > 0 && said->data[said->length - 1] == '\n') said->data[--said->length] = '\0';
  for (char *c = said->data; *c; c++)
    if (*c == '\n') *c = ' ';
  if (said->length == 0) remove(path.data);
cleanup:
  text_free(&path);
  return status;
}

/* A case that failed by itself would fail again; one that was ended from outside would not, and is not noted.
 */
static Status finish_failed(Runner *runner, Case *item, JobEnd end, const char *said, Error *error) {
  Status status = STATUS_OK;
  Text reason = {0};
  if (end.signal)
    TRY(text_append(&reason, error, "ended by signal %d", end.signal));
  else if (end.code == 0)
    TRY(text_append(&reason, error, "interrupted"));
  else
    TRY(text_append(&reason, error, "%s", *said ? said : "no reason given"));
  if (end.code > 0)
    TRY(journal_add(&runner->journal, JOURNAL_FAILED, item->label, item->identity, reason.data, error));
  TRY(conclude(runner, item, CASE_FAILED, reason.data, error));
cleanup:
  text_free(&reason);
  return status;
}

static Status finish(Runner *runner, JobEnd end, Error *error) {
  Status status = STATUS_OK;
  Text said = {0};
  Case *item = runner->cases[runner->in_slot[end.slot]];
  runner->in_slot[end.slot] = -1;
  runner->running--;
  item->seconds = timer_wall_seconds() - item->started;
  TRY(case_read_summary(item, error));
  TRY(read_messages(item, &said, error));
  TRY(case_remove_file(item, ".lock", error));
  if (end.code == 0 && case_has_result(item)) {
    TRY(finish_done(runner, item, error));
  } else if (runner_interrupted(runner) && end.code <= 0) {
    item->state = CASE_WAITING;
    item->has_begun = true;
  } else {
    TRY(finish_failed(runner, item, end, said.data, error));
  }
cleanup:
  text_free(&said);
  return status;
}

bool runner_interrupted(const Runner *runner) {
  return runner->options.interrupt && *runner->options.interrupt;
}

Status runner_wait(Runner *runner, Error *error) {
  Status status = STATUS_OK;
  bool stopped = false, ended = false;
  while (!ended || runner_interrupted(runner)) {
    if (!runner_interrupted(runner)) TRY(fill_slots(runner, error));
    if (runner->running == 0) break;
    if (runner_interrupted(runner) && !stopped) {
      launcher_stop(runner->launcher);
      stopped = true;
    }
    study_progress_show(&runner->progress, runner->running);
    JobEnd end;
    TRY(launcher_poll(runner->launcher, &end, error));
    if (end.slot < 0) continue;
    TRY(finish(runner, end, error));
    ended = true;
  }
cleanup:
  return status;
}

static bool is_over(const Runner *runner) {
  for (size_t i = 0; i < runner->n; i++)
    if (!case_ended(runner->cases[i])) return false;
  return true;
}

Status runner_wait_all(Runner *runner, Error *error) {
  Status status = STATUS_OK;
  while (!is_over(runner) && !runner_interrupted(runner)) TRY(runner_wait(runner, error));
cleanup:
  return status;
}

RunnerCount runner_count(const Runner *runner) {
  RunnerCount count = {
      .shared = runner->shared, .taken_over = runner->taken_over, .jobs = launcher_slots(runner->launcher)};
  for (size_t i = 0; i < runner->n; i++) {
    count.cases++;
    count.failed += runner->cases[i]->state == CASE_FAILED;
    count.evaluations += fmax(0, case_number(runner->cases[i], "evaluations")); /* 0 for NAN */
  }
  return count;
}

/* ---- opening ---- */

/* The base scene as a file, for the processes; its laws are found beside the original. */
static Status write_scene(Runner *runner, const Study *study, Error *error) {
  Status status = STATUS_OK;
  Text yaml = {0}, laws = {0};
  const char *path = getenv("MLAW_PLUGIN_PATH");
  TRY(text_append(&yaml, error, "# The scene that the cases of the study %s are made from.\n", study->name));
  TRY(yaml_print_file(study->scene, &yaml, error));
  TRY(file_join(&runner->scene_path, runner->folder, "scene.yaml", error));
  TRY(file_write(runner->scene_path.data, yaml.data, yaml.length, error));
  runner->scene_hash = label_hash(label_hash(LABEL_HASH_START, CAPSELLA_VERSION "\n"), yaml.data);
  TRY(file_folder(&laws, study->scene_file, error));
  TRY(text_append(&runner->plugin_path, error, "%s%s%s", laws.data, path ? ":" : "", path ? path : ""));
cleanup:
  text_free(&laws);
  text_free(&yaml);
  return status;
}

/* A study that starts anew leaves nothing of an earlier one in the folder. */
static Status forget_earlier(Runner *runner, Error *error) {
  Status status = STATUS_OK;
  Text folder = {0};
  for (size_t i = 0; i < runner->journal.n; i++) {
    folder.length = 0;
    TRY(text_append(&folder, error, "%s/cases/%s", runner->folder, runner->journal.entries[i].label));
    TRY(case_erase(folder.data, error));
  }
  TRY(journal_empty(&runner->journal, error));
cleanup:
  text_free(&folder);
  return status;
}

/* Under MPI it is for mpirun to say how many ranks a machine bears. */
static int default_jobs(void) {
  if (ranks_count() > 1) return 1;
  const long processors = sysconf(_SC_NPROCESSORS_ONLN);
  return processors > 0 ? (int)processors : 1;
}

Status runner_new(Runner **made, const Study *study, const char *folder, const RunnerOptions *options,
                  Error *error) {
  Status status = STATUS_OK;
  Runner *runner = NULL;
  TRY(ARRAY_NEW(&runner, 1, error));
  runner->options = *options;
  runner->folder = folder;
  runner->keep_states = study->kind->keeps_states;
  runner->journal.handle = -1;
  if (runner->options.threads == 0) runner->options.threads = 1;
  const int own = options->jobs > 0 ? options->jobs : default_jobs();
  TRY(journal_open(&runner->journal, folder, error));
  if (!options->resume) TRY(forget_earlier(runner, error));
  TRY(write_scene(runner, study, error));
  TRY(launcher_new(&runner->launcher, own, options->program, error));
  const int slots = launcher_slots(runner->launcher);
  TRY(ARRAY_NEW(&runner->in_slot, slots, error));
  for (int slot = 0; slot < slots; slot++) runner->in_slot[slot] = -1;
  study_progress_start(&runner->progress, options->progress, options->quiet, slots);
cleanup:
  if (status != STATUS_OK) {
    runner_free(runner);
    runner = NULL;
  }
  *made = runner;
  return status;
}

Status runner_serve(const RunnerOptions *options, Error *error) {
  Launcher *launcher = NULL;
  Status status = launcher_new(&launcher, options->jobs > 0 ? options->jobs : 1, options->program, error);
  if (status == STATUS_OK) status = launcher_serve(launcher, options->interrupt, error);
  launcher_free(launcher);
  return status;
}

void runner_free(Runner *runner) {
  if (!runner) return;
  study_progress_clear(&runner->progress);
  launcher_free(runner->launcher);
  journal_close(&runner->journal);
  for (size_t i = 0; i < runner->n; i++) case_free(runner->cases[i]);
  array_free(runner->cases);
  array_free(runner->in_slot);
  text_free(&runner->scene_path);
  text_free(&runner->plugin_path);
  array_free(runner);
}
