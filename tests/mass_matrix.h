/* The consistent P2 mass matrix of an ellipsoid: a realistic matrix for the tests of the linear solvers. */
#ifndef CAPSELLA_TESTS_MASS_MATRIX_H
#define CAPSELLA_TESTS_MASS_MATRIX_H

#include "base/vec3.h"
#include "linalg/sparse.h"
#include "mesh/p2.h"
#include "mesh/surface.h"
#include <check.h>

/* int N_p N_q dS on the sphere stretched by `axes`, by the 12-point rule; the caller frees it. */
static inline SparseMatrix mass_matrix(int subdivisions, const double axes[3]) {
  Mesh mesh;
  SparseMatrix matrix;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  for (int k = 0; k < 3 * mesh.n_nodes; k++) mesh.X[k] *= axes[k % 3];
  ck_assert_int_eq(
      sparse_from_elements(&matrix, mesh.n_nodes, mesh.n_elements, 6, &mesh.element[0][0], &error),
      STATUS_OK);
  const P2Table table = p2_table(triangle_rule(12));
  for (int e = 0; e < mesh.n_elements; e++)
    for (int g = 0; g < table.n; g++) {
      const int *node = mesh.element[e];
      double a1[3], a2[3], normal[3];
      p2_tangents(mesh.X, node, table.dN[g], a1, a2);
      vec3_cross(a1, a2, normal);
      double weight = table.weight[g] * vec3_norm(normal);
      for (int p = 0; p < 6; p++)
        for (int q = 0; q < 6; q++)
          matrix.value[sparse_index(&matrix, node[p], node[q])] += weight * table.N[g][p] * table.N[g][q];
    }
  mesh_free(&mesh);
  return matrix;
}

#endif
