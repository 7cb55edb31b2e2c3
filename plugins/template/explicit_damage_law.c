/* A damage law of the explicit kind, to start from: damage is a function of the largest Y so far.  Put
 * your f and zeta in place of these, and build it with
 *
 *     make check                         or, by hand,
 *     cc -std=c11 -O2 -fPIC -fvisibility=hidden -shared -I. -o newlaw.so newlaw.c -lm
 *     capsella laws check ./newlaw.so
 *
 * A scene takes it with `law: ./newlaw.so`, or `law: acme.newlaw` once the file lies in a folder of
 * MLAW_PLUGIN_PATH.  Here the hardening grows with damage.  The host keeps the largest Y, lets d only grow,
 * and caps it; a law never does.  The text is C11 and C++20. */
#include <mlaw/brief.h> /* shorthand for mlaw.h, which says what a law must do */

static const char about[] = /* equations begin with four blanks */
    "    drive      Y, the energy release rate\n"
    "    threshold  f(Y; d) = Y - kappa(d) <= 0,   kappa(d) = Y_D + Y_C (d + d^2)/2\n"
    "    evolution  zeta(Y) = (sqrt(1 + 8 x) - 1)/2,   x = (Y - Y_D)/Y_C\n"
    "\n"
    "Full damage at Y_D + Y_C.  Associated law; dissipation Y dd/dt >= 0.\n";

enum { Y_D, Y_C, N_PARAMS };

/* In the order of the enum: symbol and meaning (the macro gives the unit), default or MLAW_REQUIRED, the
 * range that is allowed, and the one in which the law was fitted or tested. */
static const mlaw_param params[N_PARAMS] = {
    {MLAW_TENSION("Y_D", "energy release rate at which damage starts"), .flags = MLAW_REQUIRED,
     MLAW_RANGE(0.0, INFINITY)},
    {MLAW_TENSION("Y_C", "hardening: rupture at Y_D + Y_C"), .flags = MLAW_REQUIRED | MLAW_OPEN_LO,
     MLAW_RANGE(0.0, INFINITY)},
};

/* f at (Y, d0): negative inside the elastic domain. */
static int threshold(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y], *d = a->d0;
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C];
  double *f = a->f;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++)
    f[i] = Y[i] - mlaw_at(y_d, i) - 0.5 * mlaw_at(y_c, i) * (d[i] + d[i] * d[i]);
  return MLAW_OK;
}

/* zeta at Y: the d at which f(Y; d) = 0.  Below 0 and above 1 the host clips it; it must be finite everywhere
 * and never fall with Y.  `dzeta` may be NULL. */
static int evolution(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C];
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double x = (Y[i] - mlaw_at(y_d, i)) / mlaw_at(y_c, i);
    const double root = sqrt(1.0 + 8.0 * (x > 0.0 ? x : 0.0));
    a->zeta[i] = x > 0.0 ? 0.5 * (root - 1.0) : 2.0 * x;
    if (a->dzeta) a->dzeta[i] = 2.0 / (root * mlaw_at(y_c, i));
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "acme.newlaw",
    .title = "Damage with hardening that grows with damage",
    .source = "say here where the law comes from: paper and equation",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_Y,
    .threshold = threshold,
    .evolution = evolution,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "acme.newlaw", "1.0", "MIT", "you")
