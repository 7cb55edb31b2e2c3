/* Volume, area and normals of a closed P2 surface by the triangle rules.  Sums run over the elements in their
 * order, so that results do not depend on the number of threads. */
#include "mesh/surface.h"

#include "base/vec3.h"
#include "mesh/p2.h"

#include <string.h>

enum {
  VOLUME_POINTS = 6, /* degree 4: exact for the volume and its gradient */
  AREA_POINTS = 12,  /* not polynomial: the rule's error stays below that of the P2 geometry */
};

double surface_flux(const Mesh *mesh, const Symmetry *symmetry, const double *x, const double *v) {
  const P2Table table = p2_table(triangle_rule(VOLUME_POINTS));
  const int count = symmetry ? symmetry->elements.n : mesh->n_elements;
  double sum = 0.0;
  for (int i = 0; i < count; i++) {
    const int *node = mesh->element[symmetry ? symmetry->elements.representative[i] : i];
    double flux = 0.0;
    for (int g = 0; g < table.n; g++) {
      double value[3], a1[3], a2[3], normal[3];
      p2_interpolate(v, node, table.N[g], value);
      p2_tangents(x, node, table.dN[g], a1, a2);
      vec3_cross(a1, a2, normal);
      flux += table.weight[g] * vec3_dot(value, normal);
    }
    sum += symmetry ? symmetry->elements.size[i] * flux : flux;
  }
  return sum;
}

double surface_volume(const Mesh *mesh, const double *x) {
  return surface_flux(mesh, NULL, x, x) / 3.0;
}

double surface_area(const Mesh *mesh, const double *x) {
  const P2Table table = p2_table(triangle_rule(AREA_POINTS));
  double sum = 0.0;
  for (int e = 0; e < mesh->n_elements; e++)
    for (int g = 0; g < table.n; g++) {
      double a1[3], a2[3], normal[3];
      p2_tangents(x, mesh->element[e], table.dN[g], a1, a2);
      vec3_cross(a1, a2, normal);
      sum += table.weight[g] * vec3_norm(normal);
    }
  return sum;
}

void surface_area_vectors(const Mesh *mesh, const double *x, double *A) {
  const P2Table table = p2_table(triangle_rule(VOLUME_POINTS));
  memset(A, 0, 3 * (size_t)mesh->n_nodes * sizeof *A);
  for (int e = 0; e < mesh->n_elements; e++) {
    const int *node = mesh->element[e];
    for (int g = 0; g < table.n; g++) {
      double a1[3], a2[3], normal[3];
      p2_tangents(x, node, table.dN[g], a1, a2);
      vec3_cross(a1, a2, normal);
      for (int k = 0; k < 6; k++)
        for (int i = 0; i < 3; i++) A[3 * node[k] + i] += table.weight[g] * table.N[g][k] * normal[i];
    }
  }
}

/* Shape functions at the nodes of an element. */
static P2Table node_table(void) {
  static const double weight[6] = {0.0, 0.0, 0.0, 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0};
  static const TriangleRule nodes = {.n = 6, .degree = 2, .point = p2_node, .weight = weight};
  return p2_table(&nodes);
}

static void node_normal(const Mesh *mesh, const P2Table *table, const double *x, int p, double n[3]) {
  for (int i = 0; i < 3; i++) n[i] = 0.0;
  for (int k = mesh->node_start[p]; k < mesh->node_start[p + 1]; k++) {
    double a1[3], a2[3], normal[3];
    p2_tangents(x, mesh->element[mesh->node_element[k]], table->dN[mesh->node_local[k]], a1, a2);
    vec3_cross(a1, a2, normal);
    for (int i = 0; i < 3; i++) n[i] += normal[i];
  }
  vec3_normalize(n);
}

void surface_orbit_normals(const Mesh *mesh, const Symmetry *symmetry, const double *x, double *n) {
  const P2Table table = node_table();
  if (!symmetry) {
    for (int p = 0; p < mesh->n_nodes; p++) node_normal(mesh, &table, x, p, &n[3 * p]);
    return;
  }
  for (int i = 0; i < symmetry->nodes.n; i++) {
    const int p = symmetry->nodes.representative[i];
    node_normal(mesh, &table, x, p, &n[3 * p]);
  }
  symmetry_spread(symmetry, n);
}

void surface_normals(const Mesh *mesh, const double *x, double *n) {
  surface_orbit_normals(mesh, NULL, x, n);
}
