/* The outline of what is seen of a surface, or of the part of it where a field is at least a level: closed
 * loops, as the path data of SVG.  Maps made of such regions, one over the other, are smooth and small. */
#ifndef CAPSELLA_OBSERVE_OUTLINE_H
#define CAPSELLA_OBSERVE_OUTLINE_H

#include "base/status.h"
#include "base/text.h"
#include "observe/projection.h"

/* Appends the loops around the pieces, cut where the field (linear on each) falls below `level`; -INFINITY:
 * whole.  One unit of the path is 1/scale of a length; coordinates are whole numbers, y downwards.  Nothing
 * is appended where the field is below the level everywhere. */
Status outline_print(const Piece *pieces, size_t count, double level, double scale, Text *path, Error *error);

#endif
