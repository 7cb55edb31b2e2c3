/* Evans and Skalak's law: area and shape store energy apart, for the membranes of cells (Evans & Skalak
 * 1980). */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = K_s/2 (J - 1)^2 + G_s/2 [(I1 + 2)/J - 2],   J = l1 l2 = sqrt(1 + I2)\n"
    "    T1  = K_s (J - 1) + G_s/2 (1/l2^2 - 1/l1^2)\n"
    "\n"
    "Red cells have K_s of order 10^4 to 10^5 G_s: such stiff values ask for very short steps.\n";

enum { G_S, K_S, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [K_S] = {MLAW_TENSION("K_s", "area dilatation modulus; 3 G_s for a sheet of an incompressible solid"),
             .flags = MLAW_OPEN_LO, .value = 3.0, MLAW_RANGE(0.0, INFINITY)},
};

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], K = a->param[K_S];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double J = sqrt(1.0 + I2[i]), dilation = I2[i] / (1.0 + J); /* J - 1, to all digits */
      phi[i] = 0.5 * mlaw_at(K, i) * dilation * dilation + 0.5 * mlaw_at(G, i) * (I1[i] - 2.0 * dilation) / J;
    }
  }
  if (a->dphi) {
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double J = sqrt(1.0 + I2[i]), dilation = I2[i] / (1.0 + J);
      phi_1[i] = 0.5 * mlaw_at(G, i) / J;
      phi_2[i] = (0.5 * mlaw_at(K, i) * dilation - 0.25 * mlaw_at(G, i) * (I1[i] + 2.0) / (J * J)) / J;
    }
  }
  if (a->d2phi) {
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double J = sqrt(1.0 + I2[i]), J3 = J * J * J;
      phi_11[i] = 0.0;
      phi_12[i] = -0.25 * mlaw_at(G, i) / J3;
      phi_22[i] = (0.25 * mlaw_at(K, i) + 0.375 * mlaw_at(G, i) * (I1[i] + 2.0) / (J * J)) / J3;
    }
  }
  return MLAW_OK;
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "evans_skalak",
    .title = "Evans and Skalak's membrane",
    .source = "Evans & Skalak, Mechanics and Thermodynamics of Biomembranes, CRC Press (1980)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "evans_skalak", "1.0", "MIT", "the Capsella authors")
