/* The icosphere: an icosahedron halved again and again, every new vertex projected on the unit sphere.
 *
 * Meshes are nested.  The vertices of level n keep their numbers on level n + 1, and the mid-edge nodes of a
 * mesh are the vertices that the next halving adds, so that node p of a mesh is node p of every finer one.
 * The four children of element e are elements 4 e .. 4 e + 3.
 *
 * Mirroring in a coordinate plane maps the nodes onto nodes bit for bit: the corners of the icosahedron are
 * mirrored exactly, and the normalised sum of two vectors treats the signs of their components alike. */
#include "mesh/mesh.h"

#include "base/array.h"
#include "base/random.h"
#include "base/vec3.h"
#include "mesh/surface.h"

#include <stdbool.h>
#include <string.h>

enum { MAX_SUBDIVISIONS = 7, ICOSAHEDRON_VERTICES = 12, ICOSAHEDRON_FACES = 20, MAX_VALENCE = 6 };

/* Faces of the icosahedron, outward, each next to the one before it. */
static const int icosahedron_face[ICOSAHEDRON_FACES][3] = {
    {0, 1, 4},   {0, 6, 1},  {0, 9, 6},  {0, 8, 9},   {0, 4, 8},  {4, 5, 8},  {2, 8, 5},
    {2, 5, 3},   {2, 3, 7},  {3, 11, 7}, {3, 10, 11}, {3, 5, 10}, {4, 10, 5}, {1, 10, 4},
    {1, 11, 10}, {1, 6, 11}, {6, 7, 11}, {6, 9, 7},   {2, 7, 9},  {2, 9, 8},
};

/* Vertex 4 i + k has component i zero, i + 1 equal to +-1 and i + 2 equal to +-golden ratio, before scaling:
 * the 2-fold axes lie on x, y, z. */
static void icosahedron_vertex(int vertex, double X[3]) {
  const double golden = 0.5 * (1.0 + sqrt(5.0));
  int axis = vertex / 4;
  X[axis] = 0.0;
  X[(axis + 1) % 3] = vertex & 1 ? -1.0 : 1.0;
  X[(axis + 2) % 3] = vertex & 2 ? -golden : golden;
  vec3_normalize(X);
}

static int vertex_count(int subdivisions) {
  return 10 * (1 << (2 * subdivisions)) + 2;
}

static int element_count(int subdivisions) {
  return 20 * (1 << (2 * subdivisions));
}

/* Midpoints made so far in one halving, found by the edge's ends: slots of the end with the lower number. */
typedef struct {
  double *X; /* vertices old and new */
  int n_vertices;
  int (*end)[MAX_VALENCE]; /* the other end + 1; 0 marks a free slot */
  int (*midpoint)[MAX_VALENCE];
} Halving;

static int edge_midpoint(Halving *halving, int a, int b) {
  int low = a < b ? a : b, high = a < b ? b : a;
  int slot = 0;
  while (halving->end[low][slot] != 0) {
    if (halving->end[low][slot] == high + 1) return halving->midpoint[low][slot];
    slot++;
  }
  int midpoint = halving->n_vertices++;
  for (int i = 0; i < 3; i++) halving->X[3 * midpoint + i] = halving->X[3 * a + i] + halving->X[3 * b + i];
  vec3_normalize(&halving->X[3 * midpoint]);
  halving->end[low][slot] = high + 1;
  halving->midpoint[low][slot] = midpoint;
  return midpoint;
}

/* Makes the midpoints of all edges and fills in the mid-edge nodes of the elements. */
static Status mesh_add_midpoints(Mesh *mesh, int n_vertices, int n_elements, Error *error) {
  Status status = STATUS_OK;
  Halving halving = {.X = mesh->X, .n_vertices = n_vertices};
  TRY(ARRAY_NEW(&halving.end, n_vertices, error));
  TRY(ARRAY_NEW(&halving.midpoint, n_vertices, error));
  for (int e = 0; e < n_elements; e++) {
    int *node = mesh->element[e];
    for (int k = 0; k < 3; k++) node[3 + k] = edge_midpoint(&halving, node[k], node[(k + 1) % 3]);
  }
cleanup:
  array_free(halving.end);
  array_free(halving.midpoint);
  return status;
}

/* Replaces each element by its four children, from the last element down so that none is overwritten early.
 */
static void mesh_split_elements(Mesh *mesh, int n_elements) {
  for (int e = n_elements - 1; e >= 0; e--) {
    int n[6];
    memcpy(n, mesh->element[e], sizeof n);
    const int child[4][3] = {{n[0], n[3], n[5]}, {n[3], n[1], n[4]}, {n[5], n[4], n[2]}, {n[3], n[4], n[5]}};
    for (int k = 0; k < 4; k++) memcpy(mesh->element[4 * e + k], child[k], sizeof child[k]);
  }
}

static Status mesh_fill_tables(Mesh *mesh, Error *error) {
  Status status = STATUS_OK;
  int *next = NULL; /* [n_nodes] where the next entry of a node goes */
  TRY(ARRAY_NEW(&next, mesh->n_nodes, error));
  for (int e = 0; e < mesh->n_elements; e++)
    for (int k = 0; k < 6; k++) mesh->node_start[mesh->element[e][k] + 1]++;
  for (int p = 0; p < mesh->n_nodes; p++) {
    mesh->node_start[p + 1] += mesh->node_start[p];
    next[p] = mesh->node_start[p];
  }
  for (int e = 0; e < mesh->n_elements; e++)
    for (int k = 0; k < 6; k++) {
      int entry = next[mesh->element[e][k]]++;
      mesh->node_element[entry] = e;
      mesh->node_local[entry] = k;
    }
cleanup:
  array_free(next);
  return status;
}

/* Rodrigues' formula. */
static Status mesh_rotate(Mesh *mesh, const MeshRotation *rotation, Error *error) {
  double axis[3] = {rotation->axis[0], rotation->axis[1], rotation->axis[2]};
  double length = vec3_normalize(axis);
  if (!(length > 0.0) || !isfinite(length) || !isfinite(rotation->angle))
    return error_set(error, STATUS_INPUT,
                     "mesh rotation: expected an axis of positive length and a finite angle, found axis "
                     "(%g, %g, %g) and angle %g",
                     rotation->axis[0], rotation->axis[1], rotation->axis[2], rotation->angle);
  double cosine = cos(rotation->angle), sine = sin(rotation->angle);
  for (int p = 0; p < mesh->n_nodes; p++) {
    double *X = &mesh->X[3 * p], cross[3];
    vec3_cross(axis, X, cross);
    double along = vec3_dot(axis, X);
    for (int i = 0; i < 3; i++) X[i] = cosine * X[i] + sine * cross[i] + (1.0 - cosine) * along * axis[i];
  }
  return STATUS_OK;
}

Status mesh_sphere(Mesh *mesh, int subdivisions, const MeshRotation *rotation, Error *error) {
  *mesh = (Mesh){.subdivisions = subdivisions};
  if (subdivisions < 0 || subdivisions > MAX_SUBDIVISIONS)
    return error_set(error, STATUS_INPUT, "mesh: expected 0 to %d subdivisions of the icosahedron, found %d",
                     MAX_SUBDIVISIONS, subdivisions);
  mesh->n_vertices = vertex_count(subdivisions);
  mesh->n_nodes = vertex_count(subdivisions + 1);
  mesh->n_elements = element_count(subdivisions);

  Status status = STATUS_OK;
  TRY(ARRAY_NEW(&mesh->X, 3 * (size_t)mesh->n_nodes, error));
  TRY(ARRAY_NEW(&mesh->element, mesh->n_elements, error));
  TRY(ARRAY_NEW(&mesh->node_start, mesh->n_nodes + 1, error));
  TRY(ARRAY_NEW(&mesh->node_element, 6 * (size_t)mesh->n_elements, error));
  TRY(ARRAY_NEW(&mesh->node_local, 6 * (size_t)mesh->n_elements, error));

  for (int v = 0; v < ICOSAHEDRON_VERTICES; v++) icosahedron_vertex(v, &mesh->X[3 * v]);
  for (int f = 0; f < ICOSAHEDRON_FACES; f++)
    memcpy(mesh->element[f], icosahedron_face[f], sizeof icosahedron_face[f]);
  for (int level = 0; level < subdivisions; level++) {
    TRY(mesh_add_midpoints(mesh, vertex_count(level), element_count(level), error));
    mesh_split_elements(mesh, element_count(level));
  }
  TRY(mesh_add_midpoints(mesh, mesh->n_vertices, mesh->n_elements, error));
  TRY(mesh_fill_tables(mesh, error));
  if (rotation && rotation->angle != 0.0) TRY(mesh_rotate(mesh, rotation, error));
cleanup:
  if (status != STATUS_OK) mesh_free(mesh);
  return status;
}

void mesh_jitter(Mesh *mesh, double share, int seed) {
  const double reach = share * mesh_edge_length(mesh, mesh->X);
  uint64_t state = (uint64_t)seed;
  for (int v = 0; v < mesh->n_vertices; v++) {
    for (int i = 0; i < 3; i++) {
      state = random_mix(state);
      mesh->X[3 * v + i] += reach * random_symmetric(state);
    }
    vec3_normalize(&mesh->X[3 * v]);
  }
  for (int e = 0; e < mesh->n_elements; e++)
    for (int k = 0; k < 3; k++) {
      const int *node = mesh->element[e];
      const double *a = &mesh->X[3 * node[k]], *b = &mesh->X[3 * node[(k + 1) % 3]];
      double *middle = &mesh->X[3 * node[3 + k]];
      for (int i = 0; i < 3; i++) middle[i] = a[i] + b[i];
      vec3_normalize(middle);
    }
}

void mesh_free(Mesh *mesh) {
  array_free(mesh->X);
  array_free(mesh->element);
  array_free(mesh->node_start);
  array_free(mesh->node_element);
  array_free(mesh->node_local);
  *mesh = (Mesh){0};
}

/* Whether exactly two elements hold mid-edge node m, and run through its edge in opposite senses. */
static bool edge_is_closed(const Mesh *mesh, int m) {
  int first = mesh->node_start[m];
  if (mesh->node_start[m + 1] - first != 2) return false;
  int end[2][2];
  for (int side = 0; side < 2; side++) {
    int edge = mesh->node_local[first + side] - 3;
    if (edge < 0) return false;
    const int *node = mesh->element[mesh->node_element[first + side]];
    end[side][0] = node[edge];
    end[side][1] = node[(edge + 1) % 3];
  }
  return end[0][0] == end[1][1] && end[0][1] == end[1][0];
}

Status mesh_check(const Mesh *mesh, Error *error) {
  for (int m = mesh->n_vertices; m < mesh->n_nodes; m++)
    if (!edge_is_closed(mesh, m))
      return error_set(error, STATUS_FAILED,
                       "mesh: the edge of node %d is not shared by two elements of opposite sense", m);
  int euler = mesh->n_vertices - (mesh->n_nodes - mesh->n_vertices) + mesh->n_elements;
  if (euler != 2)
    return error_set(error, STATUS_FAILED, "mesh: expected a surface of Euler number 2, found %d", euler);
  double volume = surface_volume(mesh, mesh->X);
  if (!(volume > 0.0))
    return error_set(error, STATUS_FAILED, "mesh: expected outward normals, found an enclosed volume of %g",
                     volume);
  return STATUS_OK;
}

double mesh_edge_length(const Mesh *mesh, const double *x) {
  double sum = 0.0; /* each edge comes twice, once from either side */
  for (int e = 0; e < mesh->n_elements; e++)
    for (int k = 0; k < 3; k++)
      sum += vec3_distance(&x[3 * mesh->element[e][k]], &x[3 * mesh->element[e][(k + 1) % 3]]);
  return sum / (3.0 * mesh->n_elements);
}
