/* A damage law of the general kind, to start from: damage and history variables step from t to t + dt, driven
 * by the channels that the law asks for.  Rename it, write your step, and build it with
 *
 *     make check                         or, by hand,
 *     cc -std=c11 -O2 -fPIC -fvisibility=hidden -shared -I. -o newlaw.so newlaw.c -lm
 *     capsella laws check ./newlaw.so
 *
 * A scene takes it with `law: ./newlaw.so`, or `law: acme.newlaw` once the file lies in a folder of
 * MLAW_PLUGIN_PATH.  Here damage grows with time wherever the largest principal tension is beyond a strength,
 * and the time spent there is kept.  The host caps d and refuses one that falls.  The text is C11 and C++20.
 */
#include <math.h>
#include <mlaw/mlaw.h>

enum { T_R, TAU, N_PARAMS };
enum { OVERLOADED, N_VARS };

/* In the order of the enum: name, SI unit, meaning, powers of mass, length and time, default, hard range,
 * range of calibration. */
static const mlaw_param params[N_PARAMS] = {
    {.name = "T_R",
     .unit = "N/m",
     .about = "strength: principal tension of the undamaged membrane beyond which damage grows",
     .dim = {1, 0, -2},
     .flags = MLAW_REQUIRED | MLAW_OPEN_LO,
     .lo = 0.0,
     .hi = INFINITY,
     .ok_lo = 0.0,
     .ok_hi = INFINITY},
    {.name = "tau",
     .unit = "s",
     .about = "time to full damage at twice the strength",
     .dim = {0, 0, 1},
     .flags = MLAW_OPEN_LO,
     .value = 1.0,
     .lo = 0.0,
     .hi = INFINITY,
     .ok_lo = 0.0,
     .ok_hi = INFINITY},
};

/* History at each point, kept by the host; restarts carry it. */
static const mlaw_var vars[N_VARS] = {
    {.name = "overloaded",
     .unit = "s",
     .about = "time spent beyond the strength",
     .dim = {0, 0, 1},
     .init = 0.0},
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

static const char about[] = /* equations begin with four blanks */
    "    drive      T1, the larger principal tension of the undamaged membrane\n"
    "    threshold  damage grows where T1 > T_R\n"
    "    evolution  dd/dt = <T1/T_R - 1>/tau, trapezoidal in time\n"
    "\n"
    "Not associated; dissipation Y dd/dt >= 0.\n";

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

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "acme.newlaw",
    .version = "1.0",
    .license = "MIT",
    .author = "you",
    .n_damage = 1,
    .damage = laws,
};

const mlaw_plugin *mlaw_plugin_v1(uint32_t host_minor) {
  (void)host_minor;
  return &plugin;
}
