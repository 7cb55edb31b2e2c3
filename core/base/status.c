#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#undef error_set /* what the analyzer is told */
#undef error_prefix

Status error_set(Error *error, Status code, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  error->code = code;
  vsnprintf(error->text, sizeof error->text, format, arguments);
  va_end(arguments);
  return code;
}

Status error_prefix(Error *error, const char *format, ...) {
  char text[sizeof error->text];
  va_list arguments;
  va_start(arguments, format);
  int length = vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  if (length < 0) return error->code;
  size_t used = strlen(text); /* a longer prefix was cut to fit */
  size_t rest = strlen(error->text);
  if (rest > sizeof text - 1 - used) rest = sizeof text - 1 - used;
  memcpy(text + used, error->text, rest);
  text[used + rest] = '\0';
  memcpy(error->text, text, used + rest + 1);
  return error->code;
}
