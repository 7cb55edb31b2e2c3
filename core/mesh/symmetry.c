/* Finds operations by looking up the image of every node in the sorted list of nodes. */
#include "mesh/symmetry.h"

#include "base/array.h"

#include <stdbool.h>
#include <stdlib.h>

/* A node by its position, for sorting and searching. */
typedef struct {
  double x[3];
  int node;
} Place;

static int compare_places(const void *a, const void *b) {
  const Place *p = a, *q = b;
  for (int i = 0; i < 3; i++)
    if (p->x[i] != q->x[i]) return p->x[i] < q->x[i] ? -1 : 1;
  return 0;
}

static Status places_new(Place **places, const Mesh *mesh, const double *x, Error *error) {
  Status status = ARRAY_NEW(places, mesh->n_nodes, error);
  if (status != STATUS_OK) return status;
  for (int p = 0; p < mesh->n_nodes; p++) (*places)[p] = (Place){{x[3 * p], x[3 * p + 1], x[3 * p + 2]}, p};
  qsort(*places, (size_t)mesh->n_nodes, sizeof **places, compare_places);
  return STATUS_OK;
}

/* Whether S takes every node onto a node; fills in operation->node. */
static bool map_nodes(const Mesh *mesh, const double *x, const Place *places, SymmetryOperation *operation) {
  for (int p = 0; p < mesh->n_nodes; p++) {
    Place image = {.node = p};
    for (int i = 0; i < 3; i++) image.x[i] = operation->sign[i] * x[3 * p + i];
    const Place *found = bsearch(&image, places, (size_t)mesh->n_nodes, sizeof *places, compare_places);
    if (!found) return false;
    operation->node[p] = found->node;
  }
  return true;
}

static int local_index(const int element[6], int node) {
  for (int k = 0; k < 6; k++)
    if (element[k] == node) return k;
  return -1;
}

/* Whether the images of the six nodes of element e are those of element f; fills in their places there. */
static bool match_elements(const Mesh *mesh, const SymmetryOperation *operation, int e, int f,
                           unsigned char local[6]) {
  for (int k = 0; k < 6; k++) {
    int index = local_index(mesh->element[f], operation->node[mesh->element[e][k]]);
    if (index < 0) return false;
    local[k] = (unsigned char)index;
  }
  return true;
}

/* Whether S takes every element onto an element; fills in operation->element and operation->local. */
static bool map_elements(const Mesh *mesh, SymmetryOperation *operation) {
  for (int e = 0; e < mesh->n_elements; e++) {
    int corner = operation->node[mesh->element[e][0]];
    bool found = false;
    for (int k = mesh->node_start[corner]; k < mesh->node_start[corner + 1] && !found; k++) {
      int f = mesh->node_element[k];
      operation->element[e] = f;
      found = match_elements(mesh, operation, e, f, operation->local[e]);
    }
    if (!found) return false;
  }
  return true;
}

static Status operation_new(SymmetryOperation *operation, const Mesh *mesh, Error *error) {
  Status status = STATUS_OK;
  TRY(ARRAY_NEW(&operation->node, mesh->n_nodes, error));
  TRY(ARRAY_NEW(&operation->element, mesh->n_elements, error));
  TRY(ARRAY_NEW(&operation->local, mesh->n_elements, error));
cleanup:
  return status;
}

static void operation_free(SymmetryOperation *operation) {
  array_free(operation->node);
  array_free(operation->element);
  array_free(operation->local);
  *operation = (SymmetryOperation){0};
}

/* S G S = G. */
static bool commutes(const double sign[3], const double gradient[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      if (gradient[i][j] != 0.0 && sign[i] != sign[j]) return false;
  return true;
}

static Status find_operations(Symmetry *symmetry, const Mesh *mesh, const double *x,
                              const double gradient[3][3], const Place *places, Error *error) {
  Status status = STATUS_OK;
  for (int code = 0; code < SYMMETRY_MAX; code++) { /* bit i of the code: component i changes sign */
    SymmetryOperation *operation = &symmetry->operation[symmetry->n_operations];
    for (int i = 0; i < 3; i++) operation->sign[i] = code >> i & 1 ? -1.0 : 1.0;
    if (gradient && !commutes(operation->sign, gradient)) continue;
    TRY(operation_new(operation, mesh, error));
    if (map_nodes(mesh, x, places, operation) && map_elements(mesh, operation))
      symmetry->n_operations++;
    else
      operation_free(operation);
  }
cleanup:
  return status;
}

/* Orbits of `count` objects; image[k] is their permutation by operation k. */
static Status orbits_new(Orbits *orbits, int count, int n_operations, const int *const image[],
                         Error *error) {
  Status status = STATUS_OK;
  TRY(ARRAY_NEW(&orbits->representative, count, error));
  TRY(ARRAY_NEW(&orbits->size, count, error));
  TRY(ARRAY_NEW(&orbits->orbit, count, error));
  TRY(ARRAY_NEW(&orbits->operation, count, error));
  for (int i = 0; i < count; i++) orbits->orbit[i] = -1;
  for (int i = 0; i < count; i++) {
    if (orbits->orbit[i] >= 0) continue;
    int orbit = orbits->n++;
    orbits->representative[orbit] = i;
    for (int k = 0; k < n_operations; k++) {
      int member = image[k][i];
      if (orbits->orbit[member] >= 0) continue;
      orbits->orbit[member] = orbit;
      orbits->operation[member] = k;
      orbits->size[orbit]++;
    }
  }
cleanup:
  return status;
}

static void orbits_free(Orbits *orbits) {
  array_free(orbits->representative);
  array_free(orbits->size);
  array_free(orbits->orbit);
  array_free(orbits->operation);
  *orbits = (Orbits){0};
}

static Status find_orbits(Symmetry *symmetry, const Mesh *mesh, Error *error) {
  Status status = STATUS_OK;
  const int *node_image[SYMMETRY_MAX], *element_image[SYMMETRY_MAX];
  for (int k = 0; k < symmetry->n_operations; k++) {
    node_image[k] = symmetry->operation[k].node;
    element_image[k] = symmetry->operation[k].element;
  }
  TRY(orbits_new(&symmetry->nodes, mesh->n_nodes, symmetry->n_operations, node_image, error));
  TRY(orbits_new(&symmetry->elements, mesh->n_elements, symmetry->n_operations, element_image, error));
cleanup:
  return status;
}

Status symmetry_find(Symmetry *symmetry, const Mesh *mesh, const double *x, const double gradient[3][3],
                     Error *error) {
  Status status = STATUS_OK;
  Place *places = NULL;
  *symmetry = (Symmetry){0};
  TRY(places_new(&places, mesh, x, error));
  TRY(find_operations(symmetry, mesh, x, gradient, places, error));
  TRY(find_orbits(symmetry, mesh, error));
cleanup:
  array_free(places);
  if (status != STATUS_OK) symmetry_free(symmetry);
  return status;
}

Status symmetry_none(Symmetry *symmetry, const Mesh *mesh, Error *error) {
  Status status = STATUS_OK;
  SymmetryOperation *identity = &symmetry->operation[0];
  *symmetry = (Symmetry){.n_operations = 1};
  TRY(operation_new(identity, mesh, error));
  for (int i = 0; i < 3; i++) identity->sign[i] = 1.0;
  for (int p = 0; p < mesh->n_nodes; p++) identity->node[p] = p;
  for (int e = 0; e < mesh->n_elements; e++) {
    identity->element[e] = e;
    for (int k = 0; k < 6; k++) identity->local[e][k] = (unsigned char)k;
  }
  TRY(find_orbits(symmetry, mesh, error));
cleanup:
  if (status != STATUS_OK) symmetry_free(symmetry);
  return status;
}

static bool keeps(const SymmetryOperation *operation, const Mesh *mesh, const double *value) {
  for (int e = 0; e < mesh->n_elements; e++)
    if (value[operation->element[e]] != value[e]) return false;
  return true;
}

Status symmetry_keep_field(Symmetry *symmetry, const Mesh *mesh, const double *value, Error *error) {
  int kept = 0;
  for (int k = 0; k < symmetry->n_operations; k++) {
    SymmetryOperation *operation = &symmetry->operation[k];
    if (keeps(operation, mesh, value)) {
      const SymmetryOperation moved = *operation;
      *operation = (SymmetryOperation){0};
      symmetry->operation[kept++] = moved;
    } else {
      operation_free(operation);
    }
  }
  if (kept == symmetry->n_operations) return STATUS_OK;
  symmetry->n_operations = kept;
  orbits_free(&symmetry->nodes);
  orbits_free(&symmetry->elements);
  return find_orbits(symmetry, mesh, error);
}

void symmetry_free(Symmetry *symmetry) {
  for (int k = 0; k < SYMMETRY_MAX; k++) operation_free(&symmetry->operation[k]);
  orbits_free(&symmetry->nodes);
  orbits_free(&symmetry->elements);
  symmetry->n_operations = 0;
}

/* Sets to zero what an operation that leaves node p in place would change there. */
static void project(const Symmetry *symmetry, int p, double value[3]) {
  for (int k = 1; k < symmetry->n_operations; k++) {
    const SymmetryOperation *operation = &symmetry->operation[k];
    if (operation->node[p] != p) continue;
    for (int i = 0; i < 3; i++)
      if (operation->sign[i] < 0.0) value[i] = 0.0;
  }
}

void symmetry_spread(const Symmetry *symmetry, double *field) {
  const Orbits *nodes = &symmetry->nodes;
  for (int orbit = 0; orbit < nodes->n; orbit++) {
    int p = nodes->representative[orbit];
    project(symmetry, p, &field[3 * p]);
    for (int k = 1; k < symmetry->n_operations; k++) {
      const SymmetryOperation *operation = &symmetry->operation[k];
      int member = operation->node[p];
      if (member == p) continue;
      for (int i = 0; i < 3; i++) field[3 * member + i] = operation->sign[i] * field[3 * p + i];
    }
  }
}
