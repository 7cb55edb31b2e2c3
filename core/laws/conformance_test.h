/* Inside the conformance checker: what a test is handed, and how it answers. */
#ifndef CAPSELLA_LAWS_CONFORMANCE_TEST_H
#define CAPSELLA_LAWS_CONFORMANCE_TEST_H

#include "laws/conformance.h"
#include "laws/plugin.h"
#include <stdbool.h>

/* The plugin or the law under test. */
typedef struct {
  const char *file;
  const mlaw_plugin *plugin; /* NULL in the group `load`, whose tests open the file themselves */
  const mlaw_energy *energy; /* at most one of the two */
  const mlaw_damage *damage;
  LawDescription table; /* of that law */
} Subject;

typedef struct {
  ConformanceOutcome outcome;
  char text[480];
} Verdict;

/* `return verdict(CONFORMANCE_FAILED, "expected %g, found %g", a, b);` */
Verdict verdict(ConformanceOutcome outcome, const char *format, ...) PRINTF_LIKE(2, 3);
Verdict verdict_passed(void);

/* Whether subnormal numbers are neither flushed to zero nor taken for zero (conformance_load.c). */
bool subnormals_live(void);

/* Ends the test with the verdict of a part of it unless that passed. */
#define EXPECT(call)                                                                                         \
  do {                                                                                                       \
    const Verdict result_ = (call);                                                                          \
    if (result_.outcome != CONFORMANCE_PASSED) return result_;                                               \
  } while (0)

typedef enum {
  FOR_FILE,     /* before it is opened */
  FOR_PLUGIN,   /* the plugin as a whole */
  FOR_LAW,      /* every law */
  FOR_ENERGY,   /* energy laws */
  FOR_EXPLICIT, /* damage laws with threshold and evolution */
  FOR_GENERAL   /* damage laws with update */
} TestScope;

typedef struct {
  TestScope scope;
  const char *name, *about;
  Verdict (*run)(const Subject *subject); /* NULL: it passes when the plugin can be opened */
} ConformanceTest;

typedef struct {
  const char *name;
  const ConformanceTest *test;
  size_t n;
} ConformanceGroup;

extern const ConformanceGroup conformance_load;        /* conformance_load.c */
extern const ConformanceGroup conformance_description; /* conformance_description.c */
extern const ConformanceGroup conformance_contract;    /* conformance_contract.c */
extern const ConformanceGroup conformance_energy;      /* conformance_energy.c */
extern const ConformanceGroup conformance_damage;      /* conformance_damage.c */

#endif
