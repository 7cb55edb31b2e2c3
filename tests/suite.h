/* Runs the tests of one file as a Check suite: `return suite_run("text", (SuiteTests){first, second, NULL});`
 * is the whole of its main. */
#ifndef CAPSELLA_TESTS_SUITE_H
#define CAPSELLA_TESTS_SUITE_H

#include <check.h>
#include <stdlib.h>

typedef const TTest *const SuiteTests[];

/* Exit code of the program: success when every test passed. */
static inline int suite_run(const char *name, SuiteTests tests) {
  TCase *group = tcase_create(name);
  for (int i = 0; tests[i]; i++) tcase_add_test(group, tests[i]);
  Suite *suite = suite_create(name);
  suite_add_tcase(suite, group);
  SRunner *runner = srunner_create(suite);
  srunner_run_all(runner, CK_ENV);
  int failed = srunner_ntests_failed(runner);
  srunner_free(runner);
  return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}

#endif
