/* Generalised Hooke's law: tensions linear in the Green-Lagrange strain e_i = (l_i^2 - 1)/2
 * (Barthes-Biesel, Diaz & Dhenin 2002).
 *
 *     T1 = G_s/(1 - nu_s) (l1/l2) [l1^2 - 1 + nu_s (l2^2 - 1)]
 *     phi = G_s/4 [I1^2/(1 - nu_s) + 2 (I1 - I2)]
 *
 * K_s = (1 + nu_s)/(1 - nu_s) G_s; nu_s = 1/2 is a thin sheet of an incompressible solid at small strain.
 * It hardens under strain, and softens in compression: beyond l = 1/sqrt(3) a uniaxial force falls.
 * st_venant_kirchhoff is the same energy with K_s in place of nu_s. */
#include <math.h>
#include <mlaw/mlaw.h>

enum { G_S, NU_S, N_PARAMS };

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
    [NU_S] = {.name = "nu_s",
              .unit = "1",
              .about = "surface Poisson ratio; K_s = (1 + nu_s)/(1 - nu_s) G_s",
              .flags = MLAW_OPEN_LO | MLAW_OPEN_HI,
              .value = 0.5,
              .lo = -1.0,
              .hi = 1.0,
              .ok_lo = -0.5,
              .ok_hi = 0.9},
};

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], nu = a->param[NU_S];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++)
      phi[i] = 0.25 * mlaw_at(G, i) * (I1[i] * I1[i] / (1.0 - mlaw_at(nu, i)) + 2.0 * (I1[i] - I2[i]));
  }
  if (a->dphi) {
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      phi_1[i] = 0.5 * mlaw_at(G, i) * (I1[i] / (1.0 - mlaw_at(nu, i)) + 1.0);
      phi_2[i] = -0.5 * mlaw_at(G, i);
    }
  }
  if (a->d2phi) {
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      phi_11[i] = 0.5 * mlaw_at(G, i) / (1.0 - mlaw_at(nu, i));
      phi_12[i] = phi_22[i] = 0.0;
    }
  }
  return MLAW_OK;
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "hooke",
    .title = "Generalised Hooke's law",
    .source = "Barthes-Biesel, Diaz & Dhenin, J. Fluid Mech. 460 (2002)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
};

static const mlaw_energy *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "hooke",
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
