#include "run/parameter_cells.h"

#include "base/array.h"

/* `at_orbit` [n_orbits] are the values at the computed elements; the others have those of their images. */
static Status add(ParameterCells *cells, const char *role, const char *name, const double *at_orbit,
                  const Simulation *s, Error *error) {
  Status status;
  Text full_name = {0};
  double *values = NULL;
  SnapshotCells *cell = &cells->cells[cells->n];
  TRY(text_append(&full_name, error, "%s_%s", role, name));
  TRY(ARRAY_NEW(&values, s->mesh.n_elements, error));
  for (int e = 0; e < s->mesh.n_elements; e++) values[e] = at_orbit[s->symmetry.elements.orbit[e]];
  *cell = (SnapshotCells){.name = text_copy(full_name.data, error), .values = values};
  cells->n++;
  if (!cell->name) status = error->code;
cleanup:
  text_free(&full_name);
  return status;
}

static Status add_law(ParameterCells *cells, const char *role, const LoadedLaw *law,
                      const ParameterValues *values, const Simulation *s, Error *error) {
  Status status = STATUS_OK;
  if (!values->varies) return status;
  const LawDescription table = law_describe(law);
  for (uint32_t k = 0; k < values->n; k++)
    if (values->element[k]) TRY(add(cells, role, law_param(&table, k)->name, values->element[k], s, error));
cleanup:
  return status;
}

Status parameter_cells_new(ParameterCells *cells, const Simulation *s, Error *error) {
  Status status;
  const Material *material = &s->material;
  *cells = (ParameterCells){0};
  TRY(ARRAY_NEW(&cells->cells, material->elastic_values.n + material->damage_values.n, error));
  TRY(add_law(cells, "elastic", &material->elastic, &material->elastic_values, s, error));
  TRY(add_law(cells, "damage", &material->damage, &material->damage_values, s, error));
cleanup:
  if (status != STATUS_OK) parameter_cells_free(cells);
  return status;
}

void parameter_cells_free(ParameterCells *cells) {
  for (size_t i = 0; i < cells->n; i++) {
    array_free((void *)(uintptr_t)cells->cells[i].name);
    array_free((void *)(uintptr_t)cells->cells[i].values);
  }
  array_free(cells->cells);
  *cells = (ParameterCells){0};
}
