/* Aligned, checked, zeroed allocation.  Every array of the library comes from here, so that a test can make
 * the n-th allocation fail and walk n upward through set-up and a step. */
#ifndef CAPSELLA_BASE_ARRAY_H
#define CAPSELLA_BASE_ARRAY_H

#include "base/status.h"
#include <stddef.h>

/* `count` objects of `size` bytes, zeroed, aligned to 64 bytes; NULL with STATUS_MEMORY in `error` when they
 * cannot be had (`what` names the array in the message).  A count of 0 gives a valid pointer. */
void *array_allocate(size_t count, size_t size, const char *what, Error *error);

/* Releases an array; NULL is allowed. */
void array_free(void *array);

/* `*pointer = new zeroed array of count objects`, as a Status: TRY(ARRAY_NEW(&mesh->X, 3 * n, error)). */
#define ARRAY_NEW(pointer, count, error)                                                                     \
  ((*(pointer) = array_allocate((size_t)(count), sizeof **(pointer), #pointer, error)) ? STATUS_OK           \
                                                                                       : STATUS_MEMORY)

/* For tests: the n-th allocation from now on fails (n >= 1); 0 turns this off.  Returns how many were left of
 * an earlier n: 0 when that allocation has failed. */
long array_fail_nth(long n);

#endif
