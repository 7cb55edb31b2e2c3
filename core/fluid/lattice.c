/* Places on the lattice are pairs (i, j) with i + j <= 4: corner 0 is (0, 0), 1 is (4, 0), 2 is (0, 4). */
#include "fluid/lattice.h"

#include "base/vec3.h"
#include "mesh/p2.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { SIDE = 4 };

/* Corners of the children in the order of the mesh: three at the corners, the fourth in the middle. */
static const int CORNER[CHILDREN][3][2] = {
    {{0, 0}, {2, 0}, {0, 2}}, {{2, 0}, {4, 0}, {2, 2}}, {{0, 2}, {2, 2}, {0, 4}}, {{2, 0}, {2, 2}, {0, 2}}};

static int node_number(int i, int j) {
  return i + j * (SIDE + 1) - j * (j - 1) / 2;
}

/* Notes that a node of a child stands at (xi, eta) of it, if that is on the parent's lattice. */
static Status put_node(int child, double xi, double eta, int number, int node[LATTICE_NODES], Error *error) {
  const int(*corner)[2] = CORNER[child];
  double place[2];
  for (int c = 0; c < 2; c++) {
    place[c] = corner[0][c] + xi * (corner[1][c] - corner[0][c]) + eta * (corner[2][c] - corner[0][c]);
  }
  int i = (int)place[0], j = (int)place[1];
  if (i != place[0] || j != place[1]) return STATUS_OK;
  int *entry = &node[node_number(i, j)];
  if (*entry >= 0 && *entry != number) {
    return error_set(error, STATUS_FAILED,
                     "lattice: expected four elements that make up one of a coarser mesh, found nodes %d and "
                     "%d at one place",
                     *entry, number);
  }
  *entry = number;
  return STATUS_OK;
}

Status lattice_of_elements(const int element[CHILDREN][6], int node[LATTICE_NODES], Error *error) {
  Status status = STATUS_OK;
  for (int k = 0; k < LATTICE_NODES; k++) node[k] = -1;
  for (int child = 0; child < CHILDREN; child++) {
    for (int k = 0; k < 6; k++) {
      TRY(put_node(child, p2_node[k][0], p2_node[k][1], element[child][k], node, error));
    }
  }
cleanup:
  return status;
}

Status lattice_of_lattices(const int child[CHILDREN][LATTICE_NODES], int node[LATTICE_NODES], Error *error) {
  Status status = STATUS_OK;
  for (int k = 0; k < LATTICE_NODES; k++) node[k] = -1;
  for (int c = 0; c < CHILDREN; c++) {
    for (int j = 0; j <= SIDE; j++) {
      for (int i = 0; i + j <= SIDE; i++) {
        TRY(put_node(c, (double)i / SIDE, (double)j / SIDE, child[c][node_number(i, j)], node, error));
      }
    }
  }
cleanup:
  return status;
}

/* Product of (z - m) / (n - m) over m < n: 1 at n, 0 at the lattice lines before. */
static double factor(int n, double z) {
  double product = 1;
  for (int m = 0; m < n; m++) product *= (z - m) / (n - m);
  return product;
}

/* The quartic polynomials that are 1 at one place of the lattice and 0 at the others. */
static void quartics(const LatticeFit *fit, const double point[3], double value[LATTICE_NODES]) {
  double offset[3];
  vec3_subtract(point, fit->origin, offset);
  double s = vec3_dot(fit->axis[0], offset), t = vec3_dot(fit->axis[1], offset);
  for (int j = 0; j <= SIDE; j++) {
    for (int i = 0; i + j <= SIDE; i++) {
      value[node_number(i, j)] = factor(i, s) * factor(j, t) * factor(SIDE - i - j, SIDE - s - t);
    }
  }
}

/* Gauss-Jordan elimination; false when the matrix is singular.  The nodes stand near their places, so that it
 * is near the identity, but their order does not promise a pivot. */
static bool invert(double matrix[LATTICE_NODES][LATTICE_NODES],
                   double inverse[LATTICE_NODES][LATTICE_NODES]) {
  enum { N = LATTICE_NODES };
  memset(inverse, 0, N * sizeof inverse[0]);
  for (int i = 0; i < N; i++) inverse[i][i] = 1;
  for (int column = 0; column < N; column++) {
    int pivot = column;
    for (int row = column + 1; row < N; row++) {
      if (fabs(matrix[row][column]) > fabs(matrix[pivot][column])) pivot = row;
    }
    if (!(fabs(matrix[pivot][column]) > 1e-6)) return false;
    for (int k = 0; k < N; k++) {
      double a = matrix[column][k], b = inverse[column][k];
      matrix[column][k] = matrix[pivot][k];
      inverse[column][k] = inverse[pivot][k];
      matrix[pivot][k] = a;
      inverse[pivot][k] = b;
    }
    double scale = 1 / matrix[column][column];
    for (int k = 0; k < N; k++) {
      matrix[column][k] *= scale;
      inverse[column][k] *= scale;
    }
    for (int row = 0; row < N; row++) {
      double share = matrix[row][column];
      if (row == column || share == 0) continue;
      for (int k = 0; k < N; k++) {
        matrix[row][k] -= share * matrix[column][k];
        inverse[row][k] -= share * inverse[column][k];
      }
    }
  }
  return true;
}

Status lattice_fit(LatticeFit *fit, const double *X, const int node[LATTICE_NODES], Error *error) {
  const double *corner = X + 3 * node[node_number(0, 0)];
  double a[3], b[3], values[LATTICE_NODES][LATTICE_NODES];
  vec3_subtract(X + 3 * node[node_number(SIDE, 0)], corner, a);
  vec3_subtract(X + 3 * node[node_number(0, SIDE)], corner, b);
  double aa = vec3_dot(a, a), ab = vec3_dot(a, b), bb = vec3_dot(b, b), scale = SIDE / (aa * bb - ab * ab);
  for (int c = 0; c < 3; c++) {
    fit->origin[c] = corner[c];
    fit->axis[0][c] = scale * (bb * a[c] - ab * b[c]);
    fit->axis[1][c] = scale * (aa * b[c] - ab * a[c]);
  }
  for (int k = 0; k < LATTICE_NODES; k++) quartics(fit, X + 3 * node[k], values[k]);
  if (invert(values, fit->inverse)) return STATUS_OK;
  return error_set(error, STATUS_FAILED, "lattice: the nodes around node %d do not determine a quartic",
                   node[0]);
}

void lattice_weights(const LatticeFit *fit, const double point[3], double weight[LATTICE_LANES]) {
  double value[LATTICE_NODES];
  quartics(fit, point, value);
  memset(weight, 0, LATTICE_LANES * sizeof *weight);
  for (int k = 0; k < LATTICE_NODES; k++) {
    for (int m = 0; m < LATTICE_NODES; m++) weight[k] += value[m] * fit->inverse[m][k];
  }
}
