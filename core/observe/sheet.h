/* A sheet of maps as SVG: states side by side, a field seen from one side in each row, all at one scale, with
 * a colour bar for each row.  Fields are shown in bands of even steps, which keeps the file small. */
#ifndef CAPSELLA_OBSERVE_SHEET_H
#define CAPSELLA_OBSERVE_SHEET_H

#include "observe/picture.h"

typedef struct {
  const Mesh *mesh;    /* of which only nodes and elements are looked at */
  const double *x;     /* [n_nodes][3] */
  const double *field; /* [n_nodes] */
  PictureView view;    /* its title is not shown */
} SheetPanel;

typedef struct {
  const char *label;       /* what is seen, above the row */
  double minimum, maximum; /* of the colours; equal: the range of the row's fields */
} SheetRow;

typedef struct {
  const SheetRow *rows;
  size_t n_rows;
  const char *const *columns; /* [n_columns] headings */
  size_t n_columns;
  const SheetPanel *panels; /* [n_rows][n_columns] */
} Sheet;

/* Appends a whole SVG document.  STATUS_INPUT: a view without direction, positions or field not finite. */
Status sheet_print(const Sheet *sheet, Text *svg, Error *error);

#endif
