/* Runs conformance tests, each in a forked child that answers through a pipe.  What is tested stands in the
 * files of the groups. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "laws/conformance.h"

#include "base/array.h"
#include "base/file.h"
#include "base/text.h"
#include "base/timer.h"
#include "laws/conformance_test.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <regex.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const ConformanceGroup *const groups[] = {&conformance_load, &conformance_description,
                                                 &conformance_contract, &conformance_energy,
                                                 &conformance_damage};
enum { N_GROUPS = sizeof groups / sizeof *groups };

const char *conformance_outcome_name(ConformanceOutcome outcome) {
  static const char *const names[] = {"passed", "skipped", "failed", "crashed", "timed out"};
  return names[outcome];
}

bool conformance_is_bad(ConformanceOutcome outcome) {
  return outcome >= CONFORMANCE_FAILED;
}

Verdict verdict(ConformanceOutcome outcome, const char *format, ...) {
  Verdict result = {.outcome = outcome};
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(result.text, sizeof result.text, format, arguments);
  va_end(arguments);
  return result;
}

Verdict verdict_passed(void) {
  return (Verdict){.outcome = CONFORMANCE_PASSED};
}

/* ---- In the child ---- */

/* Law k of a plugin: energy laws first. */
typedef struct {
  const ConformanceTest *test;
  uint32_t law;
} Task;

/* The law's id goes through the pipe before the test runs, so that a test that never ends is known by it. */
typedef struct {
  char law[64];
  Verdict verdict;
  uint32_t n_laws;
} Answer;

static bool is_of_law(const ConformanceTest *test) {
  return test->scope != FOR_FILE && test->scope != FOR_PLUGIN;
}

static Subject choose_law(const char *file, const mlaw_plugin *plugin, uint32_t k) {
  Subject subject = {.file = file, .plugin = plugin};
  if (k < plugin->n_energy) {
    subject.energy = plugin->energy[k];
    subject.table = law_describe_energy(subject.energy);
  } else {
    subject.damage = plugin->damage[k - plugin->n_energy];
    subject.table = law_describe_damage(subject.damage);
  }
  return subject;
}

static bool applies(const ConformanceTest *test, const Subject *subject) {
  switch (test->scope) {
  case FOR_LAW:
    return true;
  case FOR_ENERGY:
    return subject->energy != NULL;
  case FOR_EXPLICIT:
    return subject->damage && subject->damage->evolution;
  case FOR_GENERAL:
    return subject->damage && subject->damage->update;
  default:
    return false;
  }
}

/* A pipe_end of -1: nobody is at the other end. */
static bool send_part(int pipe_end, const void *part, size_t size) {
  if (pipe_end < 0) return true;
  return write(pipe_end, part, size) == (ssize_t)size;
}

static Verdict run_on_law(const ConformanceTest *test, const Subject *subject) {
  return applies(test, subject) ? test->run(subject) : verdict(CONFORMANCE_SKIPPED, "%s", "");
}

/* Fills in the answer; the law's id is sent on the way. */
static void perform(const char *file, Task task, int pipe_end, Answer *answer) {
  const mlaw_plugin *plugin = NULL;
  Error reason;
  Subject subject = {.file = file};
  const bool of_file = task.test->scope == FOR_FILE;
  const bool opened = !of_file && plugin_open(file, &plugin, &reason) == STATUS_OK;
  if (opened) {
    subject.plugin = plugin;
    answer->n_laws = plugin->n_energy + plugin->n_damage;
    if (is_of_law(task.test)) {
      subject = choose_law(file, plugin, task.law);
      snprintf(answer->law, sizeof answer->law, "%s", subject.table.id);
    }
  }
  send_part(pipe_end, answer->law, sizeof answer->law);
  if (!opened && !of_file) {
    answer->verdict = verdict(CONFORMANCE_FAILED, "%.470s", reason.text);
  } else if (task.test->run) {
    answer->verdict = is_of_law(task.test) ? run_on_law(task.test, &subject) : task.test->run(&subject);
  }
}

/* What a plugin prints is nobody's concern; it must not spoil the report. */
static void silence(void) {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

static void be_child(const char *file, Task task, int pipe_end) {
  Answer answer = {.verdict = verdict_passed()};
  silence();
  perform(file, task, pipe_end, &answer);
  const size_t sent = sizeof answer.law;
  _exit(send_part(pipe_end, (const char *)&answer + sent, sizeof answer - sent) ? 0 : 1);
}

/* ---- In the parent ---- */

/* Reads the whole answer; false at the end of the pipe or of the time. */
static bool receive(int pipe_end, double time_limit, Answer *answer, bool *in_time) {
  const double end = timer_wall_seconds() + time_limit;
  size_t got = 0;
  *in_time = true;
  while (got < sizeof *answer) {
    struct pollfd ready = {.fd = pipe_end, .events = POLLIN};
    const double left = end - timer_wall_seconds();
    const int n = poll(&ready, 1, left > 0.0 ? (int)(1e3 * left) + 1 : 0);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      *in_time = false;
      return false;
    }
    const ssize_t more = read(pipe_end, (char *)answer + got, sizeof *answer - got);
    if (more <= 0) return false;
    got += (size_t)more;
  }
  return true;
}

static Verdict without_answer(bool in_time, double time_limit, int status) {
  if (!in_time) return verdict(CONFORMANCE_TIMED_OUT, "no answer within %g s", time_limit);
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return verdict(CONFORMANCE_CRASHED, "ended by signal %d (%s)", number, strsignal(number));
  }
  return verdict(CONFORMANCE_CRASHED, "ended with exit code %d before it answered", WEXITSTATUS(status));
}

static Status run_in_child(const char *file, Task task, double time_limit, Answer *answer, Error *error) {
  int ends[2];
  if (pipe(ends) != 0) return error_set(error, STATUS_IO, "a pipe cannot be had: %s", strerror(errno));
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    return error_set(error, STATUS_IO, "a process cannot be started: %s", strerror(errno));
  }
  if (child == 0) {
    close(ends[0]);
    be_child(file, task, ends[1]);
  }
  close(ends[1]);
  bool in_time;
  int status = 0;
  *answer = (Answer){0};
  const bool answered = receive(ends[0], time_limit, answer, &in_time);
  close(ends[0]);
  if (!answered) kill(child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!answered) answer->verdict = without_answer(in_time, time_limit, status);
  return STATUS_OK;
}

static Status run_task(const char *file, Task task, const ConformanceOptions *options, Answer *answer,
                       Error *error) {
  if (!options->in_process) return run_in_child(file, task, options->time_limit, answer, error);
  *answer = (Answer){.verdict = verdict_passed()};
  perform(file, task, -1, answer);
  return STATUS_OK;
}

/* ---- The whole suite ---- */

typedef struct {
  const ConformanceOptions *options;
  char *file;
  regex_t only;
  ConformanceReport *report;
  size_t capacity;
  size_t done, total; /* tests, applicable or not */
} CheckRun;

static bool is_wanted(const CheckRun *run, const ConformanceGroup *group, const ConformanceTest *test) {
  char name[128];
  if (!run->options->only) return true;
  snprintf(name, sizeof name, "%s/%s", group->name, test->name);
  return regexec(&run->only, name, 0, NULL, 0) == 0;
}

static Status add_result(CheckRun *run, const ConformanceGroup *group, const ConformanceTest *test,
                         const Answer *answer, Error *error) {
  ConformanceReport *report = run->report;
  if (report->n == run->capacity) {
    const size_t capacity = 2 * run->capacity + 64;
    ConformanceResult *grown = array_allocate(capacity, sizeof *grown, "conformance results", error);
    if (!grown) return error->code;
    if (report->n) memcpy(grown, report->result, report->n * sizeof *grown);
    array_free(report->result);
    report->result = grown;
    run->capacity = capacity;
  }
  ConformanceResult *result = &report->result[report->n++];
  *result = (ConformanceResult){group->name, test->name, test->about, "", answer->verdict.outcome, ""};
  memcpy(result->law, answer->law, sizeof result->law);
  memcpy(result->text, answer->verdict.text, sizeof result->text);
  report->n_bad += conformance_is_bad(result->outcome);
  return STATUS_OK;
}

static void tell(const CheckRun *run, const ConformanceGroup *group, const ConformanceTest *test) {
  char name[128];
  if (!run->options->progress) return;
  snprintf(name, sizeof name, "%s/%s", group->name, test->name);
  run->options->progress(run->options->context, run->done, run->total, name);
}

static Status run_test(CheckRun *run, const ConformanceGroup *group, const ConformanceTest *test,
                       uint32_t law, bool *out_of_time, Error *error) {
  Status status;
  Answer answer;
  tell(run, group, test);
  TRY(run_task(run->file, (Task){test, law}, run->options, &answer, error));
  const bool inapplicable = answer.verdict.outcome == CONFORMANCE_SKIPPED && !answer.verdict.text[0];
  if (!inapplicable) TRY(add_result(run, group, test, &answer, error));
  *out_of_time = answer.verdict.outcome == CONFORMANCE_TIMED_OUT;
cleanup:
  return status;
}

static bool is_due(const CheckRun *run, const ConformanceGroup *group, const ConformanceTest *test,
                   bool of_law) {
  return test->run && is_of_law(test) == of_law && is_wanted(run, group, test);
}

/* Tests of the plugin as a whole, or of one law. */
static size_t count_tests(const CheckRun *run, bool of_law) {
  size_t count = 0;
  for (int g = 0; g < N_GROUPS; g++)
    for (size_t k = 0; k < groups[g]->n; k++) count += is_due(run, groups[g], &groups[g]->test[k], of_law);
  return count;
}

/* Runs those tests.  After one that ran out of time the rest is left out: most would do the same. */
static Status run_tests(CheckRun *run, bool of_law, uint32_t law, Error *error) {
  Status status = STATUS_OK;
  bool out_of_time = false;
  for (int g = 0; g < N_GROUPS; g++) {
    for (size_t k = 0; k < groups[g]->n; k++) {
      const ConformanceTest *test = &groups[g]->test[k];
      if (!is_due(run, groups[g], test, of_law)) continue;
      if (!out_of_time) TRY(run_test(run, groups[g], test, law, &out_of_time, error));
      run->done++;
    }
  }
cleanup:
  return status;
}

static Status compile_only(CheckRun *run, Error *error) {
  const char *only = run->options->only;
  if (!only) return STATUS_OK;
  if (regcomp(&run->only, only, REG_EXTENDED | REG_NOSUB) != 0) {
    run->options = NULL;
    return error_set(error, STATUS_INPUT, "expected a regular expression, found `%s`", only);
  }
  for (int g = 0; g < N_GROUPS; g++) {
    for (size_t k = 0; k < groups[g]->n; k++) {
      if (is_wanted(run, groups[g], &groups[g]->test[k])) return STATUS_OK;
    }
  }
  return error_set(error, STATUS_INPUT, "no test is named like `%s`", only);
}

/* The plugin must open before anything else can be asked: always done, whatever `only` says. */
static Status survey(CheckRun *run, uint32_t *n_laws, Error *error) {
  const ConformanceTest *opens = &conformance_load.test[0];
  Status status;
  Answer answer;
  TRY(run_task(run->file, (Task){opens, 0}, run->options, &answer, error));
  TRY(add_result(run, &conformance_load, opens, &answer, error));
  *n_laws = answer.n_laws;
cleanup:
  return status;
}

Status conformance_run(const ConformanceOptions *options, ConformanceReport *report, Error *error) {
  Status status;
  uint32_t n_laws = 0;
  CheckRun run = {.options = options, .report = report};
  *report = (ConformanceReport){0};
  TRY(compile_only(&run, error));
  run.file = file_exists(options->file) ? realpath(options->file, NULL) : NULL;
  if (!run.file) TRY(error_set(error, STATUS_INPUT, "%s: not a file that can be read", options->file));
  TRY(survey(&run, &n_laws, error));
  if (report->n_bad) goto cleanup;
  run.total = count_tests(&run, false) + n_laws * count_tests(&run, true);
  TRY(run_tests(&run, false, 0, error));
  for (uint32_t k = 0; k < n_laws; k++) TRY(run_tests(&run, true, k, error));
cleanup:
  if (run.options && options->only) regfree(&run.only);
  free(run.file);
  if (status != STATUS_OK) conformance_free(report);
  return status;
}

void conformance_free(ConformanceReport *report) {
  array_free(report->result);
  *report = (ConformanceReport){0};
}

/* The first test that failed, and how to go on from there; a plugin that cannot be opened has but one. */
static Status refuse(const char *file, const ConformanceReport *report, Error *error) {
  Status status;
  Text advice = {0};
  const ConformanceResult *first = report->result;
  while (!conformance_is_bad(first->outcome)) first++;
  if (report->n > 1) {
    TRY(text_append(&advice, error,
                    " (tests failed: %zu; `capsella laws check %s` tells all, and `membrane.check_laws: "
                    "false` runs such a law)",
                    report->n_bad, file));
  }
  TRY(error_set(error, STATUS_INPUT, "%s%s%s/%s %s: %s%s", first->law, first->law[0] ? ": " : "",
                first->group, first->name, conformance_outcome_name(first->outcome), first->text,
                advice.data ? advice.data : ""));
cleanup:
  text_free(&advice);
  return status;
}

Status conformance_admit(const char *file, Error *error) {
  Status status;
  ConformanceReport report = {0};
  const ConformanceOptions options = {.file = file, .time_limit = CONFORMANCE_TIME_LIMIT};
  TRY(conformance_run(&options, &report, error));
  if (report.n_bad) TRY(refuse(file, &report, error));
cleanup:
  conformance_free(&report);
  return status;
}
