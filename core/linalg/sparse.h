/* Sparse matrix with sorted rows (CSR) and one value array; the pattern is made once, the values change. */
#ifndef CAPSELLA_LINALG_SPARSE_H
#define CAPSELLA_LINALG_SPARSE_H

#include "base/status.h"

typedef struct {
  int n;
  int *row_start; /* [n + 1] */
  int *column;    /* [row_start[n]], rising within a row (not when there are images) */
  double *value;  /* [row_start[n]] */
} SparseMatrix;

/* A matrix that acts on vector fields with a symmetry, written on one node of each orbit only: entry k of a
 * row multiplies not x[column[k]] but its image sign[operation[k]] * x[column[k]], component by component;
 * and a node counts in sums over nodes as often as its orbit has members. */
typedef struct {
  const unsigned char *operation; /* [row_start[n]] */
  double sign[8][4];              /* of components 0..2; the fourth is padding */
  const double *weight;           /* [n] size of the orbit */
  const int *diagonal;            /* [n] index of the entry of the node with itself */
} SparseImages;

/* Pattern of a finite-element matrix: rows i and j are joined when an element holds both.
 * nodes [n_elements][nodes_per_element].  Values start at zero. */
Status sparse_from_elements(SparseMatrix *matrix, int n, int n_elements, int nodes_per_element,
                            const int *nodes, Error *error);
void sparse_free(SparseMatrix *matrix);

/* Index into `value` of entry (row, column), or -1 when it is not in the pattern. */
int sparse_index(const SparseMatrix *matrix, int row, int column);

/* y = A x for three right-hand sides at once: x, y [n][3]. */
void sparse_multiply3(const SparseMatrix *matrix, const double *x, double *y);

#endif
