/* Creep damage of Kachanov (1958) and Rabotnov (1969): under a lasting tension damage grows with time. */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      T1, the larger principal tension of the undamaged membrane\n"
    "    threshold  damage grows where T1 > T_D\n"
    "    evolution  dd/dt = (<T1 - T_D>/T_R)^r (1 - d)^(r - k)/tau\n"
    "\n"
    "With T_D = 0 this is (sigma/T_R)^r (1 - d)^-k/tau for the carried tension sigma = (1 - d) T1:\n"
    "Kachanov's law when k = r, with rupture at t = tau/(r + 1) (T_R/sigma)^r under constant sigma.\n"
    "The step is the exact solution with the rate factor held at its mean over the step: stable for\n"
    "any dt, of second order.\n"
    "\n"
    "Not associated; dissipation Y dd/dt >= 0, since d never falls.\n";

enum { T_R, R, K, TAU, T_D, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [T_R] = {MLAW_TENSION("T_R", "tension at which damage grows at the rate 1/tau"),
             .flags = MLAW_REQUIRED | MLAW_OPEN_LO, MLAW_RANGE(0.0, INFINITY)},
    [R] = {MLAW_NUMBER("r", "exponent of tension"), .flags = MLAW_OPEN_LO, .value = 4.0,
           MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(1.0, 15.0)},
    [K] = {MLAW_NUMBER("k", "exponent of what is left, 1 - d, under constant carried tension"), .value = 4.0,
           MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.0, 20.0)},
    [TAU] = {MLAW_TIME("tau", "time to full damage under a tension kept at T_R, when k = r"),
             .flags = MLAW_REQUIRED | MLAW_OPEN_LO, MLAW_RANGE(0.0, INFINITY)},
    [T_D] = {MLAW_TENSION("T_D", "tension that does no harm for ever"), .value = 0.0,
             MLAW_RANGE(0.0, INFINITY)},
};

static inline double overload(double T, double t_d, double t_r, double r) {
  const double power = T > t_d ? pow((T - t_d) / t_r, r) : 0.0;
  return power < DBL_MAX ? power : DBL_MAX; /* so that 0 * infinity does not arise in a step of no length */
}

/* The share of 1 - d that is lost over y = growth/(1 - d)^m, where m = k - r + 1 and (1 - d)^m falls by
 * m growth: 1 - (1 - m y)^(1/m), all of it once m y >= 1, and 1 - exp(-y) for m = 0. */
static inline double share_lost(double m, double y) {
  if (m * y >= 1.0) return 1.0;
  return -expm1(fabs(m) < 1e-9 ? -y : log1p(-m * y) / m);
}

static int update(const mlaw_damage_args *a) {
  const double *before = a->chan0[MLAW_T1], *now = a->chan[MLAW_T1], *d0 = a->d0;
  const mlaw_field t_r = a->param[T_R], r = a->param[R], k = a->param[K], tau = a->param[TAU],
                   t_d = a->param[T_D];
  double *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double overload0 = overload(before[i], mlaw_at(t_d, i), mlaw_at(t_r, i), mlaw_at(r, i)),
                 overload1 = overload(now[i], mlaw_at(t_d, i), mlaw_at(t_r, i), mlaw_at(r, i));
    const double growth = (0.5 * overload0 + 0.5 * overload1) * a->dt / mlaw_at(tau, i);
    const double left = 1.0 - d0[i], m = mlaw_at(k, i) - mlaw_at(r, i) + 1.0;
    d[i] = left > 0.0 && growth > 0.0 ? d0[i] + left * share_lost(m, growth / pow(left, m)) : d0[i];
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "creep",
    .title = "Creep damage",
    .source =
        "Kachanov, Izv. Akad. Nauk SSSR OTN 8 (1958); Rabotnov, Creep Problems in Structural Members (1969)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_T1,
    .update = update,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "creep", "1.0", "MIT", "the Capsella authors")
