/* Where a value of a scene stands, and messages that say so. */
#ifndef CAPSELLA_CONFIG_PLACE_H
#define CAPSELLA_CONFIG_PLACE_H

#include "base/status.h"

typedef struct {
  const char
      *file; /* as given on the command line, or "--set KEY=VALUE"; owned by the scene; NULL: unknown */
  int line, column; /* from 1, in characters; 0 for a --set */
} SourcePlace;

/* STATUS_INPUT with "file:line:column: " (or "--set KEY=VALUE: ") in front of the message. */
Status place_error(const SourcePlace *place, Error *error, const char *format, ...) PRINTF_LIKE(3, 4);

/* Puts the place in front of a message that is already there; returns the code stored with it. */
Status place_prefix(const SourcePlace *place, Error *error);

#ifdef __clang_analyzer__ /* as in status.h */
#define place_error(place, ...)    (place_error(place, __VA_ARGS__), STATUS_INPUT)
#define place_prefix(place, error) (place_prefix(place, error), STATUS_FAILED)
#endif

#endif
