/* A small JSON writer into a Text: indented, escaped, and never NaN (a number that is not finite is null).
 *
 * Errors stick: calls after the first failure do nothing, and json_end tells it. */
#ifndef CAPSELLA_OBSERVE_JSON_H
#define CAPSELLA_OBSERVE_JSON_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>
#include <stddef.h>

enum { JSON_MAX_DEPTH = 16 };

typedef struct {
  Text *text;
  Error *error;
  Status status;
  int depth;
  char closing[JSON_MAX_DEPTH]; /* ']' or '}' of each open level */
  bool has_entry[JSON_MAX_DEPTH];
} Json;

/* Starts an object or array at the top. */
void json_begin(Json *json, Text *text, Error *error);

/* `key` is NULL inside an array and at the top.  Strings are UTF-8; bytes that are not are written as U+FFFD.
 */
void json_open_object(Json *json, const char *key);
void json_open_array(Json *json, const char *key);
void json_close(Json *json); /* the innermost open object or array */
void json_number(Json *json, const char *key, double value);
void json_integer(Json *json, const char *key, long long value);
void json_string(Json *json, const char *key, const char *value); /* NULL: null */
void json_boolean(Json *json, const char *key, bool value);
void json_null(Json *json, const char *key);
void json_raw(Json *json, const char *key, const char *value);                          /* JSON already */
void json_bytes(Json *json, const char *key, const unsigned char *bytes, size_t count); /* base64 */
void json_numbers(Json *json, const char *key, const double *values, int count);        /* on one line */

/* Ends the text with a newline.  STATUS_FAILED when objects are left open: a programming error. */
Status json_end(Json *json);

#endif
