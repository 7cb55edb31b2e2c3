#include "membrane/mass.h"

#include "base/array.h"
#include "membrane/element_kernel.h"

/* Relative residual of the load.  Its error passes to the velocity, where quadrature alone leaves 1e-5. */
static const double TOLERANCE = 1e-10;
enum { MAX_ITERATIONS = 200 };

static Status build_sources(MassSystem *mass, const Mesh *mesh, Error *error) {
  Status status = STATUS_OK;
  const int entries = mass->matrix.row_start[mass->matrix.n];
  TRY(ARRAY_NEW(&mass->source_start, entries + 1, error));
  TRY(ARRAY_NEW(&mass->source, 36 * (size_t)mesh->n_elements, error));
  for (int pass = 0; pass < 2; pass++) { /* count, then fill */
    for (int e = 0; e < mesh->n_elements; e++)
      for (int p = 0; p < 6; p++)
        for (int q = 0; q < 6; q++) {
          const int k = sparse_index(&mass->matrix, mesh->element[e][p], mesh->element[e][q]);
          if (pass == 0) {
            mass->source_start[k + 1]++;
          } else {
            const int pair = p <= q ? mass_pair(p, q) : mass_pair(q, p);
            mass->source[mass->source_start[k]++] = pair * mesh->n_elements + e;
          }
        }
    if (pass == 0) {
      for (int k = 0; k < entries; k++) mass->source_start[k + 1] += mass->source_start[k];
    } else { /* filling moved each start to the next one */
      for (int k = entries; k > 0; k--) mass->source_start[k] = mass->source_start[k - 1];
      mass->source_start[0] = 0;
    }
  }
cleanup:
  return status;
}

Status mass_new(MassSystem *mass, const Mesh *mesh, MassSolver solver, Error *error) {
  Status status = STATUS_OK;
  *mass = (MassSystem){.solver = solver};
  TRY(sparse_from_elements(&mass->matrix, mesh->n_nodes, mesh->n_elements, 6, mesh->element[0], error));
  TRY(build_sources(mass, mesh, error));
  if (solver == MASS_UMFPACK) TRY(direct_new(&mass->direct, &mass->matrix, error));
  if (solver == MASS_PCG) TRY(pcg_work_new(&mass->work, mesh->n_nodes, error));
cleanup:
  if (status != STATUS_OK) mass_free(mass);
  return status;
}

void mass_free(MassSystem *mass) {
  direct_free(mass->direct);
  pcg_work_free(&mass->work);
  array_free(mass->source);
  array_free(mass->source_start);
  sparse_free(&mass->matrix);
  *mass = (MassSystem){0};
}

void mass_assemble(MassSystem *mass, const double *element_mass) {
  const int entries = mass->matrix.row_start[mass->matrix.n];
#pragma omp parallel for schedule(static)
  for (int k = 0; k < entries; k++) {
    double sum = 0;
    for (int s = mass->source_start[k]; s < mass->source_start[k + 1]; s++)
      sum += element_mass[mass->source[s]];
    mass->matrix.value[k] = sum;
  }
}

static Status solve_directly(MassSystem *mass, const double *R, double *q, Error *error) {
  Status status = STATUS_OK;
  if (!mass->direct) TRY(direct_new(&mass->direct, &mass->matrix, error));
  TRY(direct_factor(mass->direct, error));
  mass->factorizations++;
  TRY(direct_solve3(mass->direct, R, q, error));
cleanup:
  return status;
}

Status mass_solve(MassSystem *mass, const double *R, double *q, Error *error) {
  if (mass->solver == MASS_UMFPACK) return solve_directly(mass, R, q, error);
  int iterations = 0;
  Status status = pcg_solve3(&mass->matrix, R, q, TOLERANCE, MAX_ITERATIONS, &mass->work, &iterations, error);
  mass->iterations += iterations;
#ifdef CAPSELLA_UMFPACK
  if (status == STATUS_REJECT) status = solve_directly(mass, R, q, error);
#endif
  return status;
}
