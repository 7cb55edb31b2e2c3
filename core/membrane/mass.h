/* The consistent mass matrix M (paper eq. 3.1) on the current surface, and M q = R, on one node of each orbit
 * of the symmetry. */
#ifndef CAPSELLA_MEMBRANE_MASS_H
#define CAPSELLA_MEMBRANE_MASS_H

#include "base/status.h"
#include "config/scene.h"
#include "linalg/direct.h"
#include "linalg/pcg.h"
#include "linalg/sparse.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

/* A matrix, and which element values make up each of its entries: those at source_start[k] ..
 * source_start[k+1]-1 of `source` index the table [21][n_orbits] of element masses, in a fixed order. */
typedef struct {
  SparseMatrix matrix;
  int *source_start, *source;
} AssembledMatrix;

typedef struct {
  const Mesh *mesh;
  const Symmetry *symmetry;
  MassSolver solver;
  const double *element_mass; /* of the last mass_update; [21][n_orbits] */

  /* Conjugate gradients, on one node of each orbit. */
  AssembledMatrix reduced;
  SparseImages images;
  unsigned char *operation; /* arrays that `images` points to */
  double *weight;
  int *diagonal;
  PcgWork work;
  double *b, *x; /* [n_orbits][3] */

  /* Direct solution, on all nodes: made when it is chosen, or when conjugate gradients stall. */
  AssembledMatrix full;
  DirectSolver *direct;

  long long iterations; /* of the conjugate gradients so far */
} MassSystem;

/* Mesh and symmetry must outlive the system. */
Status mass_new(MassSystem *mass, const Mesh *mesh, const Symmetry *symmetry, MassSolver solver,
                Error *error);
void mass_free(MassSystem *mass);

/* Takes new element masses [21][n_orbits] (element_kernel.h), which must live until the last mass_solve with
 * them. */
void mass_update(MassSystem *mass, const double *element_mass);

/* Relative residual of the conjugate gradients: 1e-10, or 1e-6 for the inner stages of a step. */
typedef enum { LOAD_FULL, LOAD_COARSE } LoadAccuracy;

/* M q = R; R, q [n_nodes][3]; q holds the start of the iteration on entry.  Falls back to the direct solver
 * when conjugate gradients stall on a distorted mesh. */
Status mass_solve(MassSystem *mass, LoadAccuracy accuracy, const double *R, double *q, Error *error);

#endif
