/* The fit is linear in the positions: each corner has weights of its own, made once.  On an orthonormal basis
 * Q [stencil][functions] of the polynomials at the nodes around a corner they are Q Q^T, the corner's row. */
#include "observe/wrinkles.h"

#include "base/array.h"
#include "base/vec3.h"
#include <math.h>
#include <stdbool.h>

/* Radius of what is around a corner, in mean edges. */
static const double REACH = 2;

/* Nodes around a corner: about 58, on irregular meshes up to 80. */
enum { FUNCTIONS = 7, MAX_STENCIL = 96 };

/* A function of which orthogonalisation leaves less than this is the sum of others. */
static const double DEPENDENT = 1e-10;

typedef struct {
  int corner, members; /* of its orbit */
  int n, node[MAX_STENCIL];
  double weight[MAX_STENCIL];
} Stencil;

struct Wrinkles {
  const Mesh *mesh;
  Stencil *stencil; /* [n] around one corner of each orbit */
  int n;
};

/* The nodes within `reach` of the corner at rest, from neighbour to neighbour, as long as there is room.
 * mark [n_nodes] holds numbers of other corners, or -1. */
static void gather_nodes(const Mesh *mesh, double reach, int *mark, Stencil *stencil) {
  const int p = stencil->corner;
  stencil->n = 1;
  stencil->node[0] = p;
  mark[p] = p;
  for (int i = 0; i < stencil->n; i++) {
    const int from = stencil->node[i];
    for (int k = 6 * mesh->node_start[from]; k < 6 * mesh->node_start[from + 1]; k++) {
      const int q = mesh->element[mesh->node_element[k / 6]][k % 6];
      const bool is_new = mark[q] != p && vec3_distance(mesh->X + 3 * q, mesh->X + 3 * p) <= reach;
      if (!is_new || stencil->n == MAX_STENCIL) continue;
      mark[q] = p;
      stencil->node[stencil->n++] = q;
    }
  }
}

/* Two unit vectors normal to n and to each other. */
static void tangents(const double n[3], double u[3], double v[3]) {
  const double axis[3] = {fabs(n[0]) < 0.6, fabs(n[0]) >= 0.6, 0};
  vec3_cross(n, axis, u);
  vec3_normalize(u);
  vec3_cross(n, u, v);
}

/* The functions 1, w, u, v, u^2, u v, v^2 at the nodes of a stencil; w along the normal of its first node. */
static void fill_basis(const Mesh *mesh, const Stencil *stencil, double scale,
                       double basis[FUNCTIONS][MAX_STENCIL]) {
  double n[3], e[3], f[3], offset[3];
  const double *corner = mesh->X + 3 * stencil->node[0];
  for (int i = 0; i < 3; i++) n[i] = corner[i];
  vec3_normalize(n);
  tangents(n, e, f);
  for (int s = 0; s < stencil->n; s++) {
    vec3_subtract(mesh->X + 3 * stencil->node[s], corner, offset);
    const double u = vec3_dot(offset, e) / scale, v = vec3_dot(offset, f) / scale;
    const double value[FUNCTIONS] = {1, vec3_dot(offset, n) / (scale * scale), u, v, u * u, u * v, v * v};
    for (int j = 0; j < FUNCTIONS; j++) basis[j][s] = value[j];
  }
}

static double dot(int n, const double *a, const double *b) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* Gram-Schmidt, twice, for round-off; a function that depends on those before becomes zero. */
static void orthonormalize(int n, double basis[FUNCTIONS][MAX_STENCIL]) {
  for (int j = 0; j < FUNCTIONS; j++) {
    const double before = sqrt(dot(n, basis[j], basis[j]));
    for (int pass = 0; pass < 2; pass++)
      for (int i = 0; i < j; i++) {
        const double share = dot(n, basis[i], basis[j]);
        for (int s = 0; s < n; s++) basis[j][s] -= share * basis[i][s];
      }
    const double left = sqrt(dot(n, basis[j], basis[j]));
    for (int s = 0; s < n; s++) basis[j][s] = left > DEPENDENT * before ? basis[j][s] / left : 0;
  }
}

static void fill_weights(const Mesh *mesh, double scale, Stencil *stencil) {
  double basis[FUNCTIONS][MAX_STENCIL];
  fill_basis(mesh, stencil, scale, basis);
  orthonormalize(stencil->n, basis);
  for (int s = 0; s < stencil->n; s++)
    for (int j = 0; j < FUNCTIONS; j++) stencil->weight[s] += basis[j][0] * basis[j][s];
}

Status wrinkles_new(Wrinkles **out, const Mesh *mesh, const Symmetry *symmetry, Error *error) {
  Status status = STATUS_OK;
  Wrinkles *wrinkles = NULL;
  int *mark = NULL;
  const Orbits *orbits = &symmetry->nodes;
  const double reach = REACH * mesh_edge_length(mesh, mesh->X);
  TRY(ARRAY_NEW(&wrinkles, 1, error));
  wrinkles->mesh = mesh;
  while (wrinkles->n < orbits->n && orbits->representative[wrinkles->n] < mesh->n_vertices) wrinkles->n++;
  TRY(ARRAY_NEW(&wrinkles->stencil, wrinkles->n, error));
  TRY(ARRAY_NEW(&mark, mesh->n_nodes, error));
  for (int p = 0; p < mesh->n_nodes; p++) mark[p] = -1;
  for (int k = 0; k < wrinkles->n; k++) {
    Stencil *stencil = &wrinkles->stencil[k];
    stencil->corner = orbits->representative[k];
    stencil->members = orbits->size[k];
    gather_nodes(mesh, reach, mark, stencil);
    fill_weights(mesh, reach, stencil);
  }
  *out = wrinkles;
  wrinkles = NULL;
cleanup:
  array_free(mark);
  wrinkles_free(wrinkles);
  return status;
}

void wrinkles_free(Wrinkles *wrinkles) {
  if (!wrinkles) return;
  array_free(wrinkles->stencil);
  array_free(wrinkles);
}

/* Of the elements around a corner, taken as flat. */
static void corner_normal(const Mesh *mesh, int p, const double *x, double normal[3]) {
  for (int i = 0; i < 3; i++) normal[i] = 0;
  for (int k = mesh->node_start[p]; k < mesh->node_start[p + 1]; k++) {
    const int *node = mesh->element[mesh->node_element[k]];
    double a[3], b[3], area[3];
    vec3_subtract(x + 3 * node[1], x + 3 * node[0], a);
    vec3_subtract(x + 3 * node[2], x + 3 * node[0], b);
    vec3_cross(a, b, area);
    for (int i = 0; i < 3; i++) normal[i] += area[i];
  }
  vec3_normalize(normal);
}

/* Height of the corner over the smooth surface. */
static double height(const Mesh *mesh, const Stencil *stencil, const double *x) {
  double smooth[3] = {0}, off[3], normal[3];
  for (int s = 0; s < stencil->n; s++)
    for (int i = 0; i < 3; i++) smooth[i] += stencil->weight[s] * x[3 * stencil->node[s] + i];
  vec3_subtract(x + 3 * stencil->corner, smooth, off);
  corner_normal(mesh, stencil->corner, x, normal);
  return vec3_dot(off, normal);
}

double wrinkles_amplitude(const Wrinkles *wrinkles, const double *x) {
  double sum = 0;
  for (int k = 0; k < wrinkles->n; k++) {
    const double h = height(wrinkles->mesh, &wrinkles->stencil[k], x);
    sum += wrinkles->stencil[k].members * h * h;
  }
  return sqrt(sum / wrinkles->mesh->n_vertices);
}
