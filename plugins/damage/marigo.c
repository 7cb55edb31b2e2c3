/* Marigo's brittle damage with linear hardening (Marigo 1981; Grandmaison et al. 2021, eq. 2.27-2.31). */
#include <mlaw/brief.h>

static const char about[] = "    drive      Y, the energy release rate\n"
                            "    threshold  f(Y; d) = Y - kappa(d) <= 0,   kappa(d) = Y_D + Y_C d\n"
                            "    evolution  zeta(Y) = <Y - Y_D>/Y_C\n"
                            "\n"
                            "Y_C = 0 is the brittle limit: the first Y beyond Y_D breaks the point.\n"
                            "\n"
                            "Associated; dissipation Y dd/dt >= 0.\n";

enum { Y_D, Y_C, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {MLAW_TENSION("Y_D", "energy release rate at which damage starts"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [Y_C] = {MLAW_TENSION("Y_C", "hardening modulus: rupture at Y_D + Y_C"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
};

static int threshold(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y], *d = a->d0;
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C];
  double *restrict f = a->f;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) f[i] = Y[i] - (mlaw_at(y_d, i) + mlaw_at(y_c, i) * d[i]);
  return MLAW_OK;
}

static int evolution(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C];
  const ptrdiff_t n = (ptrdiff_t)a->n;
  double *restrict zeta = a->zeta;
  for (ptrdiff_t i = 0; i < n; i++) zeta[i] = (Y[i] - mlaw_at(y_d, i)) / mlaw_not_zero(mlaw_at(y_c, i));
  if (a->dzeta) {
    double *restrict dzeta = a->dzeta;
    for (ptrdiff_t i = 0; i < n; i++) dzeta[i] = 1.0 / mlaw_not_zero(mlaw_at(y_c, i));
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "marigo",
    .title = "Brittle damage with linear hardening",
    .source = "Marigo, C. R. Acad. Sci. II 292 (1981); Grandmaison et al. 2021, eq. 2.27-2.31",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_Y,
    .threshold = threshold,
    .evolution = evolution,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "marigo", "1.0", "MIT", "the Capsella authors")
