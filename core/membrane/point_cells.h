/* Points sorted into cubic cells, so that those near a place are found without a look at all of them. */
#ifndef CAPSELLA_MEMBRANE_POINT_CELLS_H
#define CAPSELLA_MEMBRANE_POINT_CELLS_H

#include "base/status.h"

typedef struct {
  double low[3], size; /* corner of the first cell, and length of their sides */
  int count[3];        /* of cells along each axis */
  int *start;          /* [cells + 1] into `point`; the last axis runs fastest */
  int *point;          /* [n] numbers of points, cell by cell, rising in each */
} PointCells;

/* point[begin] to point[end - 1]. */
typedef struct {
  int begin, end;
} PointRun;

enum { POINT_RUNS = 9 };

/* Points X [n][3], finite, n > 0; `reach` > 0 is how near is near. */
Status point_cells_new(PointCells *cells, int n, const double *X, double reach, Error *error);
void point_cells_free(PointCells *cells);

/* Runs that hold every point within `reach` of the place, and others, each point once: their number. */
int point_cells_near(const PointCells *cells, const double place[3], PointRun run[POINT_RUNS]);

#endif
