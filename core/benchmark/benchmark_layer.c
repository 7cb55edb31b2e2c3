/* Accuracy of the single layer against the exact solution of a rigid ellipsoid in translation. */
#include "base/array.h"
#include "benchmark/benchmark.h"
#include "fluid/single_layer.h"
#include "mesh/mesh.h"
#include "mesh/quadrature.h"
#include <math.h>
#include <string.h>

/* Integrals of the ellipsoid over s from 0 to infinity, by Gauss points in s = u/(1 - u) pieces. */
static void ellipsoid_integrals(const double axes[3], double *chi, double alpha[3]) {
  enum { POINTS = 32, PIECES = 64 };
  double node[POINTS], weight[POINTS];
  gauss_rule(POINTS, node, weight);
  *chi = alpha[0] = alpha[1] = alpha[2] = 0;
  for (int piece = 0; piece < PIECES; piece++)
    for (int i = 0; i < POINTS; i++) {
      /* s = w^2/(1-w)^2 makes the integrand smooth at both ends */
      const double w = (piece + node[i]) / PIECES, r = w / (1 - w), s = r * r;
      const double ds = 2 * r / ((1 - w) * (1 - w)) * weight[i] / PIECES;
      double delta = 1;
      for (int c = 0; c < 3; c++) delta *= axes[c] * axes[c] + s;
      delta = sqrt(delta);
      *chi += ds / delta;
      for (int c = 0; c < 3; c++) alpha[c] += ds / ((axes[c] * axes[c] + s) * delta);
    }
}

/* Load of a rigid ellipsoid that moves with velocity U: q_i = F_i / (4 pi abc) (sum x^2/a^4)^(-1/2) and
 * U_i = F_i (chi + alpha_i a_i^2) / (16 pi), for a unit velocity along (1, 1, 1). */
static void translation_load(const Mesh *mesh, const double axes[3], const double *x, double *q) {
  double chi, alpha[3];
  ellipsoid_integrals(axes, &chi, alpha);
  const double pi = 3.14159265358979323846;
  for (int p = 0; p < mesh->n_nodes; p++) {
    double sum = 0;
    for (int c = 0; c < 3; c++) sum += x[3 * p + c] * x[3 * p + c] / pow(axes[c], 4);
    for (int c = 0; c < 3; c++) {
      const double force = 16 * pi / (chi + alpha[c] * axes[c] * axes[c]) / sqrt(3.0);
      q[3 * p + c] = force / (4 * pi * axes[0] * axes[1] * axes[2]) / sqrt(sum);
    }
  }
}

static Status evaluate_layer(const Mesh *mesh, FluidMethod method, const double *x, const double *q,
                             double *u, Error *error) {
  SingleLayer *layer = NULL;
  Status status = STATUS_OK;
  TRY(single_layer_new(&layer, mesh, method, error));
  TRY(single_layer_evaluate(layer, x, q, u, error));
cleanup:
  single_layer_free(layer);
  return status;
}

static FluidMethod method_of(const char *name) {
  if (strcmp(name, "direct") == 0) return FLUID_DIRECT;
  return strcmp(name, "fast") == 0 ? FLUID_FAST : FLUID_REFERENCE;
}

Status benchmark_layer(LayerError *result, Error *error) {
  Status status = STATUS_OK;
  Mesh mesh = {0};
  double *x = NULL, *q = NULL, *u = NULL, *best = NULL;
  TRY(mesh_sphere(&mesh, result->subdivisions, NULL, error));
  const size_t n = 3 * (size_t)mesh.n_nodes;
  TRY(ARRAY_NEW(&x, n, error));
  TRY(ARRAY_NEW(&q, n, error));
  TRY(ARRAY_NEW(&u, n, error));
  TRY(ARRAY_NEW(&best, n, error));
  for (int p = 0; p < mesh.n_nodes; p++)
    for (int c = 0; c < 3; c++) x[3 * p + c] = result->axes[c] * mesh.X[3 * p + c];
  translation_load(&mesh, result->axes, x, q);
  TRY(evaluate_layer(&mesh, method_of(result->method), x, q, u, error));
  TRY(evaluate_layer(&mesh, FLUID_REFERENCE, x, q, best, error));
  result->error = result->quadrature = 0;
  for (size_t i = 0; i < n; i += 3) {
    double exact = 0, difference = 0;
    for (size_t c = i; c < i + 3; c++) {
      exact += pow(u[c] - 1 / sqrt(3.0), 2);
      difference += pow(u[c] - best[c], 2);
    }
    result->error = fmax(result->error, sqrt(exact));
    result->quadrature = fmax(result->quadrature, sqrt(difference));
  }
cleanup:
  array_free(x);
  array_free(q);
  array_free(u);
  array_free(best);
  mesh_free(&mesh);
  return status;
}
