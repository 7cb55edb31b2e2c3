/* Orthographic, with the far side left out: on a closed surface it is hidden by the near one. */
#include "observe/projection.h"

#include "base/array.h"
#include "base/vec3.h"
#include "mesh/p2.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

Status projection_make(Projection *projection, const double toward[3], const double up[3], Error *error) {
  for (int i = 0; i < 3; i++) projection->toward[i] = toward[i];
  vec3_cross(up, toward, projection->right);
  /* Written so that NaN fails too. */
  if (!(vec3_normalize(projection->toward) > 0) || !(vec3_normalize(projection->right) > 0))
    return error_set(error, STATUS_INPUT,
                     "picture: expected a view with a direction, and an upward one that is not along it");
  vec3_cross(projection->toward, projection->right, projection->up);
  return STATUS_OK;
}

/* Position and field at (xi, eta) of an element. */
static double interpolate(const int element[6], const double *x, const double *field, const double at[2],
                          double position[3]) {
  double N[6], value = 0;
  p2_values(at[0], at[1], N);
  for (int i = 0; i < 3; i++) position[i] = 0;
  for (int k = 0; k < 6; k++) {
    for (int i = 0; i < 3; i++) position[i] += N[k] * x[3 * element[k] + i];
    if (field) value += N[k] * field[element[k]];
  }
  return value;
}

/* Brightness of a piece by the angle of its normal to the light; -1 when it faces away from the eye. */
static double light_on(const Projection *projection, double x[3][3]) {
  double edge[2][3], normal[3], sun[3];
  vec3_subtract(x[1], x[0], edge[0]);
  vec3_subtract(x[2], x[0], edge[1]);
  vec3_cross(edge[0], edge[1], normal);
  if (!(vec3_normalize(normal) > 0 && vec3_dot(normal, projection->toward) > 0)) return -1;
  for (int i = 0; i < 3; i++)
    sun[i] = projection->toward[i] + 0.5 * projection->up[i] - 0.4 * projection->right[i];
  vec3_normalize(sun);
  return fmax(vec3_dot(normal, sun), 0);
}

/* Corners of piece k of the n * n into which an element is cut: row r holds 2 (n - r) - 1 of them, upright
 * and inverted ones by turns. */
static void piece_corners(int n, int k, double at[3][2]) {
  int row = 0;
  for (; k >= 2 * (n - row) - 1; row++) k -= 2 * (n - row) - 1;
  const int c = k / 2, r = row;
  const int upright[3][2] = {{c, r}, {c + 1, r}, {c, r + 1}};
  const int inverted[3][2] = {{c + 1, r}, {c + 1, r + 1}, {c, r + 1}};
  for (int corner = 0; corner < 3; corner++)
    for (int i = 0; i < 2; i++) at[corner][i] = (double)(k % 2 ? inverted : upright)[corner][i] / n;
}

static bool make_piece(const Projection *projection, const int element[6], const double *x,
                       const double *field, const double center[3], double at[3][2], Piece *piece) {
  double position[3][3];
  *piece = (Piece){0};
  for (int k = 0; k < 3; k++) {
    piece->values[k] = interpolate(element, x, field, at[k], position[k]);
    piece->value += piece->values[k] / 3;
    vec3_subtract(position[k], center, position[k]);
    piece->corner[k][0] = vec3_dot(position[k], projection->right);
    piece->corner[k][1] = vec3_dot(position[k], projection->up);
    piece->depth += vec3_dot(position[k], projection->toward) / 3;
  }
  piece->light = light_on(projection, position);
  return piece->light >= 0;
}

static int far_to_near(const void *a, const void *b) {
  const Piece *left = a, *right = b;
  if (left->depth != right->depth) return left->depth < right->depth ? -1 : 1;
  return left->order - right->order;
}

Status projection_pieces(const Projection *projection, const Mesh *mesh, const double *x, const double *field,
                         const double center[3], int cuts, Piece **pieces, size_t *count, Error *error) {
  const int per_element = cuts * cuts;
  *count = 0;
  Status status = ARRAY_NEW(pieces, (size_t)mesh->n_elements * (size_t)per_element, error);
  if (status != STATUS_OK) return status;
  for (int e = 0; e < mesh->n_elements; e++)
    for (int k = 0; k < per_element; k++) {
      double at[3][2];
      Piece *piece = &(*pieces)[*count];
      piece_corners(cuts, k, at);
      if (!make_piece(projection, mesh->element[e], x, field, center, at, piece)) continue;
      piece->order = e * per_element + k;
      (*count)++;
    }
  qsort(*pieces, *count, sizeof **pieces, far_to_near);
  return STATUS_OK;
}
