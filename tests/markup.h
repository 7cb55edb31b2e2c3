/* Whether the tags of an XML text are closed in the order they were opened. */
#ifndef CAPSELLA_TESTS_MARKUP_H
#define CAPSELLA_TESTS_MARKUP_H

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static inline bool markup_is_nested(const char *xml) {
  enum { MAX_DEPTH = 16, MAX_NAME = 31 };
  char open[MAX_DEPTH][MAX_NAME + 1];
  int depth = 0;
  for (const char *at = xml; (at = strchr(at, '<')); at++) {
    char name[MAX_NAME + 1] = {0};
    const char *end = strchr(at, '>');
    if (!end) return false;
    if (at[1] == '?' || end[-1] == '/') continue;
    if (sscanf(at + 1, "%31[A-Za-z/]", name) != 1) return false;
    if (name[0] != '/') {
      if (depth == MAX_DEPTH) return false;
      memcpy(open[depth++], name, sizeof name);
    } else if (depth == 0 || strcmp(open[--depth], name + 1) != 0) {
      return false;
    }
  }
  return depth == 0;
}

#endif
