/* capsella study: many runs, one folder. */
#include "app/commands.h"
#include "app/help.h"
#include "app/interrupt.h"
#include "study/ranks.h"
#include "study/study_run.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SETS = 256, MOST = 4096 };

static int refuse(const char *what, const char *found) {
  return help_refuse("study", what, found);
}

static bool parse_count(const char *text, int *count) {
  char *end;
  const long value = strtol(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value < 1 || value > MOST) return false;
  *count = (int)value;
  return true;
}

/* "3/16". */
static bool parse_part(const char *text, int *part, int *parts) {
  char *slash;
  const long value = strtol(text, &slash, 10);
  if (*slash != '/' || !parse_count(slash + 1, parts) || value < 1 || value > *parts) return false;
  *part = (int)value;
  return true;
}

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, StudyOptions *options, bool *dry, const char **sets) {
  for (int i = 1; i < argc; i++) {
    const char *argument = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
    const bool is_jobs = strcmp(argument, "--jobs") == 0;
    if (strcmp(argument, "--resume") == 0) {
      options->runner.resume = true;
    } else if (strcmp(argument, "--dry-run") == 0) {
      *dry = true;
    } else if (strcmp(argument, "--quiet") == 0) {
      options->runner.quiet = true;
    } else if (strcmp(argument, "-o") == 0) {
      if (!value || !*value) return refuse("-o needs a folder", NULL);
      options->folder = argv[++i];
    } else if (strcmp(argument, "--set") == 0) {
      if (!value || !strchr(value, '=')) return refuse("--set needs KEY=VALUE", value);
      if (options->n_sets == MAX_SETS) return refuse("too many --set options", NULL);
      sets[options->n_sets++] = argv[++i];
    } else if (strcmp(argument, "--part") == 0) {
      if (!value || !parse_part(value, &options->part, &options->parts))
        return refuse("--part needs I/N, such as 3/16", value);
      i++;
    } else if (is_jobs || strcmp(argument, "--threads") == 0) {
      int *count = is_jobs ? &options->runner.jobs : &options->runner.threads;
      if (!value || !parse_count(value, count))
        return refuse(is_jobs ? "--jobs needs a number from 1 to 4096"
                              : "--threads needs a number from 1 to 4096",
                      value);
      i++;
    } else if (argument[0] == '-') {
      return refuse("expected an option of the usage below", argument);
    } else if (options->path) {
      return refuse("expected one study", argument);
    } else {
      options->path = argument;
    }
  }
  return options->path ? -1 : refuse("expected a study file", NULL);
}

/* Reading a study checks the scene and the laws of every combination. */
static int check_alone(const StudyOptions *options) {
  Study study;
  Error error;
  const Status status = study_open(options, &study, &error);
  if (status != STATUS_OK) {
    fprintf(stderr, "%s\n", error.text);
    return exit_code(status);
  }
  printf("%s: a %s over %zu combinations; nothing is wrong\n", options->path, study.kind->name,
         study.n_points);
  study_free(&study);
  return EXIT_DONE;
}

static void print_end(const char *folder, const StudyEnd *end) {
  if (end->found.data) fputs(end->found.data, stdout);
  printf("%s: %ld cases", end->interrupted ? "interrupted" : "done", end->count.cases);
  if (end->count.failed > 0) printf(", %ld failed", end->count.failed);
  if (end->count.taken_over > 0) printf(", %ld known from before", end->count.taken_over);
  printf("; results in %s\n", folder);
}

static Status lead(const StudyOptions *options, Error *error) {
  Text folder = {0};
  StudyEnd end;
  Status status = study_run(options, &folder, &end, error);
  if (status == STATUS_OK && !options->runner.quiet) print_end(folder.data, &end);
  if (status == STATUS_OK && end.count.cases > 0 && end.count.failed == end.count.cases)
    status = error_set(error, STATUS_FAILED, "all cases failed: see %s/table.csv", folder.data);
  text_free(&end.found);
  text_free(&folder);
  return status;
}

int command_study(int argc, char **argv) {
  const char *sets[MAX_SETS];
  StudyOptions options = {.sets = sets, .runner = {.progress = stderr, .interrupt = interrupt_flag()}};
  bool dry = false;
  const int parsed = parse(argc, argv, &options, &dry, sets);
  if (parsed >= 0) return parsed;
  if (dry) return check_alone(&options);
  interrupt_catch();
  Error error;
  Status status = ranks_open(&error);
  if (status == STATUS_OK)
    status = ranks_own() == 0 ? lead(&options, &error) : runner_serve(&options.runner, &error);
  if (status != STATUS_OK) fprintf(stderr, "%s\n", error.text);
  ranks_close();
  return exit_code(status);
}
