#include "study/decimal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { DIGITS = 10 };

double decimal_digits(double value, int digits) {
  char text[DECIMAL_SIZE];
  snprintf(text, sizeof text, "%.*g", digits, value);
  return strtod(text, NULL);
}

double decimal_unit(double tolerance) {
  return pow(10, floor(log10(tolerance / 4)));
}

double decimal_multiple(double value, double unit) {
  return decimal_digits(unit * rint(value / unit), DIGITS);
}

void decimal_print(double value, char text[DECIMAL_SIZE]) {
  snprintf(text, DECIMAL_SIZE, "%.*g", DIGITS, value);
}
