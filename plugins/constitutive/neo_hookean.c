/* Neo-Hookean law: a thin sheet of an incompressible neo-Hookean solid (Barthes-Biesel, Diaz & Dhenin 2002).
 */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = G_s/2 (I1 - 1 + 1/(1 + I2))\n"
    "    T1  = G_s/(l1 l2) [l1^2 - 1/(l1 l2)^2]\n"
    "    K_s = 3 G_s\n"
    "\n"
    "A thin sheet of an incompressible neo-Hookean solid.  It softens under large area dilation.\n";

enum { G_S, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
};

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++) phi[i] = 0.5 * mlaw_at(G, i) * (I1[i] - I2[i] / (1.0 + I2[i]));
  }
  if (a->dphi) {
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]);
      phi_1[i] = 0.5 * mlaw_at(G, i);
      phi_2[i] = -0.5 * mlaw_at(G, i) * u * u;
    }
  }
  if (a->d2phi) {
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]);
      phi_11[i] = phi_12[i] = 0.0;
      phi_22[i] = mlaw_at(G, i) * u * u * u;
    }
  }
  return MLAW_OK;
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "neo_hookean",
    .title = "Neo-Hookean membrane",
    .source = "Barthes-Biesel, Diaz & Dhenin, J. Fluid Mech. 460 (2002); Grandmaison et al. 2021, eq. 2.14",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "neo_hookean", "1.0", "MIT", "the Capsella authors")
