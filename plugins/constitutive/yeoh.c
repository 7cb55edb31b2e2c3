/* Yeoh's law: a thin sheet of an incompressible solid whose energy is a cubic in x (Yeoh 1993). */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = G_s/2 (x + c_2 x^2 + c_3 x^3),   x = l1^2 + l2^2 + 1/(l1 l2)^2 - 3 = I1 - I2/(1 + I2)\n"
    "    K_s = 3 G_s\n"
    "\n"
    "c_2 = c_3 = 0 is `neo_hookean`.  A filled rubber has c_2 < 0 < c_3: it softens, then hardens.\n";

enum { G_S, C_2, C_3, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [C_2] = {MLAW_NUMBER("c_2", "second coefficient over the first; negative: softening at moderate strain"),
             .value = 0.0, MLAW_WITHIN(-INFINITY, INFINITY), MLAW_FITTED(-0.5, 1.0)},
    [C_3] = {MLAW_NUMBER("c_3", "third coefficient over the first: hardening at large strain"), .value = 0.0,
             MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.0, 1.0)},
};

/* Stable under any stretch: 1 + 2 c_2 x + 3 c_3 x^2 > 0 for all x >= 0. */
static int check(const double *param, mlaw_error *err) {
  const double c2 = param[C_2], c3 = param[C_3];
  if (c2 >= 0.0 || c2 * c2 < 3.0 * c3) return MLAW_OK;
  return mlaw_fail(err, MLAW_BADPARAM, -1, "expected c_2 > -sqrt(3 c_3): the energy falls at large stretch");
}

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], c2 = a->param[C_2], c3 = a->param[C_3];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double x = I1[i] - I2[i] / (1.0 + I2[i]);
      phi[i] = 0.5 * mlaw_at(G, i) * x * (1.0 + x * (mlaw_at(c2, i) + x * mlaw_at(c3, i)));
    }
  }
  if (a->dphi) { /* x_1 = 1, x_2 = -u^2 */
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]), x = I1[i] - I2[i] * u;
      const double slope =
          0.5 * mlaw_at(G, i) * (1.0 + x * (2.0 * mlaw_at(c2, i) + 3.0 * x * mlaw_at(c3, i)));
      phi_1[i] = slope;
      phi_2[i] = -u * u * slope;
    }
  }
  if (a->d2phi) { /* x_22 = 2 u^3 */
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]), x = I1[i] - I2[i] * u;
      const double slope =
          0.5 * mlaw_at(G, i) * (1.0 + x * (2.0 * mlaw_at(c2, i) + 3.0 * x * mlaw_at(c3, i)));
      const double curvature = mlaw_at(G, i) * (mlaw_at(c2, i) + 3.0 * x * mlaw_at(c3, i));
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
    .id = "yeoh",
    .title = "Yeoh's membrane",
    .source = "Yeoh, Rubber Chem. Technol. 66 (1993)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .check = check,
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "yeoh", "1.0", "MIT", "the Capsella authors")
