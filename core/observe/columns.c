#include "observe/columns.h"

#include "base/array.h"
#include "base/file.h"
#include "base/text.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST_FILE = 1 << 30 };

/* Length of the cell that begins here. */
static size_t cell_length(const char *cell) {
  return strcspn(cell, ",\n");
}

/* The next cell of the line, or NULL. */
static const char *next_cell(const char *cell) {
  cell += cell_length(cell);
  return *cell == ',' ? cell + 1 : NULL;
}

static Status find_column(const char *header, const char *path, const char *name, size_t *place,
                          Error *error) {
  *place = 0;
  for (const char *cell = header; cell; cell = next_cell(cell), ++*place)
    if (cell_length(cell) == strlen(name) && strncmp(cell, name, strlen(name)) == 0) return STATUS_OK;
  return error_set(error, STATUS_INPUT, "%s: expected a column `%s`, found none", path, name);
}

static size_t count_lines(const Text *text) {
  size_t lines = 0;
  for (size_t k = 0; k < text->length; k++) lines += text->data[k] == '\n';
  return lines;
}

static double read_cell(const char *line, size_t place) {
  const char *cell = line;
  while (cell && place-- > 0) cell = next_cell(cell);
  if (!cell) return NAN;
  char *end;
  const double value = strtod(cell, &end);
  return end != cell && end == cell + cell_length(cell) ? value : NAN;
}

static void read_column(const Text *text, size_t place, double *values, size_t n_rows) {
  const char *line = text->data;
  for (size_t row = 0; row < n_rows; row++) {
    line = strchr(line, '\n') + 1;
    values[row] = read_cell(line, place);
  }
}

Status columns_read(Columns *columns, const char *path, const char *const *names, size_t n, Error *error) {
  Status status;
  Text text = {0};
  *columns = (Columns){.n = n};
  TRY(file_read(path, LARGEST_FILE, &text, error));
  const size_t lines = text.data ? count_lines(&text) : 0;
  columns->n_rows = lines > 0 ? lines - 1 : 0;
  TRY(ARRAY_NEW(&columns->values, n, error));
  for (size_t k = 0; k < n; k++) {
    size_t place;
    TRY(find_column(lines > 0 ? text.data : "", path, names[k], &place, error));
    TRY(ARRAY_NEW(&columns->values[k], columns->n_rows, error));
    read_column(&text, place, columns->values[k], columns->n_rows);
  }
cleanup:
  text_free(&text);
  if (status != STATUS_OK) columns_free(columns);
  return status;
}

void columns_free(Columns *columns) {
  for (size_t k = 0; columns->values && k < columns->n; k++) array_free(columns->values[k]);
  array_free(columns->values);
  *columns = (Columns){0};
}
