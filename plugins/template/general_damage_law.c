/* A damage law of the general kind, to start from: damage and history variables step from t to t + dt, driven
 * by the channels that the law asks for.  Put your step in place of this one, and build it with
 *
 *     make check                         or, by hand,
 *     cc -std=c11 -O2 -fPIC -fvisibility=hidden -shared -I. -o newlaw.so newlaw.c -lm
 *     capsella laws check ./newlaw.so
 *
 * A scene takes it with `law: ./newlaw.so`, or `law: acme.newlaw` once the file lies in a folder of
 * MLAW_PLUGIN_PATH.  Here damage grows with time wherever the largest principal tension is beyond a strength,
 * and the time spent there is kept.  The host caps d and refuses one that falls.  The text is C11 and C++20.
 */
#include <mlaw/brief.h> /* shorthand for mlaw.h, which says what a law must do */

static const char about[] = /* equations begin with four blanks */
    "    drive      T1, the larger principal tension of the undamaged membrane\n"
    "    threshold  damage grows where T1 > T_R\n"
    "    evolution  dd/dt = <T1/T_R - 1>/tau, trapezoidal in time\n"
    "\n"
    "Not associated; dissipation Y dd/dt >= 0.\n";

enum { T_R, TAU, N_PARAMS };
enum { OVERLOADED, N_VARS };

/* In the order of the enum: symbol and meaning (the macro gives the unit), default or MLAW_REQUIRED, the
 * range that is allowed, and the one in which the law was fitted or tested. */
static const mlaw_param params[N_PARAMS] = {
    {MLAW_TENSION("T_R", "strength: principal tension of the undamaged membrane beyond which damage grows"),
     .flags = MLAW_REQUIRED | MLAW_OPEN_LO, MLAW_RANGE(0.0, INFINITY)},
    {MLAW_TIME("tau", "time to full damage at twice the strength"), .flags = MLAW_OPEN_LO, .value = 1.0,
     MLAW_RANGE(0.0, INFINITY)},
};

/* History at each point, kept by the host; restarts carry it. */
static const mlaw_var vars[N_VARS] = {
    {MLAW_TIME("overloaded", "time spent beyond the strength"), .init = 0.0},
};

static double excess(double tension, double strength) {
  return tension > strength ? tension / strength - 1.0 : 0.0;
}

/* chan0 at t, chan at t + dt; d0 and state0 are only read, d1 and state1 are written at every point.
 * dt may be 0. */
static int update(const mlaw_damage_args *a) {
  const double *before = a->chan0[MLAW_T1], *now = a->chan[MLAW_T1];
  const double *time0 = a->state0 + OVERLOADED * a->ld;
  double *time1 = a->state1 + OVERLOADED * a->ld;
  const mlaw_field strength = a->param[T_R], tau = a->param[TAU];
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double rate = 0.5 *
                        (excess(before[i], mlaw_at(strength, i)) + excess(now[i], mlaw_at(strength, i))) /
                        mlaw_at(tau, i);
    a->d1[i] = a->d0[i] + a->dt * rate;
    time1[i] = time0[i] + (now[i] > mlaw_at(strength, i) ? a->dt : 0.0);
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "acme.newlaw",
    .title = "Damage that grows with time under overload",
    .source = "say here where the law comes from: paper and equation",
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

MLAW_DAMAGE_PLUGIN(law, "acme.newlaw", "1.0", "MIT", "you")
