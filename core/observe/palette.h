/* The colours of fields in pictures: viridis, even in lightness, and legible to colour-blind eyes and in
 * grey. */
#ifndef CAPSELLA_OBSERVE_PALETTE_H
#define CAPSELLA_OBSERVE_PALETTE_H

#include "base/status.h"
#include "base/text.h"

/* Red, green and blue from 0 to 255 at a fraction of the range; what is outside has the colour of the end. */
void palette_color(double fraction, double rgb[3]);

/* A vertical gradient of the whole range, low at the bottom, under this id. */
Status palette_gradient(const char *id, Text *svg, Error *error);

#endif
