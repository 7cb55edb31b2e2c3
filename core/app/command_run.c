/* capsella run: one scene, one folder of results. */
#include "app/commands.h"
#include "app/guard.h"
#include "app/help.h"
#include "app/interrupt.h"
#include "run/dry_run.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_SETS = 256 };

static int refuse(const char *what, const char *found) {
  return help_refuse("run", what, found);
}

static bool parse_count(const char *text, long least, int *count) {
  char *end;
  const long value = strtol(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value < least || value > 4096) return false;
  *count = (int)value;
  return true;
}

typedef struct {
  bool dry;
  int law_timeout; /* seconds; 0: wait */
} Manner;

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, RunOptions *options, const char **sets, Manner *manner) {
  for (int i = 1; i < argc; i++) {
    const char *argument = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
    if (strcmp(argument, "--resume") == 0) {
      options->resume = true;
    } else if (strcmp(argument, "--quiet") == 0) {
      options->quiet = true;
    } else if (strcmp(argument, "--dry-run") == 0) {
      manner->dry = true;
    } else if (strcmp(argument, "-o") == 0) {
      if (!value || !*value) return refuse("-o needs a folder", NULL);
      options->folder = argv[++i];
    } else if (strcmp(argument, "--set") == 0) {
      if (!value || !strchr(value, '=')) return refuse("--set needs KEY=VALUE", value);
      if (options->n_sets == MAX_SETS) return refuse("too many --set options", NULL);
      sets[options->n_sets++] = argv[++i];
    } else if (strcmp(argument, "--threads") == 0) {
      if (!value) return refuse("--threads needs a number", NULL);
      if (!parse_count(argv[++i], 1, &options->threads))
        return refuse("--threads needs a number from 1 to 4096", value);
    } else if (strcmp(argument, "--law-timeout") == 0) {
      if (!value || !parse_count(value, 0, &manner->law_timeout))
        return refuse("--law-timeout needs a number of seconds from 0 to 4096", value);
      i++;
    } else if (argument[0] == '-') {
      return refuse("expected an option of the usage below", argument);
    } else if (options->scene_path) {
      return refuse("expected one scene", argument);
    } else {
      options->scene_path = argument;
    }
  }
  return options->scene_path ? -1 : refuse("expected a scene file", NULL);
}

static Status check_alone(const RunOptions *options, Error *error) {
  Text report = {0};
  const Status status = run_dry(options, &report, error);
  if (status == STATUS_OK && !options->quiet) printf("%sNothing was written.\n", report.data);
  text_free(&report);
  return status;
}

static Status compute(const RunOptions *options, Error *error) {
  Text folder = {0};
  Outcome outcome;
  const Status status = run_scene(options, &outcome, &folder, error);
  if (status == STATUS_OK && !options->quiet)
    printf("%s; results in %s\n", outcome_name(outcome), folder.data);
  text_free(&folder);
  return status;
}

int command_run(int argc, char **argv) {
  const char *sets[MAX_SETS];
  Manner manner = {.law_timeout = 60};
  RunOptions options = {.sets = sets, .progress = stderr, .interrupt = interrupt_flag()};
  const int parsed = parse(argc, argv, &options, sets, &manner);
  if (parsed >= 0) return parsed;
  interrupt_catch();
  options.law_watch = guard_laws((unsigned)manner.law_timeout);
  Error error;
  const Status status = (manner.dry ? check_alone : compute)(&options, &error);
  if (status != STATUS_OK) fprintf(stderr, "%s\n", error.text);
  return exit_code(status);
}
