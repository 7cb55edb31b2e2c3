/* Columns of numbers from a CSV file with one header line, such as history.csv.  No quoted cells. */
#ifndef CAPSELLA_OBSERVE_COLUMNS_H
#define CAPSELLA_OBSERVE_COLUMNS_H

#include "base/status.h"
#include <stddef.h>

typedef struct {
  double **values; /* [n][n_rows], in the order of the names asked for; a cell that is no number is NAN */
  size_t n, n_rows;
} Columns;

/* STATUS_IO: the file cannot be read.  STATUS_INPUT: it has no column of one of the names.  A last line
 * without an end is left out: the row of a run that was killed. */
Status columns_read(Columns *columns, const char *path, const char *const *names, size_t n, Error *error);
void columns_free(Columns *columns);

#endif
