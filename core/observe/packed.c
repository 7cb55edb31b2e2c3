/* Numbers to bytes; the base64 is the writer's. */
#include "observe/packed.h"

#include "base/array.h"
#include <math.h>

static void bounds(const double *values, size_t count, double *min, double *max) {
  *min = HUGE_VAL;
  *max = -HUGE_VAL;
  for (size_t k = 0; k < count; k++) {
    if (!isfinite(values[k])) continue;
    *min = fmin(*min, values[k]);
    *max = fmax(*max, values[k]);
  }
  if (*min > *max) *min = *max = 0;
}

static unsigned level(double value, double min, double max) {
  if (!isfinite(value)) return PACKED_NAN;
  return max > min ? (unsigned)lround(PACKED_LEVELS * ((value - min) / (max - min))) : 0;
}

Status packed_numbers(Json *json, const char *key, const double *values, size_t count) {
  unsigned char *bytes = NULL;
  double min, max;
  Status status = ARRAY_NEW(&bytes, 2 * count, json->error);
  if (status != STATUS_OK) return status;
  bounds(values, count, &min, &max);
  for (size_t k = 0; k < count; k++) {
    const unsigned packed = level(values[k], min, max);
    bytes[2 * k] = (unsigned char)(packed & 0xff);
    bytes[2 * k + 1] = (unsigned char)(packed >> 8);
  }
  json_open_object(json, key);
  json_number(json, "min", min);
  json_number(json, "max", max);
  json_bytes(json, "data", bytes, 2 * count);
  json_close(json);
  array_free(bytes);
  return json->status;
}

Status packed_integers(Json *json, const char *key, const int *values, size_t count) {
  unsigned char *bytes = NULL;
  Status status = ARRAY_NEW(&bytes, 4 * count, json->error);
  if (status != STATUS_OK) return status;
  for (size_t k = 0; k < count; k++)
    for (int b = 0; b < 4; b++) bytes[4 * k + (size_t)b] = (unsigned char)((unsigned)values[k] >> 8 * b);
  json_bytes(json, key, bytes, 4 * count);
  array_free(bytes);
  return json->status;
}
