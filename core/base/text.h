/* Growable text, and the nearest known name to a misspelt one. */
#ifndef CAPSELLA_BASE_TEXT_H
#define CAPSELLA_BASE_TEXT_H

#include "base/status.h"
#include <stddef.h>

/* A growable string; start from `Text text = {0}` and end with text_free.  `data` is NULL until something is
 * appended and always ends in NUL. */
typedef struct {
  char *data;
  size_t length, capacity;
} Text;

Status text_append(Text *text, Error *error, const char *format, ...) PRINTF_LIKE(3, 4);
/* Appends `length` bytes as they are, NUL included. */
Status text_append_bytes(Text *text, Error *error, const char *bytes, size_t length);
void text_free(Text *text);

/* A copy of `string` made by array_allocate; NULL when out of memory. */
char *text_copy(const char *string, Error *error);

/* The entry of names[0..count) nearest to `name` by edit distance (insert, delete, substitute, swap of
 * neighbours; case-insensitive), or NULL when none is near enough to be worth naming. */
const char *text_nearest(const char *name, const char *const *names, size_t count);

#endif
