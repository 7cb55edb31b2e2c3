/* Shortest decimals by trial: 15 digits are exact for every number written by hand, 17 for every double. */
#include "observe/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void number_print(double value, char text[NUMBER_SIZE]) {
  if (isnan(value)) {
    snprintf(text, NUMBER_SIZE, "nan");
    return;
  }
  for (int digits = 15; digits <= 17; digits++) {
    snprintf(text, NUMBER_SIZE, "%.*g", digits, value);
    if (strtod(text, NULL) == value) return;
  }
}
