/* Studies for tests: read from the scratch folder, with a few lines of shell in place of the program that
 * runs a case. */
#ifndef CAPSELLA_TESTS_STUDY_FILE_H
#define CAPSELLA_TESTS_STUDY_FILE_H

#include "base/file.h"
#include "scratch.h"
#include "study/runner.h"
#include <check.h>
#include <sys/stat.h>

static inline YamlNode *tree_of(const char *yaml) {
  YamlNode *root;
  Error error;
  const Status status = yaml_tree_parse(&root, "test.yaml", true, yaml, strlen(yaml), &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return root;
}

static inline void expect_words(const Error *error, const char *words) {
  ck_assert_msg(strstr(error->text, words) != NULL, "expected `%s` in: %s", words, error->text);
}

static inline void scratch_write(const char *name, const char *content) {
  FILE *file = fopen(scratch_path(name), "w");
  ck_assert_ptr_nonnull(file);
  fputs(content, file);
  ck_assert_int_eq(fclose(file), 0);
}

/* A sweep of a small elastic scene; `vary` is what follows, as YAML. */
static inline Study study_that_varies(const char *vary) {
  Study study;
  Error error;
  char text[2048];
  snprintf(text, sizeof text,
           "schema: 1\nstudy: sweep\n"
           "scene:\n"
           "  schema: 1\n"
           "  membrane: {law: neo_hookean, parameters: {G_s: 1}}\n"
           "  flow: {kind: simple_shear, capillary_number: 0.7}\n"
           "  time: {end: 10}\n"
           "%s",
           vary);
  scratch_write("study.yaml", text);
  const Status status = study_read(&study, scratch_path("study.yaml"), NULL, 0, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return study;
}

/* A program that takes the arguments of a case: `body` finds its folder in $folder and the capillary number
 * of its settings in $Ca, and may write $folder/summary.json. */
static inline const char *stand_in(const char *body) {
  char text[2048];
  snprintf(text, sizeof text,
           "#!/bin/sh\n"
           "folder=$7 Ca=0.7\n"
           "for argument; do case $argument in flow.capillary_number=*) Ca=${argument#*=} ;; esac; done\n"
           "%s\n",
           body);
  scratch_write("program", text);
  ck_assert_int_eq(chmod(scratch_path("program"), 0755), 0);
  return scratch_path("program");
}

#endif
