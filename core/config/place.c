/* Messages with a place in front. */
#include "config/place.h"

#include <stdarg.h>
#include <stdio.h>

#undef place_error /* what the analyzer is told */
#undef place_prefix

Status place_error(const SourcePlace *place, Error *error, const char *format, ...) {
  char text[sizeof error->text];
  va_list arguments;
  va_start(arguments, format);
  int length = vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  error_set(error, STATUS_INPUT, "%s", length < 0 ? format : text);
  return place_prefix(place, error);
}

Status place_prefix(const SourcePlace *place, Error *error) {
  if (!place->file) return error->code;
  if (place->line == 0) return error_prefix(error, "%s: ", place->file);
  return error_prefix(error, "%s:%d:%d: ", place->file, place->line, place->column);
}
