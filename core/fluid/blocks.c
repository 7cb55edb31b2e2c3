/* Spheres about the corners of each element, widened by the near distance, and spheres about those. */
#include "fluid/blocks.h"

#include "base/array.h"
#include "base/vec3.h"

#include <math.h>

/* Keeps the bounds a superset in spite of round-off. */
static const double WIDEN = 1 + 1e-12;

Status blocks_new(Blocks *blocks, const Mesh *mesh, double factor, Error *error) {
  Status status = STATUS_OK;
  int n_blocks = (mesh->n_elements + BLOCK_ELEMENTS - 1) / BLOCK_ELEMENTS;
  *blocks = (Blocks){.n_blocks = n_blocks, .n_elements = mesh->n_elements, .factor = factor};
  TRY(ARRAY_NEW(&blocks->element_center, 3 * mesh->n_elements, error));
  TRY(ARRAY_NEW(&blocks->element_reach, mesh->n_elements, error));
  for (int c = 0; c < 3; c++) TRY(ARRAY_NEW(&blocks->center[c], n_blocks, error));
  TRY(ARRAY_NEW(&blocks->reach2, n_blocks, error));
cleanup:
  return status;
}

void blocks_free(Blocks *blocks) {
  array_free(blocks->element_center);
  array_free(blocks->element_reach);
  for (int c = 0; c < 3; c++) array_free(blocks->center[c]);
  array_free(blocks->reach2);
  *blocks = (Blocks){0};
}

static void update_element(Blocks *blocks, const Mesh *mesh, const double *x, int e) {
  const int *node = mesh->element[e];
  double *center = blocks->element_center + 3 * e;
  for (int c = 0; c < 3; c++) center[c] = (x[3 * node[0] + c] + x[3 * node[1] + c] + x[3 * node[2] + c]) / 3;
  double radius = 0, longest = 0;
  for (int k = 0; k < 3; k++) {
    radius = fmax(radius, vec3_distance(center, x + 3 * node[k]));
    longest = fmax(longest, vec3_distance(x + 3 * node[k], x + 3 * node[(k + 1) % 3]));
  }
  blocks->element_reach[e] = WIDEN * (radius + blocks->factor * longest);
}

static void update_block(Blocks *blocks, int b) {
  int first = b * BLOCK_ELEMENTS, last = first + BLOCK_ELEMENTS;
  if (last > blocks->n_elements) last = blocks->n_elements;
  double center[3] = {0, 0, 0}, reach = 0;
  for (int e = first; e < last; e++) {
    for (int c = 0; c < 3; c++) center[c] += blocks->element_center[3 * e + c] / (last - first);
  }
  for (int e = first; e < last; e++) {
    reach = fmax(reach, vec3_distance(center, blocks->element_center + 3 * e) + blocks->element_reach[e]);
  }
  for (int c = 0; c < 3; c++) blocks->center[c][b] = center[c];
  blocks->reach2[b] = WIDEN * reach * reach;
}

void blocks_update(Blocks *blocks, const Mesh *mesh, const double *x) {
#pragma omp parallel for schedule(static)
  for (int b = 0; b < blocks->n_blocks; b++) {
    int last = (b + 1) * BLOCK_ELEMENTS;
    for (int e = b * BLOCK_ELEMENTS; e < last && e < blocks->n_elements; e++) {
      update_element(blocks, mesh, x, e);
    }
    update_block(blocks, b);
  }
}

void blocks_scan(const Blocks *blocks, const double target[3], int first, int n, int *far) {
  const double *restrict c0 = blocks->center[0] + first, *restrict c1 = blocks->center[1] + first;
  const double *restrict c2 = blocks->center[2] + first, *restrict reach2 = blocks->reach2 + first;
  const double x0 = target[0], x1 = target[1], x2 = target[2];
  for (int i = 0; i < n; i++) {
    double r0 = c0[i] - x0, r1 = c1[i] - x1, r2 = c2[i] - x2;
    far[i] = r0 * r0 + r1 * r1 + r2 * r2 > reach2[i];
  }
}

bool blocks_may_be_near(const Blocks *blocks, int element, const double target[3]) {
  return vec3_distance(blocks->element_center + 3 * element, target) <= blocks->element_reach[element];
}
