/* Mooney-Rivlin law: a thin sheet of an incompressible Mooney-Rivlin solid (Mooney 1940, Rivlin 1948; as a
 * membrane Barthes-Biesel, Diaz & Dhenin 2002). */
#include <mlaw/brief.h>

static const char about[] =
    "    phi = G_s/2 {Psi (I1 - u I2) + (1 - Psi) [I2 + u (I1 - 2 I2)]},   u = 1/(1 + I2)\n"
    "    T1  = G_s/(l1 l2) [l1^2 - 1/(l1 l2)^2] [Psi + (1 - Psi) l2^2]\n"
    "    K_s = 3 G_s\n"
    "\n"
    "Psi = 1 is `neo_hookean`; the smaller Psi, the harder it is under equal stretches and the softer\n"
    "when pulled one way.\n";

enum { G_S, PSI, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [G_S] = {MLAW_TENSION("G_s", "surface shear modulus at small strain"), .flags = MLAW_OPEN_LO,
             .value = 1.0, MLAW_RANGE(0.0, INFINITY)},
    [PSI] = {MLAW_NUMBER("Psi", "share of the first invariant in the shear modulus; 1: neo-Hookean"),
             .value = 0.5, MLAW_RANGE(0.0, 1.0)},
};

static int eval(const mlaw_energy_args *a) {
  const double *I1 = a->I1, *I2 = a->I2;
  const mlaw_field G = a->param[G_S], psi = a->param[PSI];
  const ptrdiff_t n = (ptrdiff_t)a->n, ld = (ptrdiff_t)a->ld;

  if (a->phi) {
    double *restrict phi = a->phi;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]), p = mlaw_at(psi, i);
      phi[i] =
          0.5 * mlaw_at(G, i) * (p * (I1[i] - u * I2[i]) + (1.0 - p) * (I2[i] + u * (I1[i] - 2.0 * I2[i])));
    }
  }
  if (a->dphi) {
    double *restrict phi_1 = a->dphi, *restrict phi_2 = a->dphi + ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]), p = mlaw_at(psi, i);
      phi_1[i] = 0.5 * mlaw_at(G, i) * (p + (1.0 - p) * u);
      phi_2[i] = 0.5 * mlaw_at(G, i) * ((1.0 - p) * (1.0 - (I1[i] + 2.0) * u * u) - p * u * u);
    }
  }
  if (a->d2phi) {
    double *restrict phi_11 = a->d2phi, *restrict phi_12 = a->d2phi + ld,
                     *restrict phi_22 = a->d2phi + 2 * ld;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double u = 1.0 / (1.0 + I2[i]), p = mlaw_at(psi, i);
      phi_11[i] = 0.0;
      phi_12[i] = -0.5 * mlaw_at(G, i) * (1.0 - p) * u * u;
      phi_22[i] = mlaw_at(G, i) * (p + (1.0 - p) * (I1[i] + 2.0)) * u * u * u;
    }
  }
  return MLAW_OK;
}

static const mlaw_energy law = {
    .size = sizeof(mlaw_energy),
    .flags = MLAW_HESSIAN,
    .id = "mooney_rivlin",
    .title = "Mooney-Rivlin membrane",
    .source = "Mooney, J. Appl. Phys. 11 (1940); Rivlin, Phil. Trans. A 241 (1948); Barthes-Biesel, Diaz & "
              "Dhenin, J. Fluid Mech. 460 (2002)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .eval = eval,
    .about = about,
};

MLAW_ENERGY_PLUGIN(law, "mooney_rivlin", "1.0", "MIT", "the Capsella authors")
