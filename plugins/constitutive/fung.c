/* Fung's exponential law: a thin sheet of an incompressible soft tissue (Fung 1967; isotropic form of
 * Demiray 1972). */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = G_s/(2 b) [exp(b x) - 1],   x = l1^2 + l2^2 + 1/(l1 l2)^2 - 3 = I1 - I2/(1 + I2)\n"
    "    K_s = 3 G_s\n"
    "\n"
    "b = 0 is `neo_hookean`.  A stretch whose energy has no finite value is outside the domain.\n";

enum { G_S, B, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [B] = {MLAW_NUMBER("b", "rate of hardening; 0: neo-Hookean"), .value = 1.0, MLAW_WITHIN(0.0, INFINITY),
           MLAW_FITTED(0.0, 20.0)},
};

/* exp(500) = 1e217 leaves room for the factors of the second derivatives. */
static const double LARGEST_EXPONENT = 500.0;

static inline double extension(double I1, double I2) {
  return I1 - I2 / (1.0 + I2);
}

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], b = a->param[B];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  for (ptrdiff_t i = 0; i < n; i++)
    if (!(mlaw_at(b, i) * extension(I1[i], I2[i]) < LARGEST_EXPONENT))
      return mlaw_fail(a->err, MLAW_DOMAIN, i, "stretch whose exponential energy is beyond all numbers");

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double rate = mlaw_at(b, i) > FLT_MIN ? mlaw_at(b, i) : FLT_MIN; /* 0/0 does not arise */
      phi[i] = 0.5 * mlaw_at(G, i) * expm1(rate * extension(I1[i], I2[i])) / rate;
    }
  }
  if (a->dphi) { /* x_1 = 1, x_2 = -u^2 */
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]);
      const double slope = 0.5 * mlaw_at(G, i) * exp(mlaw_at(b, i) * (I1[i] - I2[i] * u));
      phi_1[i] = slope;
      phi_2[i] = -u * u * slope;
    }
  }
  if (a->d2phi) { /* x_22 = 2 u^3 */
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]);
      const double slope = 0.5 * mlaw_at(G, i) * exp(mlaw_at(b, i) * (I1[i] - I2[i] * u));
      const double curvature = mlaw_at(b, i) * slope;
      phi_11[i] = curvature;
      phi_12[i] = -u * u * curvature;
      phi_22[i] = u * u * u * (2.0 * slope + u * curvature);
    }
  }
  return MLAW_OK;
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "fung",
    .title = "Fung's exponential membrane",
    .source = "Fung, Am. J. Physiol. 213 (1967); Demiray, J. Biomech. 5 (1972)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "fung", "1.0", "MIT", "the Capsella authors")
