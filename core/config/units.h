/* Quantities: a number and, where given, a unit.
 *
 * A unit is a product of metric units with prefixes and whole powers: "N/m", "mPa.s", "1/s", "kg.m^-1.s^-1".
 * All units known here are powers of ten of SI units, so a number is scaled by one exact power of ten and
 * "35 um" is the double 35e-6. */
#ifndef CAPSELLA_CONFIG_UNITS_H
#define CAPSELLA_CONFIG_UNITS_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>

/* A quantity as written: a bare number is dimensionless; "0.1 N/m" carries SI value and exponents.  A unit
 * whose powers cancel ("mm/m") scales the number and leaves no unit. */
typedef struct {
  double value;       /* SI when has_unit, as written otherwise */
  bool has_unit;      /* some power is not 0 */
  signed char dim[4]; /* powers of mass, length, time, 0 */
} Quantity;

/* Reads "NUMBER" or "NUMBER UNIT" (decimal; nan, inf, hexadecimal and numbers beyond double are refused).
 * STATUS_INPUT with "expected ..., found ..." otherwise. */
Status units_parse(const char *text, Quantity *quantity, Error *error);

/* Reads a unit alone: the exponents of mass, length, time; `decade` (may be NULL) is the power of ten to SI.
 */
Status units_parse_unit(const char *text, signed char dim[4], int *decade, Error *error);

/* Same powers of mass, length and time. */
bool units_agree(const signed char a[4], const signed char b[4]);

/* "3.5e-05 m", "0.05 kg.s^-2", "0.7": reads back to the same quantity bit for bit. */
Status units_print(Text *text, const Quantity *quantity, Error *error);

/* The shortest decimal that reads back to the same double. */
Status units_print_number(Text *text, double value, Error *error);

#endif
