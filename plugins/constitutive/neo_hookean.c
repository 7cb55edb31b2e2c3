/* Neo-Hookean law: a thin sheet of an incompressible neo-Hookean solid (Barthes-Biesel, Diaz & Dhenin 2002).
 *
 *     phi = G_s/2 (I1 - 1 + 1/(1 + I2))
 *
 * written as I1 - I2/(1 + I2), which keeps its digits near rest.  K_s = 3 G_s.  It softens under large area
 * dilation. */
#include <math.h>
#include <mlaw/mlaw.h>

enum { G_S, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {.name = "G_s",
             .unit = "N/m",
             .about = "surface shear modulus at small strain",
             .dim = {1, 0, -2},
             .flags = MLAW_OPEN_LO,
             .value = 1.0,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
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
};

static const mlaw_energy *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "neo_hookean",
    .version = "1.0",
    .license = "MIT",
    .author = "the Capsella authors",
    .n_energy = 1,
    .energy = laws,
};

const mlaw_plugin *mlaw_plugin_v1(uint32_t host_minor) {
  (void)host_minor;
  return &plugin;
}
