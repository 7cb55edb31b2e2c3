/* Generalised Hooke's law: tensions linear in the Green-Lagrange strain e_i = (l_i^2 - 1)/2 (Barthes-Biesel,
 * Diaz & Dhenin 2002). */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = G_s/4 [I1^2/(1 - nu_s) + 2 (I1 - I2)]\n"
    "    T1  = G_s/(1 - nu_s) (l1/l2) [l1^2 - 1 + nu_s (l2^2 - 1)]\n"
    "    K_s = (1 + nu_s)/(1 - nu_s) G_s\n"
    "\n"
    "nu_s = 1/2 is a thin sheet of an incompressible solid at small strain.  The law hardens under\n"
    "strain, and softens in compression: below l = 1/sqrt(3) a uniaxial force falls.\n"
    "`st_venant_kirchhoff` is the same energy with K_s in place of nu_s.\n";

enum { G_S, NU_S, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [NU_S] = {MLAW_NUMBER("nu_s", "surface Poisson ratio; K_s = (1 + nu_s)/(1 - nu_s) G_s"),
              .flags = MLAW_OPEN_LO | MLAW_OPEN_HI, .value = 0.5, MLAW_WITHIN(-1.0, 1.0),
              MLAW_FITTED(-0.5, 0.9)},
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
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "hooke", "1.0", "MIT", "the Capsella authors")
