/* brief.h - optional: a law in fewer words.  All of it is shorthand for what mlaw.h says; C11 and C++20.
 * SPDX-License-Identifier: MIT
 *
 *     rows of tables    MLAW_TENSION, MLAW_TIME, MLAW_NUMBER; MLAW_RANGE, MLAW_WITHIN and MLAW_FITTED
 *     the plugin        MLAW_ENERGY_PLUGIN, MLAW_DAMAGE_PLUGIN
 *     two patterns      mlaw_curve_threshold and mlaw_curve_evolution: damage that is a function of Y
 *                       mlaw_linear_hardening: damage that is linear in the largest drive so far */
#ifndef MLAW_BRIEF_H
#define MLAW_BRIEF_H

#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

/* Fields that an initializer does not name are zero, as C and C++20 say; g++ warns of them all the same. */
#if defined(__cplusplus) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif

/* ---- Tables ---- */

/* The first fields of a row of parameters or variables, by what it measures:
 *     [Y_D] = {MLAW_TENSION("Y_D", "energy release rate at which damage starts"), .flags = MLAW_REQUIRED,
 *              MLAW_RANGE(0.0, INFINITY)}, */
#define MLAW_TENSION(symbol, meaning) .name = symbol, .unit = "N/m", .about = meaning, .dim = {1, 0, -2, 0}
#define MLAW_TIME(symbol, meaning)    .name = symbol, .unit = "s", .about = meaning, .dim = {0, 0, 1, 0}
#define MLAW_NUMBER(symbol, meaning)  .name = symbol, .unit = "1", .about = meaning, .dim = {0, 0, 0, 0}

/* The last fields of a row of parameters: what is allowed, and where the law was fitted or tested. */
#define MLAW_WITHIN(least, greatest) .lo = least, .hi = greatest
#define MLAW_FITTED(least, greatest) .ok_lo = least, .ok_hi = greatest
#define MLAW_RANGE(least, greatest)  MLAW_WITHIN(least, greatest), MLAW_FITTED(least, greatest)

/* ---- A plugin of one law ---- */

/* At the end of the file:  MLAW_DAMAGE_PLUGIN(law, "acme.tear", "1.0", "MIT", "you") */
#define MLAW_ENERGY_PLUGIN(law, plugin_id, plugin_version, plugin_license, plugin_author)                    \
  static const mlaw_energy *const mlaw_laws[] = {&law};                                                      \
  MLAW_PLUGIN(plugin_id, plugin_version, plugin_license, plugin_author, .n_energy = 1, .energy = mlaw_laws)

#define MLAW_DAMAGE_PLUGIN(law, plugin_id, plugin_version, plugin_license, plugin_author)                    \
  static const mlaw_damage *const mlaw_laws[] = {&law};                                                      \
  MLAW_PLUGIN(plugin_id, plugin_version, plugin_license, plugin_author, .n_damage = 1, .damage = mlaw_laws)

#define MLAW_PLUGIN(plugin_id, plugin_version, plugin_license, plugin_author, ...)                           \
  static const mlaw_plugin mlaw_self = {.size = sizeof(mlaw_plugin),                                         \
                                        .abi_minor = MLAW_ABI_MINOR,                                         \
                                        .host_minor_min = 0,                                                 \
                                        .id = plugin_id,                                                     \
                                        .version = plugin_version,                                           \
                                        .license = plugin_license,                                           \
                                        .author = plugin_author,                                             \
                                        __VA_ARGS__};                                                        \
  const mlaw_plugin *mlaw_plugin_v1(uint32_t host_minor) {                                                   \
    (void)host_minor;                                                                                        \
    return &mlaw_self;                                                                                       \
  }

/* ---- Patterns ---- */

/* In place of a hardening of 0, the brittle limit: any excess that counts divided by it is more than full
 * damage, and 0/0 does not arise. */
static inline double mlaw_not_zero(double hardening) {
  return hardening > FLT_MIN ? hardening : FLT_MIN;
}

/* Damage that is a function of the largest Y: zeta at point i and its slope.  Below the threshold zeta should
 * be negative, so that f = zeta - d is negative there even for d = 0. */
typedef struct {
  double zeta, slope;
} mlaw_curve;

typedef mlaw_curve mlaw_curve_fn(const mlaw_damage_args *a, ptrdiff_t i);

/* static int threshold(const mlaw_damage_args *a) { return mlaw_curve_threshold(a, curve); } */
static inline int mlaw_curve_threshold(const mlaw_damage_args *a, mlaw_curve_fn *curve) {
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) a->f[i] = curve(a, i).zeta - a->d0[i];
  return MLAW_OK;
}

/* static int evolution(const mlaw_damage_args *a) { return mlaw_curve_evolution(a, curve); } */
static inline int mlaw_curve_evolution(const mlaw_damage_args *a, mlaw_curve_fn *curve) {
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const mlaw_curve at = curve(a, i);
    a->zeta[i] = at.zeta;
    if (a->dzeta) a->dzeta[i] = at.slope;
  }
  return MLAW_OK;
}

/* Damage that is linear in the largest drive so far, which is the one variable of the law:
 *     d = <max drive - onset>/range,   0 below the onset and 1 at onset + range
 * `drive` gives that of point i.  It serves as `update`. */
typedef double mlaw_drive_fn(const mlaw_damage_args *a, ptrdiff_t i);

static inline int mlaw_linear_hardening(const mlaw_damage_args *a, mlaw_drive_fn *drive, mlaw_field onset,
                                        mlaw_field range) {
  const double *d0 = a->d0, *largest0 = a->state0;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double now = drive(a, i), largest = now > largest0[i] ? now : largest0[i];
    const double zeta = (largest - mlaw_at(onset, i)) / mlaw_not_zero(mlaw_at(range, i));
    const double d = zeta < 1.0 ? zeta : 1.0;
    a->state1[i] = largest;
    a->d1[i] = d > d0[i] ? d : d0[i];
  }
  return MLAW_OK;
}

#endif
