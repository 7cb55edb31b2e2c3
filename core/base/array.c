#include "base/array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { ALIGNMENT = 64 };

static _Thread_local long fail_countdown;

long array_fail_nth(long n) {
  const long left = fail_countdown;
  fail_countdown = n;
  return left;
}

void *array_allocate(size_t count, size_t size, const char *what, Error *error) {
  if (*what == '&') what++;
  int made_to_fail = fail_countdown > 0 && --fail_countdown == 0;
  if (size != 0 && count > (SIZE_MAX - ALIGNMENT) / size) {
    error_set(error, STATUS_MEMORY, "%s: %zu objects of %zu bytes are more than this machine can address",
              what, count, size);
    return NULL;
  }
  size_t bytes = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
  if (bytes == 0) bytes = ALIGNMENT;
  void *array = made_to_fail ? NULL : aligned_alloc(ALIGNMENT, bytes);
  if (!array) {
    error_set(error, STATUS_MEMORY, "out of memory: %s needs %zu bytes", what, bytes);
    return NULL;
  }
  memset(array, 0, bytes);
  return array;
}

void array_free(void *array) {
  free(array);
}
