/* Fields for the page: 16 bits a value between the field's bounds, which is finer than a picture shows. */
#ifndef CAPSELLA_OBSERVE_PACKED_H
#define CAPSELLA_OBSERVE_PACKED_H

#include "observe/json.h"

/* Largest level of a packed value, which stands for `max`; the one above it stands for "not a number". */
enum { PACKED_LEVELS = 65534, PACKED_NAN = 65535 };

/* {"min": , "max": , "data": }: value = min + (max - min) * level / PACKED_LEVELS, with the levels as
 * little-endian 16-bit numbers in base64.  An infinite value is packed as not a number. */
Status packed_numbers(Json *json, const char *key, const double *values, size_t count);

/* 32-bit little-endian integers in base64. */
Status packed_integers(Json *json, const char *key, const int *values, size_t count);

#endif
