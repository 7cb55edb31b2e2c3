/* A law of the membrane's elasticity, to start from: put your phi in place of this one, and build it with
 *
 *     make check                         or, by hand,
 *     cc -std=c11 -O2 -fPIC -fvisibility=hidden -shared -I. -o newlaw.so newlaw.c -lm
 *     capsella laws check ./newlaw.so
 *
 * A scene takes it with `law: ./newlaw.so`, or `law: acme.newlaw` once the file lies in a folder of
 * MLAW_PLUGIN_PATH.  This one is a neo-Hookean sheet that resists area change by an extra modulus.  The text
 * is C11 and C++20. */
#include <mlaw/brief.h> /* shorthand for mlaw.h, which says what a law must do */

static const char about[] = /* equations begin with four blanks */
    "    phi = G_s/2 (I1 - I2/(1 + I2)) + A/8 I2^2\n"
    "    K_s = 3 G_s + A\n"
    "\n"
    "Say here what the law is good for and how it behaves.\n";

/* The parameters, by the place they have in the table and in a->param. */
enum { G_S, A, N_PARAMS };

/* In the order of the enum: symbol and meaning (the macro gives the unit), default or MLAW_REQUIRED, the
 * range that is allowed, and the one in which the law was fitted or tested. */
static const mlaw_param params[N_PARAMS] = {
    {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO, .value = 1.0,
     MLAW_RANGE(0.0, INFINITY)},
    {MLAW_TENSION("A", "resistance to area change beyond that of the neo-Hookean sheet"), .value = 0.0,
     MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.0, 100.0)},
};

/* One plain loop for each output that is asked for: compilers turn these into vector code. */
static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field g = a->param[G_S], area = a->param[A]; /* the same for all points, or one value each */
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++)
      phi[i] =
          0.5 * mlaw_at(g, i) * (I1[i] - I2[i] / (1.0 + I2[i])) + 0.125 * mlaw_at(area, i) * I2[i] * I2[i];
  }
  if (a->dphi) { /* first derivatives: with respect to I1, then I2 */
    double *phi_1 = a->dphi, *phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]);
      phi_1[i] = 0.5 * mlaw_at(g, i);
      phi_2[i] = -0.5 * mlaw_at(g, i) * u * u + 0.25 * mlaw_at(area, i) * I2[i];
    }
  }
  if (a->d2phi) { /* second derivatives: 11, 12, 22; leave this and MLAW_HESSIAN out if you have none */
    double *phi_11 = a->d2phi, *phi_12 = a->d2phi + ld, *phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]);
      phi_11[i] = phi_12[i] = 0.0;
      phi_22[i] = mlaw_at(g, i) * u * u * u + 0.25 * mlaw_at(area, i);
    }
  }
  return MLAW_OK; /* or: return mlaw_fail(a->err, MLAW_DOMAIN, i, "why point i is beyond this law"); */
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "acme.newlaw",
    .title = "Neo-Hookean sheet with extra resistance to area change",
    .source = "say here where the law comes from: paper and equation",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "acme.newlaw", "1.0", "MIT", "you")
