/* Pattern of a finite-element matrix, look-up and product. */
#include "linalg/sparse.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

/* The elements of a pattern, and the inverse table: elements around node i are entries start[i] ..
 * start[i + 1] - 1 of `around`. */
typedef struct {
  int n_elements, nodes_per_element;
  const int *nodes;
  int *start, *around;
} Elements;

static Status elements_invert(Elements *elements, int n, Error *error) {
  Status status = STATUS_OK;
  int *next = NULL;
  int n_entries = elements->n_elements * elements->nodes_per_element;
  TRY(ARRAY_NEW(&elements->start, n + 1, error));
  TRY(ARRAY_NEW(&elements->around, n_entries, error));
  TRY(ARRAY_NEW(&next, n, error));
  for (int k = 0; k < n_entries; k++) elements->start[elements->nodes[k] + 1]++;
  for (int i = 0; i < n; i++) {
    elements->start[i + 1] += elements->start[i];
    next[i] = elements->start[i];
  }
  for (int k = 0; k < n_entries; k++)
    elements->around[next[elements->nodes[k]]++] = k / elements->nodes_per_element;
cleanup:
  array_free(next);
  return status;
}

/* Counts the nodes joined to `row`, and lists them (unsorted) unless `columns` is NULL.  seen[j] is row + 1
 * for the nodes found so far. */
static int elements_row(const Elements *elements, int row, int *seen, int *columns) {
  int count = 0;
  for (int k = elements->start[row]; k < elements->start[row + 1]; k++) {
    const int *node = &elements->nodes[elements->around[k] * elements->nodes_per_element];
    for (int l = 0; l < elements->nodes_per_element; l++) {
      if (seen[node[l]] == row + 1) continue;
      seen[node[l]] = row + 1;
      if (columns) columns[count] = node[l];
      count++;
    }
  }
  return count;
}

static int compare_ints(const void *a, const void *b) {
  int i = *(const int *)a, j = *(const int *)b;
  return (i > j) - (i < j);
}

Status sparse_from_elements(SparseMatrix *matrix, int n, int n_elements, int nodes_per_element,
                            const int *nodes, Error *error) {
  Status status = STATUS_OK;
  Elements elements = {n_elements, nodes_per_element, nodes, NULL, NULL};
  int *seen = NULL;
  *matrix = (SparseMatrix){.n = n};
  TRY(elements_invert(&elements, n, error));
  TRY(ARRAY_NEW(&seen, n, error));
  TRY(ARRAY_NEW(&matrix->row_start, n + 1, error));
  for (int row = 0; row < n; row++)
    matrix->row_start[row + 1] = matrix->row_start[row] + elements_row(&elements, row, seen, NULL);
  TRY(ARRAY_NEW(&matrix->column, matrix->row_start[n], error));
  TRY(ARRAY_NEW(&matrix->value, matrix->row_start[n], error));
  memset(seen, 0, (size_t)n * sizeof *seen);
  for (int row = 0; row < n; row++) {
    int *columns = &matrix->column[matrix->row_start[row]];
    int count = elements_row(&elements, row, seen, columns);
    qsort(columns, (size_t)count, sizeof *columns, compare_ints);
  }
cleanup:
  array_free(elements.start);
  array_free(elements.around);
  array_free(seen);
  if (status != STATUS_OK) sparse_free(matrix);
  return status;
}

void sparse_free(SparseMatrix *matrix) {
  array_free(matrix->row_start);
  array_free(matrix->column);
  array_free(matrix->value);
  *matrix = (SparseMatrix){0};
}

int sparse_index(const SparseMatrix *matrix, int row, int column) {
  int low = matrix->row_start[row], high = matrix->row_start[row + 1]; /* in [low, high) if anywhere */
  while (low < high) {
    int middle = low + (high - low) / 2;
    if (matrix->column[middle] == column) return middle;
    if (matrix->column[middle] < column)
      low = middle + 1;
    else
      high = middle;
  }
  return -1;
}

void sparse_multiply3(const SparseMatrix *matrix, const double *x, double *y) {
  for (int row = 0; row < matrix->n; row++) {
    double sum[3] = {0.0, 0.0, 0.0};
    for (int k = matrix->row_start[row]; k < matrix->row_start[row + 1]; k++)
      for (int i = 0; i < 3; i++) sum[i] += matrix->value[k] * x[3 * matrix->column[k] + i];
    for (int i = 0; i < 3; i++) y[3 * row + i] = sum[i];
  }
}
