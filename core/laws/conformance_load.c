/* Group `load`: what opening the file does to the process, and what the file offers and takes. */
#include "laws/conformance_test.h"
#include "laws/elf_symbols.h"
#include <dlfcn.h>
#include <fenv.h>
#include <float.h>
#include <stdbool.h>
#include <string.h>

/* Is `name` one of a list of names that each end in a blank? */
static bool is_listed(const char *list, const char *name) {
  const size_t length = strlen(name);
  for (const char *at = list; (at = strstr(at, name)); at += length) {
    if ((at == list || at[-1] == ' ') && at[length] == ' ') return true;
  }
  return false;
}

/* Splits off the first name of such a list; false at its end. */
static bool next_name(char **list, char **name) {
  char *end = strchr(*list, ' ');
  if (!end) return false;
  *end = '\0';
  *name = *list;
  *list = end + 1;
  return true;
}

static Verdict only_entry_exported(const Subject *subject) {
  /* Entries of other majors, and marks that linkers leave. */
  static const char allowed[] = "_init _fini _edata _end __bss_start ";
  Text offered = {0}, taken = {0};
  Error error;
  Verdict result = verdict_passed();
  if (elf_symbols(subject->file, &offered, &taken, &error) != STATUS_OK) {
    result = verdict(CONFORMANCE_SKIPPED, "%.470s", error.text);
  } else {
    for (char *list = offered.data, *name; next_name(&list, &name);) {
      if (strncmp(name, "mlaw_plugin_v", 13) == 0 || is_listed(allowed, name)) continue;
      result = verdict(CONFORMANCE_FAILED,
                       "expected " MLAW_ENTRY_NAME " to be the one exported symbol, found %s as well "
                       "(compile with -fvisibility=hidden)",
                       name);
      break;
    }
  }
  text_free(&offered);
  text_free(&taken);
  return result;
}

static Verdict no_forbidden_import(const Subject *subject) {
  static const char *const forbidden[] = {"malloc",
                                          "calloc",
                                          "realloc",
                                          "free",
                                          "aligned_alloc",
                                          "posix_memalign",
                                          "_Znwm",
                                          "_Znam",
                                          "fopen",
                                          "open",
                                          "printf",
                                          "fprintf",
                                          "puts",
                                          "fputs",
                                          "fwrite",
                                          "perror",
                                          "exit",
                                          "_exit",
                                          "abort",
                                          "signal",
                                          "sigaction",
                                          "setlocale",
                                          "system",
                                          "fork",
                                          "dlopen",
                                          "fesetround",
                                          "fesetenv",
                                          "feenableexcept",
                                          "pthread_mutex_lock",
                                          "pthread_create",
                                          "setenv",
                                          "getenv",
                                          "rand",
                                          "srand",
                                          "time"};
  Text offered = {0}, taken = {0};
  Error error;
  Verdict result = verdict_passed();
  if (elf_symbols(subject->file, &offered, &taken, &error) != STATUS_OK) {
    result = verdict(CONFORMANCE_SKIPPED, "%.470s", error.text);
  } else {
    for (size_t k = 0; k < sizeof forbidden / sizeof *forbidden; k++) {
      if (!is_listed(taken.data, forbidden[k])) continue;
      result = verdict(CONFORMANCE_FAILED,
                       "expected no allocation, input, output, lock or global state, found a call of %s",
                       forbidden[k]);
      break;
    }
  }
  text_free(&offered);
  text_free(&taken);
  return result;
}

bool subnormals_live(void) {
  volatile double smallest = DBL_MIN;
  volatile double half = smallest * 0.5; /* 0 when results are flushed */
  volatile double back = half * 2.0;     /* 0 when operands are */
  return half != 0.0 && back == smallest;
}

/* The library must leave subnormal numbers and the rounding direction as they are. */
static Verdict fp_mode_unchanged(const Subject *subject) {
  const int rounding = fegetround();
  const bool alive = subnormals_live();
  const mlaw_plugin *plugin;
  Error reason;
  if (plugin_open(subject->file, &plugin, &reason) != STATUS_OK) {
    return verdict(CONFORMANCE_FAILED, "%.470s", reason.text);
  }
  if (alive && !subnormals_live()) {
    return verdict(CONFORMANCE_FAILED,
                   "expected the floating-point mode of the process to stay as it is, found "
                   "subnormal numbers flushed to zero (built or linked with -ffast-math?)");
  }
  if (fegetround() != rounding) {
    return verdict(CONFORMANCE_FAILED, "expected the rounding direction to stay as it is, found it changed");
  }
  return verdict_passed();
}

static mlaw_entry_fn *find_entry(const Subject *subject) {
  mlaw_entry_fn *entry = NULL;
  void *handle = dlopen(subject->file, RTLD_NOW | RTLD_LOCAL);
  void *symbol = handle ? dlsym(handle, MLAW_ENTRY_NAME) : NULL;
  memcpy(&entry, &symbol, sizeof entry);
  return entry;
}

static Verdict entry_idempotent(const Subject *subject) {
  mlaw_entry_fn *entry = find_entry(subject);
  const mlaw_plugin *first = entry(MLAW_ABI_MINOR), *second = entry(MLAW_ABI_MINOR);
  if (first == second && first == subject->plugin) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected one answer of " MLAW_ENTRY_NAME ", found another at a later call");
}

static Verdict unknown_host_minor(const Subject *subject) {
  mlaw_entry_fn *entry = find_entry(subject);
  entry(0);
  if (entry(MLAW_ABI_MINOR + 1000)) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected a plugin to serve newer hosts, found that it declines ABI %d.%d", MLAW_ABI_MAJOR,
                 MLAW_ABI_MINOR + 1000);
}

static const ConformanceTest tests[] = {
    {FOR_PLUGIN, "opens-now-local", "the linker resolves every symbol, and host and plugin agree", NULL},
    {FOR_FILE, "fp-mode-unchanged", "opening the file leaves rounding and subnormal numbers alone",
     fp_mode_unchanged},
    {FOR_FILE, "only-entry-exported", "the entry is the one symbol that others can see", only_entry_exported},
    {FOR_FILE, "no-forbidden-import", "no allocation, input, output, lock or global state is called",
     no_forbidden_import},
    {FOR_PLUGIN, "entry-idempotent", "the entry gives the same answer each time", entry_idempotent},
    {FOR_PLUGIN, "unknown-host-minor", "a host of a later minor is served", unknown_host_minor},
};

const ConformanceGroup conformance_load = {"load", tests, sizeof tests / sizeof *tests};
