/* capsella laws check: the conformance suite on one plugin, as text or as JSON. */
#include "app/commands.h"
#include "app/help.h"
#include "laws/conformance.h"
#include "laws/replay.h"
#include "observe/json.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_text(const char *file, const ConformanceReport *report) {
  for (size_t i = 0; i < report->n; i++) {
    const ConformanceResult *result = &report->result[i];
    char name[96];
    snprintf(name, sizeof name, "%s/%s", result->group, result->name);
    printf("%-9s %-38s %s%s%s\n", conformance_outcome_name(result->outcome), name, result->law,
           result->text[0] ? ": " : "", result->text);
  }
  size_t count[CONFORMANCE_TIMED_OUT + 1] = {0};
  for (size_t i = 0; i < report->n; i++) count[report->result[i].outcome]++;
  printf("%s: %zu passed, %zu skipped, %zu failed\n", file, count[CONFORMANCE_PASSED],
         count[CONFORMANCE_SKIPPED], report->n_bad);
}

static Status print_json(const char *file, const ConformanceReport *report, Error *error) {
  Status status;
  Json json;
  Text text = {0};
  json_begin(&json, &text, error);
  json_open_object(&json, NULL);
  json_string(&json, "file", file);
  json_open_array(&json, "results");
  for (size_t i = 0; i < report->n; i++) {
    const ConformanceResult *result = &report->result[i];
    json_open_object(&json, NULL);
    json_string(&json, "group", result->group);
    json_string(&json, "test", result->name);
    json_string(&json, "about", result->about);
    json_string(&json, "law", result->law[0] ? result->law : NULL);
    json_string(&json, "outcome", conformance_outcome_name(result->outcome));
    json_string(&json, "text", result->text);
    json_close(&json);
  }
  json_close(&json);
  json_integer(&json, "tests", (long long)report->n);
  json_integer(&json, "failed", (long long)report->n_bad);
  json_close(&json);
  TRY(json_end(&json));
  fputs(text.data, stdout);
cleanup:
  text_free(&text);
  return status;
}

static int fail(const Error *error) {
  fprintf(stderr, "capsella laws check: %s\n", error->text);
  return exit_code(error->code);
}

/* Exit code 1: the law still fails. */
static int replay(const char *file) {
  Text report = {0};
  Error error;
  bool is_bad = false;
  const Status status = law_replay(file, &report, &is_bad, &error);
  if (status == STATUS_OK) fputs(report.data, stdout);
  text_free(&report);
  if (status != STATUS_OK) return fail(&error);
  return is_bad ? EXIT_FAILED : EXIT_DONE;
}

static bool parse_seconds(const char *text, double *seconds) {
  char *end;
  *seconds = strtod(text, &end);
  return end != text && *end == '\0' && *seconds > 0.0 && *seconds <= 86400.0;
}

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, ConformanceOptions *options, bool *json) {
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--json") == 0) {
      *json = true;
    } else if (strcmp(argv[i], "--in-process") == 0) {
      options->in_process = true;
    } else if (strcmp(argv[i], "--only") == 0) {
      if (++i == argc) return help_refuse("laws check", "expected a regular expression after --only", NULL);
      options->only = argv[i];
    } else if (strcmp(argv[i], "--time-limit") == 0) {
      if (++i == argc)
        return help_refuse("laws check", "expected a number of seconds after --time-limit", NULL);
      if (!parse_seconds(argv[i], &options->time_limit))
        return help_refuse("laws check", "expected a number of seconds after --time-limit", argv[i]);
    } else if (argv[i][0] == '-' || options->file) {
      return help_refuse("laws check", "expected one file and options", argv[i]);
    } else {
      options->file = argv[i];
    }
  }
  return options->file ? -1 : help_refuse("laws check", "expected a file, found none", NULL);
}

int command_laws_check(int argc, char **argv) {
  ConformanceOptions options = {.time_limit = CONFORMANCE_TIME_LIMIT};
  ConformanceReport report;
  Error error;
  bool json = false;
  if (argc == 3 && strcmp(argv[1], "--replay") == 0) return replay(argv[2]);
  const int code = parse(argc, argv, &options, &json);
  if (code >= 0) return code;
  Status status = conformance_run(&options, &report, &error);
  if (status != STATUS_OK) return fail(&error);
  if (json) {
    status = print_json(options.file, &report, &error);
  } else {
    print_text(options.file, &report);
  }
  const bool bad = report.n_bad > 0;
  conformance_free(&report);
  if (status != STATUS_OK) return fail(&error);
  return bad ? EXIT_FAILED : EXIT_DONE;
}
