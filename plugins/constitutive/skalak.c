/* Skalak's law: a network that resists area change apart from shear (Skalak et al. 1973). */
#include <mlaw/brief.h>

static const char about[] = "    phi = G_s/4 (I1^2 + 2 I1 - 2 I2 + C I2^2)\n"
                            "    K_s = (1 + 2C) G_s\n"
                            "\n"
                            "It hardens under strain; C about 1 for capsules, far above 1 for cells.\n";

enum { G_S, C, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [C] = {MLAW_NUMBER("C", "resistance to area change over resistance to shear; K_s = (1 + 2C) G_s"),
           .flags = MLAW_OPEN_LO, .value = 1.0, MLAW_WITHIN(-0.5, INFINITY), MLAW_FITTED(0.0, 1e5)},
};

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], c = a->param[C];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++)
      phi[i] = 0.25 * mlaw_at(G, i) * ((I1[i] + 2.0) * I1[i] + (mlaw_at(c, i) * I2[i] - 2.0) * I2[i]);
  }
  if (a->dphi) {
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      phi_1[i] = 0.5 * mlaw_at(G, i) * (I1[i] + 1.0);
      phi_2[i] = 0.5 * mlaw_at(G, i) * (mlaw_at(c, i) * I2[i] - 1.0);
    }
  }
  if (a->d2phi) {
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      phi_11[i] = 0.5 * mlaw_at(G, i);
      phi_12[i] = 0.0;
      phi_22[i] = 0.5 * mlaw_at(G, i) * mlaw_at(c, i);
    }
  }
  return MLAW_OK;
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "skalak",
    .title = "Skalak's membrane",
    .source = "Skalak, Tozeren, Zarda & Chien, Biophys. J. 13 (1973)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "skalak", "1.0", "MIT", "the Capsella authors")
