/* A double as the shortest decimal text that reads back to the same bits. */
#ifndef CAPSELLA_OBSERVE_NUMBER_H
#define CAPSELLA_OBSERVE_NUMBER_H

enum { NUMBER_SIZE = 32 };

/* At most 17 significant digits; NAN gives "nan" whatever its sign, infinities "inf" and "-inf". */
void number_print(double value, char text[NUMBER_SIZE]);

#endif
