#include "membrane/assembly.h"

#include "base/array.h"

ElementImage assembly_image(const Symmetry *symmetry, int element) {
  const Orbits *elements = &symmetry->elements;
  ElementImage image = {.orbit = elements->orbit[element], .operation = elements->operation[element]};
  const unsigned char *onto =
      symmetry->operation[image.operation].local[elements->representative[image.orbit]];
  for (unsigned char k = 0; k < 6; k++) image.local[onto[k]] = k;
  return image;
}

Status assembly_new(Assembly *assembly, const Mesh *mesh, const Symmetry *symmetry, Error *error) {
  Status status = STATUS_OK;
  *assembly = (Assembly){.symmetry = symmetry};
  const Orbits *nodes = &symmetry->nodes;
  TRY(ARRAY_NEW(&assembly->start, nodes->n + 1, error));
  for (int i = 0; i < nodes->n; i++) {
    const int p = nodes->representative[i];
    assembly->start[i + 1] = assembly->start[i] + mesh->node_start[p + 1] - mesh->node_start[p];
  }
  TRY(ARRAY_NEW(&assembly->term, assembly->start[nodes->n], error));
  for (int i = 0; i < nodes->n; i++) {
    const int first = mesh->node_start[nodes->representative[i]];
    for (int s = assembly->start[i]; s < assembly->start[i + 1]; s++) {
      const int k = first + s - assembly->start[i];
      const ElementImage image = assembly_image(symmetry, mesh->node_element[k]);
      assembly->term[s] = (AssemblyTerm){.orbit = image.orbit,
                                         .local = image.local[mesh->node_local[k]],
                                         .operation = (unsigned char)image.operation};
    }
  }
cleanup:
  if (status != STATUS_OK) assembly_free(assembly);
  return status;
}

void assembly_free(Assembly *assembly) {
  array_free(assembly->start);
  array_free(assembly->term);
  *assembly = (Assembly){0};
}

void assembly_sum(const Assembly *assembly, const double *element_force, double *R) {
  const Symmetry *symmetry = assembly->symmetry;
  const size_t ld = (size_t)symmetry->elements.n;
  for (int i = 0; i < symmetry->nodes.n; i++) {
    double sum[3] = {0, 0, 0};
    for (int s = assembly->start[i]; s < assembly->start[i + 1]; s++) {
      const AssemblyTerm *term = &assembly->term[s];
      const double *f = element_force + 3 * term->local * ld + (size_t)term->orbit;
      const double *sign = symmetry->operation[term->operation].sign;
      for (size_t c = 0; c < 3; c++) sum[c] += sign[c] * f[c * ld];
    }
    for (int c = 0; c < 3; c++) R[3 * symmetry->nodes.representative[i] + c] = sum[c];
  }
  symmetry_spread(symmetry, R);
}
