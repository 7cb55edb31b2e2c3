/* Fatigue: every cycle of tension adds damage, by its range (Basquin 1910; Palmgren 1924; Miner 1945). */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      T1, the larger principal tension of the undamaged membrane\n"
    "    threshold  T_E, the endurance limit: cycles whose range is at most T_E do no harm\n"
    "    evolution  each cycle adds D(range) = (<range - T_E>/T_F)^m,\n"
    "               hence rupture after (T_F/(range - T_E))^m cycles\n"
    "\n"
    "Cycles are counted while they run.  A rise starts at a valley `low`; what it adds is D(T1 - low),\n"
    "hence grows with T1 without jumps and is complete at the peak `high`.  A fall by more than T_E\n"
    "ends it and the next rise starts at the lowest value that follows: smaller falls do not cut a\n"
    "rise in two (racetrack filter; Fuchs, Nelson, Burke & Toomay 1973), hence T_E should exceed the\n"
    "noise of T1.  The first loading is a cycle too.  Independent of rate and of steps as long as they\n"
    "meet the turning points.\n"
    "\n"
    "Not associated; dissipation Y dd/dt >= 0, since d never falls.\n";

enum { T_E, T_F, M, N_PARAMS };
enum { LOW, HIGH, CYCLES, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [T_E] = {MLAW_TENSION("T_E", "endurance limit: range of tension that does no harm"),
             .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
    [T_F] = {MLAW_TENSION("T_F", "range beyond T_E of a cycle that breaks the membrane at once"),
             .flags = MLAW_REQUIRED | MLAW_OPEN_LO, MLAW_RANGE(0.0, INFINITY)},
    [M] = {MLAW_NUMBER("m", "exponent of the range"), .flags = MLAW_OPEN_LO, .value = 3.0,
           MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(1.0, 15.0)},
};

static const mlaw_var vars[N_VARS] = {
    [LOW] = {MLAW_TENSION("low", "tension at which the present rise started"), .init = 0.0},
    [HIGH] = {MLAW_TENSION("high", "largest tension of the present rise"), .init = 0.0},
    [CYCLES] = {MLAW_NUMBER("cycles", "rises beyond the endurance limit so far"), .init = 0.0},
};

/* Damage of a cycle of this range, at most all. */
static inline double damage_of(double range, double t_e, double t_f, double m) {
  const double damage = range > t_e ? pow((range - t_e) / t_f, m) : 0.0;
  return damage < 1.0 ? damage : 1.0;
}

static int update(const mlaw_damage_args *a) {
  const ptrdiff_t ld = (ptrdiff_t)a->ld;
  const double *T1 = a->chan[MLAW_T1], *d0 = a->d0;
  const double *low0 = a->state0 + LOW * ld, *high0 = a->state0 + HIGH * ld,
               *cycles0 = a->state0 + CYCLES * ld;
  const mlaw_field endurance = a->param[T_E], t_f = a->param[T_F], m = a->param[M];
  double *restrict low = a->state1 + LOW * ld, *restrict high = a->state1 + HIGH * ld,
                   *restrict cycles = a->state1 + CYCLES * ld, *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double T = T1[i], t_e = mlaw_at(endurance, i);
    const int turned = T < low0[i] || T < high0[i] - t_e;
    low[i] = turned ? T : low0[i];
    high[i] = turned || T > high0[i] ? T : high0[i];
    const double range0 = turned ? 0.0 : high0[i] - low0[i], range = high[i] - low[i];
    const double more = damage_of(range, t_e, mlaw_at(t_f, i), mlaw_at(m, i)) -
                        damage_of(range0, t_e, mlaw_at(t_f, i), mlaw_at(m, i));
    d[i] = d0[i] + more;
    cycles[i] = cycles0[i] + (range > t_e && range0 <= t_e ? 1.0 : 0.0);
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "fatigue",
    .title = "Fatigue damage, cycle by cycle",
    .source = "Basquin, Proc. ASTM 10 (1910); Palmgren (1924); Miner, J. Appl. Mech. 12 (1945); Fuchs et "
              "al., SAE 730565 (1973)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .vars = vars,
    .n_vars = N_VARS,
    .var_size = sizeof(mlaw_var),
    .needs = 1u << MLAW_T1,
    .update = update,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "fatigue", "1.0", "MIT", "the Capsella authors")
