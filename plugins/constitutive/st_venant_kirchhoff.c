/* St. Venant-Kirchhoff membrane: energy quadratic in the Green-Lagrange strain e, with a shear and an area
 * modulus. */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = K_s/2 (tr e)^2 + G_s dev(e):dev(e) = (K_s + G_s)/8 I1^2 + G_s/2 (I1 - I2)\n"
    "\n"
    "e is the Green-Lagrange strain.  The law hardens under strain, and softens in compression: below\n"
    "l = 1/sqrt(3) a uniaxial force falls.  The same energy as `hooke`, with K_s free: nu_s = (K_s -\n"
    "G_s)/(K_s + G_s).\n";

enum { G_S, K_S, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [K_S] = {MLAW_TENSION(
                 "K_s",
                 "area dilatation modulus at small strain; 3 G_s for a sheet of an incompressible solid"),
             .flags = MLAW_OPEN_LO, .value = 3.0, MLAW_RANGE(0.0, INFINITY)},
};

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], K = a->param[K_S];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++)
      phi[i] =
          0.125 * (mlaw_at(K, i) + mlaw_at(G, i)) * I1[i] * I1[i] + 0.5 * mlaw_at(G, i) * (I1[i] - I2[i]);
  }
  if (a->dphi) {
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      phi_1[i] = 0.25 * (mlaw_at(K, i) + mlaw_at(G, i)) * I1[i] + 0.5 * mlaw_at(G, i);
      phi_2[i] = -0.5 * mlaw_at(G, i);
    }
  }
  if (a->d2phi) {
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      phi_11[i] = 0.25 * (mlaw_at(K, i) + mlaw_at(G, i));
      phi_12[i] = phi_22[i] = 0.0;
    }
  }
  return MLAW_OK;
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "st_venant_kirchhoff",
    .title = "St. Venant-Kirchhoff membrane",
    .source = "Ciarlet, Mathematical Elasticity I, North-Holland (1988), in two dimensions",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "st_venant_kirchhoff", "1.0", "MIT", "the Capsella authors")
