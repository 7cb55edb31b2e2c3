/* What every fuzz target offers, to libFuzzer and to the replay of its seeds. */
#ifndef CAPSELLA_TESTS_FUZZ_H
#define CAPSELLA_TESTS_FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* Takes any bytes; a fault ends the process. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A file of this process that holds the bytes, for readers that want a path. */
static inline const char *fuzz_file(const void *data, size_t size) {
  static char path[] = "/tmp/capsella-fuzz-XXXXXX";
  static int handle = -1;
  if (handle < 0) handle = mkstemp(path);
  if (handle < 0 || ftruncate(handle, 0) != 0 || pwrite(handle, data, size, 0) != (ssize_t)size) abort();
  return path;
}

#endif
