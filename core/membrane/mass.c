#include "membrane/mass.h"

#include "base/array.h"
#include "membrane/assembly.h"
#include "membrane/element_kernel.h"
#include <string.h>

/* The error of the load passes to the velocity, where quadrature leaves 1e-5, in inner stages 1e-3. */
static const double RESIDUAL[] = {[LOAD_FULL] = 1e-10, [LOAD_COARSE] = 1e-6};
enum { MAX_ITERATIONS = 200 };

/* ---- assembled matrices ---- */

/* Fills in the sources of a matrix whose row of node p is row[p] (-1: none); its entries stand in the order
 * of `pattern`, the matrix of all nodes. */
static Status find_sources(AssembledMatrix *assembled, const SparseMatrix *pattern, const int *row,
                           const Mesh *mesh, const Symmetry *symmetry, Error *error) {
  Status status = STATUS_OK;
  const int *row_start = assembled->matrix.row_start;
  const int entries = row_start[assembled->matrix.n];
  int *next = NULL;
  TRY(ARRAY_NEW(&assembled->source_start, entries + 1, error));
  TRY(ARRAY_NEW(&next, entries, error));
  for (int pass = 0; pass < 2; pass++) { /* count, then fill */
    for (int e = 0; e < mesh->n_elements; e++) {
      const ElementImage image = assembly_image(symmetry, e);
      for (int i = 0; i < 36; i++) {
        const int p = mesh->element[e][i / 6], q = mesh->element[e][i % 6];
        if (row[p] < 0) continue;
        const int k = row_start[row[p]] + sparse_index(pattern, p, q) - pattern->row_start[p];
        const int a = image.local[i / 6], b = image.local[i % 6];
        const int pair = a <= b ? mass_pair(a, b) : mass_pair(b, a);
        if (pass == 0)
          assembled->source_start[k + 1]++;
        else
          assembled->source[next[k]++] = pair * symmetry->elements.n + image.orbit;
      }
    }
    if (pass == 1) break;
    for (int k = 0; k < entries; k++) {
      assembled->source_start[k + 1] += assembled->source_start[k];
      next[k] = assembled->source_start[k];
    }
    TRY(ARRAY_NEW(&assembled->source, assembled->source_start[entries], error));
  }
cleanup:
  array_free(next);
  return status;
}

static void assembled_free(AssembledMatrix *assembled) {
  sparse_free(&assembled->matrix);
  array_free(assembled->source_start);
  array_free(assembled->source);
  *assembled = (AssembledMatrix){0};
}

static void assemble(AssembledMatrix *assembled, const double *element_mass) {
  const int entries = assembled->matrix.row_start[assembled->matrix.n];
  for (int k = 0; k < entries; k++) {
    double sum = 0;
    for (int s = assembled->source_start[k]; s < assembled->source_start[k + 1]; s++)
      sum += element_mass[assembled->source[s]];
    assembled->matrix.value[k] = sum;
  }
}

static Status full_pattern(SparseMatrix *pattern, const Mesh *mesh, Error *error) {
  return sparse_from_elements(pattern, mesh->n_nodes, mesh->n_elements, 6, mesh->element[0], error);
}

/* ---- conjugate gradients on one node of each orbit ---- */

/* Rows of the representatives, columns as orbits and operations. */
static Status reduce_pattern(MassSystem *mass, const SparseMatrix *pattern, Error *error) {
  Status status = STATUS_OK;
  const Orbits *nodes = &mass->symmetry->nodes;
  SparseMatrix *matrix = &mass->reduced.matrix;
  matrix->n = nodes->n;
  TRY(ARRAY_NEW(&matrix->row_start, nodes->n + 1, error));
  for (int i = 0; i < nodes->n; i++) {
    const int p = nodes->representative[i];
    matrix->row_start[i + 1] = matrix->row_start[i] + pattern->row_start[p + 1] - pattern->row_start[p];
  }
  TRY(ARRAY_NEW(&matrix->column, matrix->row_start[nodes->n], error));
  TRY(ARRAY_NEW(&matrix->value, matrix->row_start[nodes->n], error));
  TRY(ARRAY_NEW(&mass->operation, matrix->row_start[nodes->n], error));
  TRY(ARRAY_NEW(&mass->weight, nodes->n, error));
  TRY(ARRAY_NEW(&mass->diagonal, nodes->n, error));
  for (int i = 0; i < nodes->n; i++) {
    const int p = nodes->representative[i], offset = matrix->row_start[i] - pattern->row_start[p];
    mass->weight[i] = nodes->size[i];
    mass->diagonal[i] = offset + sparse_index(pattern, p, p);
    for (int k = pattern->row_start[p]; k < pattern->row_start[p + 1]; k++) {
      matrix->column[k + offset] = nodes->orbit[pattern->column[k]];
      mass->operation[k + offset] = (unsigned char)nodes->operation[pattern->column[k]];
    }
  }
  mass->images =
      (SparseImages){.operation = mass->operation, .weight = mass->weight, .diagonal = mass->diagonal};
  for (int k = 0; k < mass->symmetry->n_operations; k++)
    memcpy(mass->images.sign[k], mass->symmetry->operation[k].sign, sizeof mass->symmetry->operation[k].sign);
cleanup:
  return status;
}

static Status build_reduced(MassSystem *mass, Error *error) {
  Status status = STATUS_OK;
  const Orbits *nodes = &mass->symmetry->nodes;
  SparseMatrix pattern = {0};
  int *row = NULL;
  TRY(full_pattern(&pattern, mass->mesh, error));
  TRY(reduce_pattern(mass, &pattern, error));
  TRY(ARRAY_NEW(&row, mass->mesh->n_nodes, error));
  for (int p = 0; p < mass->mesh->n_nodes; p++)
    row[p] = nodes->representative[nodes->orbit[p]] == p ? nodes->orbit[p] : -1;
  TRY(find_sources(&mass->reduced, &pattern, row, mass->mesh, mass->symmetry, error));
  TRY(pcg_work_new(&mass->work, nodes->n, error));
  TRY(ARRAY_NEW(&mass->b, 3 * (size_t)nodes->n, error));
  TRY(ARRAY_NEW(&mass->x, 3 * (size_t)nodes->n, error));
cleanup:
  sparse_free(&pattern);
  array_free(row);
  return status;
}

static void take_representatives(const Orbits *nodes, const double *field, double *reduced) {
  for (int i = 0; i < nodes->n; i++)
    memcpy(reduced + 3 * i, field + 3 * (ptrdiff_t)nodes->representative[i], 3 * sizeof *field);
}

static Status solve_iteratively(MassSystem *mass, LoadAccuracy accuracy, const double *R, double *q,
                                Error *error) {
  const Orbits *nodes = &mass->symmetry->nodes;
  assemble(&mass->reduced, mass->element_mass);
  take_representatives(nodes, R, mass->b);
  take_representatives(nodes, q, mass->x);
  int iterations = 0;
  const SparseImages *images = mass->symmetry->n_operations > 1 ? &mass->images : NULL;
  const Status status = pcg_solve3_images(&mass->reduced.matrix, images, mass->b, mass->x, RESIDUAL[accuracy],
                                          MAX_ITERATIONS, &mass->work, &iterations, error);
  mass->iterations += iterations;
  if (status != STATUS_OK) return status;
  for (int i = 0; i < nodes->n; i++)
    memcpy(q + 3 * (ptrdiff_t)nodes->representative[i], mass->x + 3 * i, 3 * sizeof *q);
  symmetry_spread(mass->symmetry, q);
  return STATUS_OK;
}

/* ---- direct solution on all nodes ---- */

static Status build_full(MassSystem *mass, Error *error) {
  Status status = STATUS_OK;
  int *row = NULL;
  TRY(full_pattern(&mass->full.matrix, mass->mesh, error));
  TRY(ARRAY_NEW(&row, mass->mesh->n_nodes, error));
  for (int p = 0; p < mass->mesh->n_nodes; p++) row[p] = p;
  TRY(find_sources(&mass->full, &mass->full.matrix, row, mass->mesh, mass->symmetry, error));
  TRY(direct_new(&mass->direct, &mass->full.matrix, error));
cleanup:
  array_free(row);
  return status;
}

static Status solve_directly(MassSystem *mass, const double *R, double *q, Error *error) {
  Status status = STATUS_OK;
  if (!mass->direct) TRY(build_full(mass, error));
  assemble(&mass->full, mass->element_mass);
  TRY(direct_factor(mass->direct, error));
  TRY(direct_solve3(mass->direct, R, q, error));
cleanup:
  return status;
}

/* ---- the system ---- */

Status mass_new(MassSystem *mass, const Mesh *mesh, const Symmetry *symmetry, MassSolver solver,
                Error *error) {
  Status status = STATUS_OK;
  *mass = (MassSystem){.mesh = mesh, .symmetry = symmetry, .solver = solver};
  TRY(solver == MASS_PCG ? build_reduced(mass, error) : build_full(mass, error));
cleanup:
  if (status != STATUS_OK) mass_free(mass);
  return status;
}

void mass_free(MassSystem *mass) {
  direct_free(mass->direct);
  assembled_free(&mass->full);
  assembled_free(&mass->reduced);
  pcg_work_free(&mass->work);
  array_free(mass->operation);
  array_free(mass->weight);
  array_free(mass->diagonal);
  array_free(mass->b);
  array_free(mass->x);
  *mass = (MassSystem){0};
}

void mass_update(MassSystem *mass, const double *element_mass) {
  mass->element_mass = element_mass;
}

Status mass_solve(MassSystem *mass, LoadAccuracy accuracy, const double *R, double *q, Error *error) {
  if (mass->solver == MASS_UMFPACK) return solve_directly(mass, R, q, error);
  Status status = solve_iteratively(mass, accuracy, R, q, error);
#ifdef CAPSELLA_UMFPACK
  if (status == STATUS_REJECT) status = solve_directly(mass, R, q, error);
#endif
  return status;
}
