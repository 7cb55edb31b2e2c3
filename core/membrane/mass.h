/* The consistent mass matrix M (paper eq. 3.1) on the current surface, and M q = R. */
#ifndef CAPSELLA_MEMBRANE_MASS_H
#define CAPSELLA_MEMBRANE_MASS_H

#include "base/status.h"
#include "config/scene.h"
#include "linalg/direct.h"
#include "linalg/pcg.h"
#include "linalg/sparse.h"
#include "mesh/mesh.h"

typedef struct {
  SparseMatrix matrix;
  /* Which element values make up each entry of the matrix: entries source_start[k] .. source_start[k+1]-1 of
   * `source` index the table [21][n_elements] of element masses, in a fixed order. */
  int *source_start, *source;
  MassSolver solver;
  PcgWork work;
  DirectSolver *direct; /* made when it is chosen, or when conjugate gradients stall */
  long long iterations; /* of the conjugate gradients so far */
  long long factorizations;
} MassSystem;

Status mass_new(MassSystem *mass, const Mesh *mesh, MassSolver solver, Error *error);
void mass_free(MassSystem *mass);

/* Sums the element masses [21][n_elements] (element_kernel.h) into the matrix. */
void mass_assemble(MassSystem *mass, const double *element_mass);

/* M q = R; R, q [n_nodes][3]; q holds the start of the iteration on entry.  Falls back to the direct solver
 * when conjugate gradients stall on a distorted mesh. */
Status mass_solve(MassSystem *mass, const double *R, double *q, Error *error);

#endif
