/* A capsule in a flow, for tests: a shell (shell.h) with the fluid around it. */
#ifndef CAPSELLA_TESTS_CAPSULE_H
#define CAPSELLA_TESTS_CAPSULE_H

#include "coupling/system.h"
#include "shell.h"

static const double SIMPLE_SHEAR[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
static const double NO_FLOW[3][3] = {{0}};

typedef struct {
  Shell shell;
  Flow flow;
  SingleLayer *layer;
  CoarseLayer *coarse; /* NULL: inner stages are summed as all else */
  CoupledSystem system;
} Capsule;

/* Puts the shell, which is open, into the flow; `capsule` must stay where it is until capsule_close. */
static inline void capsule_immerse(Capsule *capsule, const double gradient[3][3], double capillary_number,
                                   FluidMethod method, bool keep_volume) {
  Error error;
  const double mobility = 1 / (capillary_number * capsule->shell.material.shear_modulus);
  capsule->coarse = NULL;
  flow_linear(&capsule->flow, gradient);
  ck_assert_int_eq(single_layer_new(&capsule->layer, &capsule->shell.mesh, method, &error), STATUS_OK);
  ck_assert_int_eq(system_new(&capsule->system, &capsule->shell.mesh, capsule->shell.membrane, capsule->layer,
                              &capsule->flow, mobility, keep_volume, &error),
                   STATUS_OK);
}

/* Inner stages by the coarse rule from now on. */
static inline void capsule_use_coarse(Capsule *capsule) {
  Error error;
  ck_assert_int_eq(coarse_layer_new(&capsule->coarse, &capsule->shell.mesh, NULL, &error), STATUS_OK);
  ck_assert_int_eq(system_use_coarse(&capsule->system, capsule->coarse, &error), STATUS_OK);
}

/* A neo-Hookean capsule without damage. */
static inline void capsule_open(Capsule *capsule, int subdivisions, const double gradient[3][3],
                                double capillary_number, bool keep_volume) {
  shell_open(&capsule->shell, subdivisions);
  capsule_immerse(capsule, gradient, capillary_number, FLUID_FAST, keep_volume);
}

static inline void capsule_close(Capsule *capsule) {
  system_free(&capsule->system);
  single_layer_free(capsule->layer);
  coarse_layer_free(capsule->coarse);
  shell_close(&capsule->shell);
}

static inline void must_move(Capsule *capsule, const double *x, double *v) {
  Error error;
  const Status status = system_velocity(&capsule->system, x, 0, 0.1, v, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
}

#endif
