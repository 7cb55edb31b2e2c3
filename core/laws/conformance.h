/* Does a plugin keep the rules of mlaw.h, and is its law sound?  Every test runs in a process of its own with
 * a time limit, so that one that crashes, loops or spoils its memory costs one test and not the checker. */
#ifndef CAPSELLA_LAWS_CONFORMANCE_H
#define CAPSELLA_LAWS_CONFORMANCE_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

typedef enum {
  CONFORMANCE_PASSED,
  CONFORMANCE_SKIPPED, /* does not apply, or not reached; the text says why */
  CONFORMANCE_FAILED,
  CONFORMANCE_CRASHED, /* the process ended without an answer */
  CONFORMANCE_TIMED_OUT
} ConformanceOutcome;

const char *conformance_outcome_name(ConformanceOutcome outcome); /* "passed", ... */
bool conformance_is_bad(ConformanceOutcome outcome);              /* failed, crashed, timed out */

typedef struct {
  const char *group, *name, *about; /* "contract", "no-hole", what is tested */
  char law[64];                     /* id; "" for tests of the plugin as a whole */
  ConformanceOutcome outcome;
  char text[480]; /* what was expected and found; may be empty when passed */
} ConformanceResult;

/* Seconds.  A test takes milliseconds; these are for laws that iterate, on a busy machine. */
#define CONFORMANCE_TIME_LIMIT 10.0

typedef struct {
  const char *file;  /* path of the shared object */
  const char *only;  /* POSIX extended regular expression on "group/name"; NULL: all tests */
  double time_limit; /* seconds for each test */
  bool in_process;   /* no process of its own and no time limit: for a debugger */
  /* Told before each test how many of how many have been run; may be NULL. */
  void (*progress)(void *context, size_t done, size_t total, const char *test);
  void *context;
} ConformanceOptions;

typedef struct {
  ConformanceResult *result;
  size_t n, n_bad;
} ConformanceReport;

/* Runs every test that applies, plugin first, then law by law.  A plugin that cannot be opened is a failed
 * test, not an error; STATUS_INPUT: no such file, or `only` is not a regular expression or matches no test.
 * Calls fork: not for a process with threads running. */
Status conformance_run(const ConformanceOptions *options, ConformanceReport *report, Error *error);
void conformance_free(ConformanceReport *report);

/* A file that does not pass is refused (STATUS_INPUT): the reason names law and test.  Serves as
 * LawSearch.admit. */
Status conformance_admit(const char *file, Error *error);

#endif
