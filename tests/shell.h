/* A membrane on the unit sphere with the laws that ship, for tests. */
#ifndef CAPSELLA_TESTS_SHELL_H
#define CAPSELLA_TESTS_SHELL_H

#include "law_scene.h"
#include "membrane/membrane.h"
#include "random.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  Mesh mesh;
  Symmetry symmetry; /* used by the membrane when it has operations */
  Material material;
  Membrane *membrane;
  int n; /* 3 n_nodes */
} Shell;

/* The damage law of the paper's reference case. */
static const double Y_D = 0.2, Y_C = 2.0;

static inline SceneLaw no_law(void) {
  return scene_law(NULL, NULL, 0);
}

/* The membrane of a shell whose mesh and symmetry are there. */
static inline void shell_add_membrane(Shell *shell, SceneLaw elastic, SceneLaw damage, MassSolver solver) {
  Error error;
  const Symmetry *symmetry = shell->symmetry.n_operations > 0 ? &shell->symmetry : NULL;
  shell->material = make_material(elastic, damage);
  shell->n = 3 * shell->mesh.n_nodes;
  ck_assert_int_eq(membrane_new(&shell->membrane, &shell->mesh, symmetry, &shell->material,
                                (MembraneMethod){.solver = solver}, &error),
                   STATUS_OK);
}

/* `shell` must stay where it is until shell_close. */
static inline void shell_open_with(Shell *shell, int subdivisions, SceneLaw elastic, SceneLaw damage,
                                   MassSolver solver) {
  Error error;
  shell->symmetry = (Symmetry){0};
  ck_assert_int_eq(mesh_sphere(&shell->mesh, subdivisions, NULL, &error), STATUS_OK);
  shell_add_membrane(shell, elastic, damage, solver);
}

static inline void shell_open(Shell *shell, int subdivisions) {
  shell_open_with(shell, subdivisions, scene_law("neo_hookean", NULL, 0), no_law(), MASS_PCG);
}

static inline void shell_open_damaged(Shell *shell, int subdivisions) {
  SceneParameter parameters[] = {number("Y_D", Y_D), number("Y_C", Y_C)};
  shell_open_with(shell, subdivisions, scene_law("neo_hookean", NULL, 0), scene_law("marigo", parameters, 2),
                  MASS_PCG);
}

static inline void shell_close(Shell *shell) {
  membrane_free(shell->membrane);
  material_free(&shell->material);
  symmetry_free(&shell->symmetry);
  mesh_free(&shell->mesh);
}

/* An array of n zeros; the caller frees it. */
static inline double *zeros(int n) {
  double *values = calloc((size_t)n, sizeof *values);
  ck_assert_ptr_nonnull(values);
  return values;
}

/* x = F X */
static inline void shell_map(const Shell *shell, const double F[3][3], double *x) {
  for (int p = 0; p < shell->mesh.n_nodes; p++)
    for (int i = 0; i < 3; i++) {
      x[3 * p + i] = 0;
      for (int j = 0; j < 3; j++) x[3 * p + i] += F[i][j] * shell->mesh.X[3 * p + j];
    }
}

static inline void shell_inflate(const Shell *shell, double stretch, double *x) {
  for (int i = 0; i < shell->n; i++) x[i] = stretch * shell->mesh.X[i];
}

/* A stretched and sheared sphere with each node moved by up to `noise`. */
static inline void shell_crumple(const Shell *shell, double scale, double noise, uint64_t seed, double *x) {
  const double F[3][3] = {{1.3 * scale, 0.1, 0.3}, {0, 1.05 * scale, 0}, {0.1, 0, 0.9 * scale}};
  shell_map(shell, F, x);
  for (int i = 0; i < shell->n; i++) x[i] += noise * random_uniform(&seed);
}

static inline void must_force(Shell *shell, const double *x, double *R) {
  Error error;
  const Status status = membrane_force(shell->membrane, x, 0, 0.1, R, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
}

static inline void must_load(Shell *shell, const double *R, double *q) {
  Error error;
  const Status status = membrane_load(shell->membrane, LOAD_FULL, R, q, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
}

static inline double norm(int n, const double *a) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * a[i];
  return sqrt(sum);
}

static inline double dot(int n, const double *a, const double *b) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

#endif
