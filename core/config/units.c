/* Reading and printing of quantities; see units.h for the grammar in words.
 *
 *   quantity  = number [blank] [unit]
 *   unit      = product { "/" factor } | { "/" factor }      ("1/s" and "/s" alike)
 *   product   = factor { ("." | "*" | blank) factor }
 *   factor    = [prefix] symbol ["^" integer]
 *
 * A product behind a "/" is refused: whether "N/m.s" means N/(m.s) would be a guess. */
#include "config/units.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const char *symbol;
  int decade; /* power of ten to the SI unit of the same dimension */
  signed char dim[3];
} Unit;

static const Unit UNITS[] = {
    {"m", 0, {0, 1, 0}},    {"g", -3, {1, 0, 0}},    {"s", 0, {0, 0, 1}},  {"Hz", 0, {0, 0, -1}},
    {"N", 0, {1, 1, -2}},   {"Pa", 0, {1, -1, -2}},  {"J", 0, {1, 2, -2}}, {"dyn", -5, {1, 1, -2}},
    {"P", -1, {1, -1, -1}}, {"bar", 5, {1, -1, -2}},
};

typedef struct {
  const char *symbol;
  int decade;
} Prefix;

static const Prefix PREFIXES[] = {
    {"f", -15}, {"p", -12}, {"n", -9}, {"u", -6}, {"\xc2\xb5", -6}, {"\xce\xbc", -6},
    {"m", -3},  {"c", -2},  {"d", -1}, {"k", 3},  {"M", 6},         {"G", 9},
};

#define COUNT(table) (sizeof(table) / sizeof *(table))
enum { LARGEST_POWER = 9 };

/* The end of a decimal number at the start of `text`; `text` itself when there is none. */
static const char *number_end(const char *text) {
  const char *at = text + (*text == '+' || *text == '-');
  int digits = 0;
  for (; isdigit((unsigned char)*at); at++) digits++;
  if (*at == '.')
    for (at++; isdigit((unsigned char)*at); at++) digits++;
  if (!digits) return text;
  if (*at == 'e' || *at == 'E') {
    const char *power = at + 1 + (at[1] == '+' || at[1] == '-');
    if (isdigit((unsigned char)*power)) {
      while (isdigit((unsigned char)*power)) power++;
      at = power;
    }
  }
  return at;
}

static const Unit *find_unit(const char *symbol, size_t length) {
  for (size_t i = 0; i < COUNT(UNITS); i++)
    if (strlen(UNITS[i].symbol) == length && strncmp(UNITS[i].symbol, symbol, length) == 0) return &UNITS[i];
  return NULL;
}

/* A symbol with or without a prefix; the plain symbol goes first, so that "Pa" is never peta-a. */
static const Unit *find_prefixed(const char *symbol, size_t length, int *decade) {
  const Unit *unit = find_unit(symbol, length);
  if (unit) {
    *decade = unit->decade;
    return unit;
  }
  for (size_t i = 0; i < COUNT(PREFIXES); i++) {
    size_t n = strlen(PREFIXES[i].symbol);
    if (n >= length || strncmp(symbol, PREFIXES[i].symbol, n) != 0) continue;
    unit = find_unit(symbol + n, length - n);
    if (unit) {
      *decade = unit->decade + PREFIXES[i].decade;
      return unit;
    }
  }
  return NULL;
}

/* Multiplies one factor into dim and decade and moves `at` behind it. */
static Status read_factor(const char **at, int sign, int dim[3], int *decade, Error *error) {
  size_t length = strcspn(*at, " .*/^");
  int own_decade = 0;
  const Unit *unit = find_prefixed(*at, length, &own_decade);
  if (!unit)
    return error_set(error, STATUS_INPUT,
                     "expected a unit made of m, g, s, Hz, N, Pa, J, dyn, P or bar, found `%.*s`",
                     (int)length, *at);
  *at += length;
  long power = 1;
  if (**at == '^') {
    char *end;
    power = isdigit((unsigned char)(*at)[1]) || (*at)[1] == '-' ? strtol(*at + 1, &end, 10) : 0;
    if (power == 0 || labs(power) > LARGEST_POWER)
      return error_set(error, STATUS_INPUT, "expected a power from -9 to 9, not 0, behind `^`, found `%s`",
                       *at + 1);
    *at = end;
  }
  for (int i = 0; i < 3; i++) dim[i] += sign * (int)power * unit->dim[i];
  *decade += sign * (int)power * own_decade;
  return STATUS_OK;
}

Status units_parse_unit(const char *text, signed char dim[4], int *decade, Error *error) {
  const char *at = text;
  int sum[3] = {0}, decades = 0, sign = 1;
  if (*at == '1' && at[1] == '/') at++;
  for (bool first = true; *at || first; first = false) {
    if (*at == '/') {
      sign = -1;
      at++;
    } else if (!first) {
      at++; /* one of " .*": nothing else ends a factor */
      if (sign < 0)
        return error_set(
            error, STATUS_INPUT,
            "expected only one unit behind a `/` (write `/` before each, or powers such as `s^-1`), "
            "found `%s`",
            text);
    }
    Status status = read_factor(&at, sign, sum, &decades, error);
    if (status != STATUS_OK) return status;
    for (int i = 0; i < 3; i++)
      if (abs(sum[i]) > LARGEST_POWER)
        return error_set(error, STATUS_INPUT, "expected a unit with powers from -9 to 9, found `%s`", text);
  }
  for (int i = 0; i < 3; i++) dim[i] = (signed char)sum[i];
  dim[3] = 0;
  if (decade) *decade = decades;
  return STATUS_OK;
}

Status units_parse(const char *text, Quantity *quantity, Error *error) {
  const char *end = number_end(text);
  if (end == text) return error_set(error, STATUS_INPUT, "expected a number, found `%s`", text);
  *quantity = (Quantity){.value = strtod(text, NULL)};
  const char *unit = end + strspn(end, " ");
  if (*unit) {
    int decade;
    Status status = units_parse_unit(unit, quantity->dim, &decade, error);
    if (status != STATUS_OK) return status;
    /* 10^n is exact to n = 22, and so is a division by it rounded once: 35/1e6 is the double nearest 35e-6 */
    quantity->value = decade < 0 ? quantity->value / pow(10, -decade) : quantity->value * pow(10, decade);
    quantity->has_unit = quantity->dim[0] || quantity->dim[1] || quantity->dim[2];
  }
  if (!isfinite(quantity->value))
    return error_set(error, STATUS_INPUT, "expected a number that double precision can hold, found `%s`",
                     text);
  return STATUS_OK;
}

bool units_agree(const signed char a[4], const signed char b[4]) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

Status units_print_number(Text *text, double value, Error *error) {
  char digits[40];
  int precision = 15;
  do snprintf(digits, sizeof digits, "%.*g", precision, value);
  while (strtod(digits, NULL) != value && ++precision <= 17);
  return text_append(text, error, "%s", digits);
}

Status units_print(Text *text, const Quantity *quantity, Error *error) {
  static const char *const BASE[3] = {"kg", "m", "s"};
  Status status;
  TRY(units_print_number(text, quantity->value, error));
  if (!quantity->has_unit) goto cleanup;
  const char *separator = " ";
  for (int i = 0; i < 3; i++) {
    int power = quantity->dim[i];
    if (power == 0) continue;
    TRY(text_append(text, error, "%s%s", separator, BASE[i]));
    if (power != 1) TRY(text_append(text, error, "^%d", power));
    separator = ".";
  }
cleanup:
  return status;
}
