/* capsella laws check: the conformance suite on one plugin, as text, as TAP or as JSON. */
#include "app/commands.h"
#include "app/help.h"
#include "laws/conformance.h"
#include "laws/replay.h"
#include "observe/countdown.h"
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

/* A directive of TAP begins with #. */
static void put_escaped(const char *text) {
  for (const char *c = text; *c; c++) {
    if (*c == '#' || *c == '\\') putchar('\\');
    putchar(*c == '\n' ? ' ' : *c);
  }
}

/* The Test Anything Protocol, version 14: what a harness such as prove reads. */
static void print_tap(const ConformanceReport *report) {
  printf("TAP version 14\n1..%zu\n", report->n);
  for (size_t i = 0; i < report->n; i++) {
    const ConformanceResult *result = &report->result[i];
    const bool is_skipped = result->outcome == CONFORMANCE_SKIPPED;
    printf("%sok %zu - %s/%s", conformance_is_bad(result->outcome) ? "not " : "", i + 1, result->group,
           result->name);
    if (result->law[0]) printf(" %s", result->law);
    if (result->text[0] || is_skipped) fputs(is_skipped ? " # SKIP " : ": ", stdout);
    put_escaped(result->text);
    putchar('\n');
  }
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

typedef enum { AS_TEXT, AS_TAP, AS_JSON } Format;

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, ConformanceOptions *options, Format *format) {
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--json") == 0) {
      *format = AS_JSON;
    } else if (strcmp(argv[i], "--tap") == 0) {
      *format = AS_TAP;
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

static void show_progress(void *countdown, size_t done, size_t total, const char *test) {
  countdown_show(countdown, (double)done, (double)total, test);
}

static Status print_report(Format format, const char *file, const ConformanceReport *report, Error *error) {
  if (format == AS_JSON) return print_json(file, report, error);
  if (format == AS_TAP)
    print_tap(report);
  else
    print_text(file, report);
  return STATUS_OK;
}

int command_laws_check(int argc, char **argv) {
  Countdown countdown;
  ConformanceOptions options = {
      .time_limit = CONFORMANCE_TIME_LIMIT, .progress = show_progress, .context = &countdown};
  ConformanceReport report;
  Error error;
  Format format = AS_TEXT;
  if (argc == 3 && strcmp(argv[1], "--replay") == 0) return replay(argv[2]);
  const int code = parse(argc, argv, &options, &format);
  if (code >= 0) return code;
  countdown_start(&countdown, stderr);
  Status status = conformance_run(&options, &report, &error);
  countdown_clear(&countdown);
  if (status != STATUS_OK) return fail(&error);
  status = print_report(format, options.file, &report, &error);
  const bool bad = report.n_bad > 0;
  conformance_free(&report);
  if (status != STATUS_OK) return fail(&error);
  return bad ? EXIT_FAILED : EXIT_DONE;
}
