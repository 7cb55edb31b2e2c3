/* A folder of its own for a test program: made before the suite runs, removed with all it holds after. */
#ifndef CAPSELLA_TESTS_SCRATCH_H
#define CAPSELLA_TESTS_SCRATCH_H

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char scratch_default[] = "/tmp/capsella-test-XXXXXX";
static char *scratch_folder = scratch_default; /* a test may set it to another name before scratch_make */

/* "folder/name"; valid until the eighth call after this one. */
static inline const char *scratch_path(const char *name) {
  static char path[8][512];
  static int next;
  char *result = path[next++ % 8];
  snprintf(result, sizeof path[0], "%s/%s", scratch_folder, name);
  return result;
}

static inline bool scratch_make(void) {
  return mkdtemp(scratch_folder) != NULL;
}

/* Files only: a test that makes folders removes them itself. */
static inline void scratch_empty(void) {
  DIR *entries = opendir(scratch_folder);
  for (struct dirent *entry; entries && (entry = readdir(entries));)
    if (entry->d_name[0] != '.') remove(scratch_path(entry->d_name));
  if (entries) closedir(entries);
}

static inline void scratch_remove(void) {
  scratch_empty();
  remove(scratch_folder);
}

#endif
