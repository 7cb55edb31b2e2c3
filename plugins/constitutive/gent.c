/* Gent's law: a thin sheet of an incompressible solid whose chains cannot be stretched beyond a limit (Gent
 * 1996). */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = -G_s/2 J_m ln(1 - x/J_m),   x = l1^2 + l2^2 + 1/(l1 l2)^2 - 3 = I1 - I2/(1 + I2) < J_m\n"
    "    K_s = 3 G_s\n"
    "\n"
    "J_m without bound is `neo_hookean`.  A point at or beyond the limit is outside the domain.\n";

enum { G_S, J_M, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [J_M] = {MLAW_NUMBER(
                 "J_m",
                 "limit of l1^2 + l2^2 + 1/(l1 l2)^2 - 3: rubbers 30 to 100, walls of arteries 0.4 to 2.3"),
             .flags = MLAW_OPEN_LO, .value = 50.0, MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.4, 120.0)},
};

static inline double extension(double I1, double I2) {
  return I1 - I2 / (1.0 + I2);
}

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], J_m = a->param[J_M];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  for (ptrdiff_t i = 0; i < n; i++)
    if (!(extension(I1[i], I2[i]) < mlaw_at(J_m, i)))
      return mlaw_fail(a->err, MLAW_DOMAIN, i, "stretch at the limit J_m or beyond it");

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++)
      phi[i] = -0.5 * mlaw_at(G, i) * mlaw_at(J_m, i) * log1p(-extension(I1[i], I2[i]) / mlaw_at(J_m, i));
  }
  if (a->dphi) { /* x_1 = 1, x_2 = -u^2 */
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]), left = 1.0 - extension(I1[i], I2[i]) / mlaw_at(J_m, i);
      const double slope = 0.5 * mlaw_at(G, i) / left;
      phi_1[i] = slope;
      phi_2[i] = -u * u * slope;
    }
  }
  if (a->d2phi) { /* x_22 = 2 u^3 */
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]), left = 1.0 - extension(I1[i], I2[i]) / mlaw_at(J_m, i);
      const double slope = 0.5 * mlaw_at(G, i) / left, curvature = slope / (left * mlaw_at(J_m, i));
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
    .id = "gent",
    .title = "Gent's membrane with limited stretch",
    .source = "Gent, Rubber Chem. Technol. 69 (1996); J_m of arteries: Horgan & Saccomandi, Biomech. Model. "
              "Mechanobiol. 1 (2003)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "gent", "1.0", "MIT", "the Capsella authors")
