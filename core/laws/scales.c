#include "laws/scales.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The usual name of a unit with these exponents of kg, m, s, or their product. */
static const char *unit_name(const signed char dim[4], char *buffer, size_t size) {
  static const struct {
    signed char dim[4];
    const char *name;
  } known[] = {{{0, 0, 0}, "a number without unit"},
               {{1, 0, -2}, "N/m"},
               {{1, -1, -2}, "Pa"},
               {{1, 1, -2}, "N"},
               {{1, 2, -2}, "J"},
               {{0, 1, 0}, "m"},
               {{0, 0, 1}, "s"},
               {{0, 0, -1}, "1/s"},
               {{1, -1, -1}, "Pa s"},
               {{1, 0, 0}, "kg"},
               {{0, 1, -1}, "m/s"}};
  for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
    if (units_agree(known[k].dim, dim)) return known[k].name;
  }
  snprintf(buffer, size, "kg^%d m^%d s^%d", dim[0], dim[1], dim[2]);
  return buffer;
}

Status law_quantity(const mlaw_param *param, const Quantity *quantity, const LawScales *scales, double *value,
                    Error *error) {
  char buffer[64];
  *value = quantity->value;
  if (!quantity->has_unit) return STATUS_OK;
  if (!units_agree(param->dim, quantity->dim)) {
    return error_set(error, STATUS_INPUT, "expected %s, found %s",
                     strcmp(param->unit, "1") == 0 ? "a number without unit" : param->unit,
                     unit_name(quantity->dim, buffer, sizeof buffer));
  }
  if (!scales) {
    return error_set(error, STATUS_INPUT,
                     "expected a number without unit, since the scene gives no physical scales, found %s",
                     unit_name(quantity->dim, buffer, sizeof buffer));
  }
  *value /= pow(scales->mass, param->dim[0]) * pow(scales->length, param->dim[1]) *
            pow(scales->time, param->dim[2]);
  return STATUS_OK;
}
