/* Words, numbers and ticks of an SVG document: what pictures and charts have in common. */
#ifndef CAPSELLA_OBSERVE_SVG_H
#define CAPSELLA_OBSERVE_SVG_H

#include "base/status.h"
#include "base/text.h"

/* Appends `string` so that it may stand between tags or in a quoted attribute. */
Status svg_escape(Text *svg, const char *string, Error *error);

/* A line of text at (x, y) pixels; `anchor`: start, middle or end. */
Status svg_label(Text *svg, double x, double y, const char *anchor, const char *label, Error *error);

/* A number of at most six digits; below 0.001 and from 100000 with a power of ten: 10^-6, 2.5·10^7. */
Status svg_number(Text *svg, double x, double y, const char *anchor, double value, Error *error);

/* The step of 1, 2 or 5 times a power of ten that cuts `range` into about `count` parts. */
double svg_tick_step(double range, double count);

#endif
