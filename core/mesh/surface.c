/* Volume, area and normals of a closed P2 surface by the triangle rules.  Sums run over the elements in their
 * order, so that results do not depend on the number of threads. */
#include "mesh/surface.h"

#include "base/vec3.h"
#include "mesh/p2.h"
#include "mesh/surface_kernel.h"

#include <string.h>

enum {
  VOLUME_POINTS = 6,  /* degree 4: exact for the volume and its gradient */
  AREA_POINTS = 12,   /* not polynomial: the rule's error stays below that of the P2 geometry */
  MOMENT_POINTS = 16, /* degree 8: exact for the second moments */
};

/* The elements of a sum, all of them or one of each orbit, in blocks of lanes.  The last block repeats an
 * element. */
typedef struct {
  const Mesh *mesh;
  const Symmetry *symmetry;
  int n, n_blocks;
} Elements;

static Elements elements_of(const Mesh *mesh, const Symmetry *symmetry) {
  const int n = symmetry ? symmetry->elements.n : mesh->n_elements;
  return (Elements){mesh, symmetry, n, (n + SURFACE_LANES - 1) / SURFACE_LANES};
}

static int lanes_of(const Elements *elements, int block) {
  const int left = elements->n - block * SURFACE_LANES;
  return left < SURFACE_LANES ? left : SURFACE_LANES;
}

static const int *nodes_of(const Elements *elements, int block, int lane) {
  const int i = block * SURFACE_LANES + (lane < lanes_of(elements, block) ? lane : 0);
  return elements->mesh->element[elements->symmetry ? elements->symmetry->elements.representative[i] : i];
}

/* Members of the orbit of an element. */
static double size_of(const Elements *elements, int block, int lane) {
  return elements->symmetry ? elements->symmetry->elements.size[block * SURFACE_LANES + lane] : 1;
}

static void gather(const Elements *elements, int block, const double *x, SurfaceBlock values) {
  for (int lane = 0; lane < SURFACE_LANES; lane++) {
    const int *node = nodes_of(elements, block, lane);
    for (int k = 0; k < 6; k++)
      for (int i = 0; i < 3; i++) values[k][i][lane] = x[3 * node[k] + i];
  }
}

double surface_flux(const Mesh *mesh, const Symmetry *symmetry, const double *x, const double *v) {
  const P2Table table = p2_table(triangle_rule(VOLUME_POINTS));
  const Elements elements = elements_of(mesh, symmetry);
  double sum = 0.0;
  for (int block = 0; block < elements.n_blocks; block++) {
    SurfaceBlock positions, A;
    gather(&elements, block, x, positions);
    surface_block_area_vectors(&table, positions, A);
    for (int lane = 0; lane < lanes_of(&elements, block); lane++) {
      const int *node = nodes_of(&elements, block, lane);
      double flux = 0.0;
      for (int k = 0; k < 6; k++)
        for (int i = 0; i < 3; i++) flux += A[k][i][lane] * v[3 * node[k] + i];
      sum += size_of(&elements, block, lane) * flux;
    }
  }
  return sum;
}

double surface_volume(const Mesh *mesh, const double *x) {
  return surface_flux(mesh, NULL, x, x) / 3.0;
}

double surface_area(const Mesh *mesh, const Symmetry *symmetry, const double *x) {
  const P2Table table = p2_table(triangle_rule(AREA_POINTS));
  const Elements elements = elements_of(mesh, symmetry);
  double sum = 0.0;
  for (int block = 0; block < elements.n_blocks; block++) {
    SurfaceBlock positions;
    double area[SURFACE_LANES];
    gather(&elements, block, x, positions);
    surface_block_areas(&table, positions, area);
    for (int lane = 0; lane < lanes_of(&elements, block); lane++)
      sum += size_of(&elements, block, lane) * area[lane];
  }
  return sum;
}

/* Mean over the operations of the factor that the image of an element brings to a moment of x_i or of x_i x_j
 * (j negative: of x_i alone): 1, or 0 where the images cancel. */
static double kept(const Symmetry *symmetry, int i, int j) {
  double sum = 0.0;
  for (int k = 0; k < symmetry->n_operations; k++) {
    const double *sign = symmetry->operation[k].sign;
    sum += j < 0 ? sign[i] : sign[i] * sign[j];
  }
  return sum / symmetry->n_operations;
}

static void keep_symmetric(const Symmetry *symmetry, SurfaceMoments *moments) {
  for (int i = 0, k = 0; i < 3; i++) {
    moments->first[i] *= kept(symmetry, i, -1);
    for (int j = i; j < 3; j++) moments->second[k++] *= kept(symmetry, i, j);
  }
}

SurfaceMoments surface_moments(const Mesh *mesh, const Symmetry *symmetry, const double *x,
                               const double origin[3]) {
  const P2Table table = p2_table(triangle_rule(MOMENT_POINTS));
  const Elements elements = elements_of(mesh, symmetry);
  double sum[SURFACE_MOMENTS] = {0};
  for (int block = 0; block < elements.n_blocks; block++) {
    SurfaceBlock positions;
    double moment[SURFACE_MOMENTS][SURFACE_LANES];
    gather(&elements, block, x, positions);
    surface_block_moments(&table, positions, origin, moment);
    for (int k = 0; k < SURFACE_MOMENTS; k++)
      for (int lane = 0; lane < lanes_of(&elements, block); lane++)
        sum[k] += size_of(&elements, block, lane) * moment[k][lane];
  }
  SurfaceMoments moments = {.volume = sum[0]};
  memcpy(moments.first, sum + 1, sizeof moments.first);
  memcpy(moments.second, sum + 4, sizeof moments.second);
  if (symmetry) keep_symmetric(symmetry, &moments);
  return moments;
}

void surface_area_vectors(const Mesh *mesh, const Symmetry *symmetry, const double *x, double *A) {
  const P2Table table = p2_table(triangle_rule(VOLUME_POINTS));
  const Elements elements = elements_of(mesh, symmetry);
  memset(A, 0, 3 * (size_t)mesh->n_nodes * sizeof *A);
  for (int block = 0; block < elements.n_blocks; block++) {
    SurfaceBlock positions, share;
    gather(&elements, block, x, positions);
    surface_block_area_vectors(&table, positions, share);
    for (int lane = 0; lane < lanes_of(&elements, block); lane++) {
      const int *node = nodes_of(&elements, block, lane);
      const double size = size_of(&elements, block, lane);
      for (int k = 0; k < 6; k++)
        for (int i = 0; i < 3; i++) A[3 * node[k] + i] += size * share[k][i][lane];
    }
  }
}

/* Shape functions at the nodes of an element. */
static P2Table node_table(void) {
  static const double weight[6] = {0.0, 0.0, 0.0, 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0};
  static const TriangleRule nodes = {.n = 6, .degree = 2, .point = p2_node, .weight = weight};
  return p2_table(&nodes);
}

/* Elements around the nodes of one orbit each are not one of each orbit: all elements are visited. */
void surface_normals(const Mesh *mesh, const double *x, double *n) {
  const P2Table table = node_table();
  const Elements elements = elements_of(mesh, NULL);
  memset(n, 0, 3 * (size_t)mesh->n_nodes * sizeof *n);
  for (int block = 0; block < elements.n_blocks; block++) {
    SurfaceBlock positions, normal;
    gather(&elements, block, x, positions);
    surface_block_normals(&table, positions, normal);
    for (int lane = 0; lane < lanes_of(&elements, block); lane++) {
      const int *node = nodes_of(&elements, block, lane);
      for (int k = 0; k < 6; k++)
        for (int i = 0; i < 3; i++) n[3 * node[k] + i] += normal[k][i][lane];
    }
  }
  for (int p = 0; p < mesh->n_nodes; p++) vec3_normalize(&n[3 * p]);
}
