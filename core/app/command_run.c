/* capsella run: one scene, one folder of results. */
#include "app/commands.h"
#include "app/interrupt.h"
#include "run/run.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char USAGE[] =
    "usage: capsella run SCENE.yaml [-o DIR] [--set KEY=VALUE]... [--resume] [--threads N] [--quiet]\n";

static const char HELP[] =
    "\n"
    "  -o DIR            where results go (default: results/NAME, NAME from the scene)\n"
    "  --set KEY=VALUE   replace a value of the scene, as in --set flow.capillary_number=0.8\n"
    "  --resume          go on from the newest snapshot in DIR\n"
    "  --threads N       number of threads (default: all cores); results do not depend on it\n"
    "  --quiet           no progress\n"
    "\n"
    "Ctrl-C stops after the current step and leaves a snapshot to resume from.\n"
    "Exit code: 0 done (end, steady or rupture), 1 the computation failed, 2 the input is wrong.\n";

enum { MAX_SETS = 256 };

static int refuse(const char *what, const char *found) {
  fprintf(stderr, "capsella run: %s%s%s\n%s", what, found ? ", found " : "", found ? found : "", USAGE);
  return EXIT_INPUT;
}

static bool parse_threads(const char *text, int *threads) {
  char *end;
  const long value = strtol(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value < 1 || value > 4096) return false;
  *threads = (int)value;
  return true;
}

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, RunOptions *options, const char **sets) {
  for (int i = 1; i < argc; i++) {
    const char *argument = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
    if (strcmp(argument, "--help") == 0 || strcmp(argument, "-h") == 0) {
      fputs(USAGE, stdout);
      fputs(HELP, stdout);
      return EXIT_DONE;
    } else if (strcmp(argument, "--resume") == 0) {
      options->resume = true;
    } else if (strcmp(argument, "--quiet") == 0) {
      options->quiet = true;
    } else if (strcmp(argument, "-o") == 0) {
      if (!value || !*value) return refuse("-o needs a folder", NULL);
      options->folder = argv[++i];
    } else if (strcmp(argument, "--set") == 0) {
      if (!value) return refuse("--set needs KEY=VALUE", NULL);
      if (options->n_sets == MAX_SETS) return refuse("too many --set options", NULL);
      sets[options->n_sets++] = argv[++i];
    } else if (strcmp(argument, "--threads") == 0) {
      if (!value) return refuse("--threads needs a number", NULL);
      if (!parse_threads(argv[++i], &options->threads))
        return refuse("--threads needs a number from 1 to 4096", value);
    } else if (argument[0] == '-') {
      return refuse("expected an option of the list below", argument);
    } else if (options->scene_path) {
      return refuse("expected one scene", argument);
    } else {
      options->scene_path = argument;
    }
  }
  return options->scene_path ? -1 : refuse("expected a scene file", NULL);
}

int command_run(int argc, char **argv) {
  const char *sets[MAX_SETS];
  RunOptions options = {.sets = sets, .progress = stderr, .interrupt = interrupt_flag()};
  const int parsed = parse(argc, argv, &options, sets);
  if (parsed >= 0) return parsed;
  interrupt_catch();
  Error error;
  Text folder = {0};
  Outcome outcome;
  const Status status = run_scene(&options, &outcome, &folder, &error);
  if (status != STATUS_OK)
    fprintf(stderr, "%s\n", error.text);
  else if (!options.quiet)
    printf("%s; results in %s\n", outcome_name(outcome), folder.data);
  text_free(&folder);
  return exit_code(status);
}
