/* mlaw.h - laws for a membrane, as plugins.  ABI major 1.
 * SPDX-License-Identifier: MIT
 *
 * A plugin is a shared object that exports one function, mlaw_plugin_v1, which returns a table of laws.
 * A law is a pure function of a batch of points: it reads strains, parameters and old history, and writes
 * energies or damage and new history.  It keeps nothing, allocates nothing and calls nobody.  The host does
 * the rest: memory, time steps, units, ranges, irreversibility, caps, restarts, output.
 *
 * To write a law: `capsella laws new DIR --kind KIND`, change the mathematics, `make -C DIR check`.  That needs
 * nothing but this header (brief.h, which templates use, is shorthand for it) and a compiler:
 *     cc -std=c11 -O2 -fPIC -fvisibility=hidden -shared -o acme.so acme.c -lm
 *
 * STRAINS.  l1 >= l2 are the principal stretches of the surface.
 *     I1 = l1^2 + l2^2 - 2        I2 = l1^2 l2^2 - 1        both 0 at rest
 *     admissible: I2 > -1 and I1 >= 2 (sqrt(1 + I2) - 1), up to rounding; a law is handed nothing else
 * ENERGY.  phi(I1, I2) per unit of reference area, phi_1 = dphi/dI1 and so on.  The host derives
 *     tensions      T1 = 2 (l1/l2) (phi_1 + l2^2 phi_2), T2 with 1 and 2 exchanged
 *     at rest       no tension: phi_1 + phi_2 = 0
 *                   G_s = 2 phi_1, K_s = 4 (phi_11 + 2 phi_12 + phi_22) - G_s
 * DAMAGE.  d from 0 (sound) to 1 (broken) scales the tensions by 1 - d; it is driven by Y = phi of the
 * undamaged membrane or by other channels of the undamaged state.
 * NUMBERS.  All that a law sees is dimensionless: tensions and energies per area by a reference modulus,
 * lengths by the capsule's radius, times by 1/rate.  The numbers of its parameter table are of that kind too;
 * `unit` and `dim` say what a user may write in a scene and how the host scales it.
 *
 * RULES
 *  1. [load]   mlaw_plugin_v1: main thread; more than one call gives the same answer.
 *     [setup]  check: one thread, before the run.
 *     [kernel] eval, threshold, evolution, update: many threads at once on separate batches.  No allocation,
 *              input or output, lock, global variable, locale, signal, or change of the floating-point mode.
 *  2. Inputs are read only.  Outputs overlap neither inputs nor each other.  Every entry of an output that
 *     is asked for is written; of a two-dimensional array, [k][ld] with ld >= n, the entries n .. ld-1 are
 *     not touched.  Alignment is that of double.  n may be 0.
 *  3. A point depends on its own entries alone: results are the same for any batch it is part of.
 *  4. Pointers handed to a law die with the call.  Descriptors live for ever: make them `static const`.
 *  5. A law that cannot answer returns a status other than MLAW_OK and says which point and why in `err`
 *     (mlaw_fail does so).  What it wrote until then is thrown away.
 *  6. Strings are UTF-8 and never NULL.  Ids are `vendor.name` in lower case; an id is never reused for other
 *     mathematics (`acme.creep2` instead).
 *  7. No -ffast-math (it changes the host's floating-point mode) and no BLAS (its threads outlive a call).
 *
 * GROWTH.  Structures grow at the end only.  `size` is the sizeof of whoever filled the structure in: read
 * nothing beyond it (MLAW_HAS), and take what is absent as 0 or NULL.  A reserved field is 0.  A plugin
 * states the minor it was built with and the oldest host minor it can live with; nothing else decides whether
 * it loads.  A change of meaning is a new major: another symbol, mlaw_plugin_v2. */
#ifndef MLAW_H
#define MLAW_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define MLAW_ABI_MAJOR  1
#define MLAW_ABI_MINOR  1
#define MLAW_ENTRY_NAME "mlaw_plugin_v1"

#if defined(__GNUC__)
#define MLAW_EXPORT __attribute__((visibility("default")))
#else
#define MLAW_EXPORT
#endif

/* Is the field there in *object, as sized by whoever filled it in? */
#define MLAW_HAS(type, object, field)                                                                        \
  (offsetof(type, field) + sizeof(((const type *)0)->field) <= (size_t)(object)->size)

/* ---- Status and messages ---------------------------------------------------------------------------- */

enum {
  MLAW_OK = 0,
  MLAW_DOMAIN = 1,    /* outside the law's domain: the host tries a smaller step */
  MLAW_NOCONV = 2,    /* an inner iteration did not converge: the same */
  MLAW_BADPARAM = -1, /* the parameters cannot be used: the run stops */
  MLAW_BADARG = -2,   /* the host asked for what this law does not do: the same */
  MLAW_INTERNAL = -3  /* a fault of the law: the same */
};

/* Owned by the caller, never NULL; filled in only when the status is not MLAW_OK. */
typedef struct {
  int32_t status, reserved;
  int64_t point; /* first failing point of the batch, -1: none in particular */
  char text[240];
} mlaw_error;

/* `return mlaw_fail(a->err, MLAW_DOMAIN, i, "stretch beyond the limit");` */
static inline int mlaw_fail(mlaw_error *err, int status, int64_t point, const char *text) {
  size_t i = 0;
  for (; text[i] != '\0' && i + 1 < sizeof err->text; i++) err->text[i] = text[i];
  err->text[i] = '\0';
  err->status = status;
  err->point = point;
  return status;
}

/* ---- Tables: parameters and history variables -------------------------------------------------------- */

enum { MLAW_REQUIRED = 1u, MLAW_OPEN_LO = 2u, MLAW_OPEN_HI = 4u };

/* The host refuses values outside lo .. hi (the ends belong to it unless MLAW_OPEN_LO or _HI) and warns once
 * outside ok_lo .. ok_hi, the range in which the law was fitted or tested.  No limit: INFINITY. */
typedef struct {
  const char *name, *unit, *about; /* unit: SI, "N/m"; "1" when dimensionless */
  int8_t dim[4];                   /* powers of mass, length, time; the last is 0.  N/m: {1, 0, -2, 0} */
  uint32_t flags;
  double value; /* default; not used with MLAW_REQUIRED */
  double lo, hi;
  double ok_lo, ok_hi;
} mlaw_param;

/* A scalar of history at each point; the host stores it, carries it from step to step and to a restart. */
typedef struct {
  const char *name, *unit, *about;
  int8_t dim[4];
  uint32_t flags; /* 0 */
  double init;    /* at the start of the run */
} mlaw_var;

/* Values of a parameter over the batch: one for all (inc 0) or one for each point (inc 1). */
typedef struct {
  const double *v;
  ptrdiff_t inc;
} mlaw_field;

static inline double mlaw_at(mlaw_field field, ptrdiff_t point) {
  return field.v[field.inc * point];
}

/* ---- Energy laws ------------------------------------------------------------------------------------- */

/* An output that is NULL is not asked for. */
typedef struct {
  uint32_t size, reserved;
  int64_t n, ld;           /* points; leading dimension of the [k][ld] arrays */
  double t, dt;            /* the trial step goes from t to t + dt */
  const mlaw_field *param; /* [n_params], in the order of the table */
  const double *I1, *I2;   /* [n] at the end of the trial step */
  const double *state0;    /* [n_vars][ld] at t; NULL without variables */
  double *state1;          /* [n_vars][ld] at t + dt */
  double *phi;             /* [n] */
  double *dphi;            /* [2][ld] phi_1, phi_2 */
  double *d2phi;           /* [3][ld] phi_11, phi_12, phi_22; asked for only with MLAW_HESSIAN */
  mlaw_error *err;
} mlaw_energy_args;

enum { MLAW_HESSIAN = 1u }; /* eval gives d2phi; otherwise the host takes differences of dphi */

typedef struct {
  uint32_t size, flags;
  const char *id, *title, *source; /* source: where the law comes from, paper and equation */
  const mlaw_param *params;
  uint32_t n_params, param_size;                      /* param_size = sizeof(mlaw_param) */
  const mlaw_var *vars;                               /* NULL when there are none */
  uint32_t n_vars, var_size;                          /* var_size = sizeof(mlaw_var) */
  int (*check)(const double *param, mlaw_error *err); /* [setup] conditions across parameters, or NULL */
  int (*eval)(const mlaw_energy_args *a);             /* [kernel] */
  const char *about;                                  /* as in mlaw_damage; since 1.1 */
} mlaw_energy;

/* ---- Damage laws ------------------------------------------------------------------------------------- */

/* What may drive damage; all of the undamaged membrane. */
enum {
  MLAW_Y,  /* energy release rate Y = phi */
  MLAW_I1, /* invariants */
  MLAW_I2,
  MLAW_L1, /* principal stretches, L1 >= L2 */
  MLAW_L2,
  MLAW_T1, /* principal tensions, T1 >= T2 */
  MLAW_T2,
  MLAW_N_CHANNELS
};

typedef struct {
  uint32_t size, n_channels; /* n_channels: length of chan0 and chan, at least that of the plugin's minor */
  int64_t n, ld;
  double t, dt;
  const mlaw_field *param;
  const double *const *chan0; /* [n_channels][n] at t, for update; an entry not in `needs` is NULL */
  const double *const *chan;  /* [n_channels][n] the values to evaluate at; for update those at t + dt */
  const double *d0;           /* [n] damage at t */
  const double *state0;       /* [n_vars][ld] at t, for update */
  double *state1;             /* [n_vars][ld] at t + dt, for update */
  double *f;                  /* threshold: [n] f(Y; d0) */
  double *zeta;               /* evolution: [n] zeta(Y): finite; outside 0 .. 1 the host clips it */
  double *dzeta;              /* evolution: [n] its slope dzeta/dY, or NULL */
  double *d1;                 /* update: [n] damage at t + dt */
  mlaw_error *err;
} mlaw_damage_args;

/* A damage law is of one of two kinds.
 *
 * Explicit (threshold and evolution; update NULL; no variables; needs = 1u << MLAW_Y): damage is a function
 * of the largest Y so far.  Admissible are f(Y; d) <= 0; zeta never falls with Y, and f(Y; zeta(Y)) = 0.
 * The host does, at each point,   Ymax = max(Ymax, Y),   d = min(d_max, max(d, zeta(Ymax))).
 *
 * General (update; threshold and evolution NULL): the law names its channels in `needs` and steps damage and
 * its own variables from t to t + dt.  The host caps d1 at d_max and refuses d1 < d0. */
typedef struct {
  uint32_t size, flags; /* flags: 0 */
  const char *id, *title, *source;
  const mlaw_param *params;
  uint32_t n_params, param_size;
  const mlaw_var *vars;
  uint32_t n_vars, var_size;
  uint32_t needs, reserved; /* bits 1u << channel */
  int (*check)(const double *param, mlaw_error *err);
  int (*threshold)(const mlaw_damage_args *a);
  int (*evolution)(const mlaw_damage_args *a);
  int (*update)(const mlaw_damage_args *a);
  const char *about; /* what a reader should know, or NULL: equations on lines that begin with four blanks,
                      * sentences on others, blank lines between; for damage also whether it dissipates.
                      * Since 1.1 */
} mlaw_damage;

/* ---- The plugin -------------------------------------------------------------------------------------- */

typedef struct {
  uint32_t size;
  uint16_t abi_minor;      /* MLAW_ABI_MINOR of the header it was built with */
  uint16_t host_minor_min; /* oldest host minor that can run it */
  const char *id, *version, *license, *author;
  uint32_t n_energy, n_damage;
  const mlaw_energy *const *energy; /* [n_energy], NULL when there are none */
  const mlaw_damage *const *damage; /* [n_damage] */
} mlaw_plugin;

/* [load] The one exported symbol.  `host_minor` lets a newer plugin step down; NULL: it will not serve. */
MLAW_EXPORT const mlaw_plugin *mlaw_plugin_v1(uint32_t host_minor);
typedef const mlaw_plugin *mlaw_entry_fn(uint32_t host_minor);

#ifdef __cplusplus
}
#endif
#endif
