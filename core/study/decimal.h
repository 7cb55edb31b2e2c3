/* Numbers that are tried, as people would write them. */
#ifndef CAPSELLA_STUDY_DECIMAL_H
#define CAPSELLA_STUDY_DECIMAL_H

enum { DECIMAL_SIZE = 32 };

/* The nearest double to `value` rounded to `digits` significant digits: without a tail when printed. */
double decimal_digits(double value, int digits);

/* A power of ten well below a tolerance: what is tried are multiples of it. */
double decimal_unit(double tolerance);
double decimal_multiple(double value, double unit);

/* The number as it goes into a setting. */
void decimal_print(double value, char text[DECIMAL_SIZE]);

#endif
