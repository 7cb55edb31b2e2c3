/* Ellipsoids on icospheres, with loads and the velocities that they should give, for tests.
 *
 * Errors are the largest over the nodes, over the largest velocity. */
#ifndef CAPSELLA_TESTS_ELLIPSOID_H
#define CAPSELLA_TESTS_ELLIPSOID_H

#include "base/array.h"
#include "base/vec3.h"
#include "mesh/mesh.h"
#include "mesh/quadrature.h"
#include <check.h>
#include <math.h>
#include <string.h>

static const double SPHERE[3] = {1, 1, 1}, CAPSULE[3] = {2, 1, 0.5}, STRETCHED[3] = {3, 1, 1.0 / 3};

/* An ellipsoid on an icosphere, with a load and the velocity it should give. */
typedef struct {
  Mesh mesh;
  double axis[3];
  double *x, *q, *u, *expected;
} Body;

static inline void body_new(Body *body, int subdivisions, const double axis[3]) {
  Error error;
  ck_assert_int_eq(mesh_sphere(&body->mesh, subdivisions, NULL, &error), STATUS_OK);
  int n = 3 * body->mesh.n_nodes;
  double **arrays[] = {&body->x, &body->q, &body->u, &body->expected};
  for (int i = 0; i < 4; i++) ck_assert_int_eq(ARRAY_NEW(arrays[i], n, &error), STATUS_OK);
  memcpy(body->axis, axis, sizeof body->axis);
  for (int i = 0; i < n; i++) body->x[i] = axis[i % 3] * body->mesh.X[i];
}

static inline void body_free(Body *body) {
  mesh_free(&body->mesh);
  array_free(body->x);
  array_free(body->q);
  array_free(body->u);
  array_free(body->expected);
}

static inline double largest(int n, const double *v) {
  double norm = 0;
  for (int p = 0; p < n; p++) norm = fmax(norm, vec3_norm(v + 3 * p));
  return norm;
}

static inline double body_error(const Body *body) {
  double error = 0;
  int n = body->mesh.n_nodes;
  for (int p = 0; p < n; p++) error = fmax(error, vec3_distance(body->u + 3 * p, body->expected + 3 * p));
  return error / largest(n, body->expected);
}

/* Outward unit normal of the ellipsoid at one of its points; returns |(x/A^2, y/B^2, z/C^2)|. */
static inline double ellipsoid_normal(const double axis[3], const double *x, double n[3]) {
  for (int i = 0; i < 3; i++) n[i] = x[i] / (axis[i] * axis[i]);
  return vec3_normalize(n);
}

/* chi, alpha_i and C_ij: integrals over s from 0 to infinity, by s = c^2 (1/w^2 - 1) over w from 0 to 1,
 * where the integrands are analytic.  c is the shortest axis. */
typedef struct {
  double chi, alpha[3], C[3][3];
} EllipsoidIntegrals;

static inline EllipsoidIntegrals ellipsoid_integrals(const double axis[3]) {
  EllipsoidIntegrals sum = {0};
  double w[GAUSS_MAX], weight[GAUSS_MAX];
  gauss_rule(GAUSS_MAX, w, weight);
  double c = fmin(axis[0], fmin(axis[1], axis[2])), c2 = c * c;
  for (int k = 0; k < GAUSS_MAX; k++) {
    double w2 = w[k] * w[k], s = c2 * (1 / w2 - 1), h[3]; /* h_i = w^2 (a_i^2 + s) */
    for (int i = 0; i < 3; i++) h[i] = axis[i] * axis[i] * w2 + c2 * (1 - w2);
    double base = weight[k] * 2 * c2 / sqrt(h[0] * h[1] * h[2]);
    sum.chi += base;
    for (int i = 0; i < 3; i++) {
      sum.alpha[i] += base * w2 / h[i];
      for (int j = 0; j < 3; j++) sum.C[i][j] += base * s * w2 * w2 / (h[i] * h[j]);
    }
  }
  return sum;
}

/* Load of an ellipsoid in translation and its uniform velocity, for unit force density scale. */
static inline void load_translation(Body *body, int direction) {
  EllipsoidIntegrals I = ellipsoid_integrals(body->axis);
  const double *a = body->axis;
  double U = a[0] * a[1] * a[2] / 4 * (I.chi + I.alpha[direction] * a[direction] * a[direction]);
  for (int p = 0; p < body->mesh.n_nodes; p++) {
    double n[3], density = 1 / ellipsoid_normal(a, body->x + 3 * p, n);
    for (int i = 0; i < 3; i++) {
      body->q[3 * p + i] = i == direction ? density : 0;
      body->expected[3 * p + i] = i == direction ? U : 0;
    }
  }
}

/* q = D n with a constant matrix D. */
static inline void load_matrix(Body *body, const double D[3][3]) {
  for (int p = 0; p < body->mesh.n_nodes; p++) {
    double n[3];
    ellipsoid_normal(body->axis, body->x + 3 * p, n);
    for (int i = 0; i < 3; i++) body->q[3 * p + i] = vec3_dot(D[i], n);
  }
}

static inline void expect_matrix(Body *body, const double G[3][3]) {
  for (int p = 0; p < body->mesh.n_nodes; p++) {
    for (int i = 0; i < 3; i++) body->expected[3 * p + i] = vec3_dot(G[i], body->x + 3 * p);
  }
}

/* Velocity gradient inside an ellipsoid with q = diag(c) n. */
static inline void diagonal_gradient(const double a[3], const double c[3], double G[3][3]) {
  EllipsoidIntegrals I = ellipsoid_integrals(a);
  memset(G, 0, 9 * sizeof(double));
  for (int i = 0; i < 3; i++) {
    double sum = 2 * c[i] * I.alpha[i];
    for (int j = 0; j < 3; j++) sum -= c[j] * I.C[i][j] * (i == j ? 3 : 1);
    G[i][i] = a[0] * a[1] * a[2] / 4 * sum;
  }
}

#endif
