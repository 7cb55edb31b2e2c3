/* Growable text and the nearest known name.  Formatting is the C library's; nothing here knows of YAML or
 * files. */
#include "base/text.h"

#include "base/array.h"
#include <ctype.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Room for `more` bytes and the NUL behind them. */
static Status reserve(Text *text, size_t more, Error *error) {
  if (text->data && more < text->capacity - text->length) return STATUS_OK;
  size_t capacity = text->capacity ? text->capacity : 64;
  while (capacity - text->length <= more) {
    if (capacity > SIZE_MAX / 2) return error_set(error, STATUS_MEMORY, "text: %zu bytes more", more);
    capacity *= 2;
  }
  char *data = array_allocate(capacity, 1, "text", error);
  if (!data) return error->code;
  if (text->data) memcpy(data, text->data, text->length);
  array_free(text->data);
  text->data = data;
  text->capacity = capacity;
  return STATUS_OK;
}

Status text_append_bytes(Text *text, Error *error, const char *bytes, size_t length) {
  Status status = reserve(text, length, error);
  if (status != STATUS_OK) return status;
  memcpy(text->data + text->length, bytes, length);
  text->length += length;
  text->data[text->length] = '\0';
  return STATUS_OK;
}

Status text_append(Text *text, Error *error, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  int length = vsnprintf(NULL, 0, format, arguments);
  va_end(arguments);
  if (length < 0) return error_set(error, STATUS_FAILED, "text: cannot be formatted");
  Status status = reserve(text, (size_t)length, error);
  if (status != STATUS_OK) return status;
  va_start(arguments, format);
  vsnprintf(text->data + text->length, text->capacity - text->length, format, arguments);
  va_end(arguments);
  text->length += (size_t)length;
  return STATUS_OK;
}

void text_free(Text *text) {
  array_free(text->data);
  *text = (Text){0};
}

char *text_copy(const char *string, Error *error) {
  size_t size = strlen(string) + 1;
  char *copy = array_allocate(size, 1, "text", error);
  if (copy) memcpy(copy, string, size);
  return copy;
}

enum { NAME_MAX_LENGTH = 127 }; /* longer names are not compared */

static size_t least(size_t a, size_t b) {
  return a < b ? a : b;
}

/* Number of insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b` (optimal
 * string alignment). */
static size_t edit_distance(const char *a, const char *b) {
  size_t rows[3][NAME_MAX_LENGTH + 1];
  size_t n = strlen(b);
  size_t *before = rows[0], *previous = rows[1], *row = rows[2];
  for (size_t j = 0; j <= n; j++) row[j] = j;
  for (size_t i = 1; a[i - 1]; i++) {
    size_t *oldest = before;
    before = previous;
    previous = row;
    row = oldest;
    row[0] = i;
    for (size_t j = 1; j <= n; j++) {
      int x = tolower((unsigned char)a[i - 1]), y = tolower((unsigned char)b[j - 1]);
      row[j] = least(previous[j - 1] + (x != y), least(previous[j], row[j - 1]) + 1);
      if (i > 1 && j > 1 && x == tolower((unsigned char)b[j - 2]) && y == tolower((unsigned char)a[i - 2]))
        row[j] = least(row[j], before[j - 2] + 1);
    }
  }
  return row[n];
}

const char *text_nearest(const char *name, const char *const *names, size_t count) {
  const char *nearest = NULL;
  size_t smallest = SIZE_MAX, length = strlen(name);
  if (length > NAME_MAX_LENGTH) return NULL;
  for (size_t k = 0; k < count; k++) {
    size_t other = strlen(names[k]);
    if (other > NAME_MAX_LENGTH) continue;
    size_t limit = ((length > other ? length : other) + 1) / 3; /* one slip in three letters */
    size_t distance = edit_distance(name, names[k]);
    if (distance > limit || distance >= smallest) continue;
    smallest = distance;
    nearest = names[k];
  }
  return nearest;
}
