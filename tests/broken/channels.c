/* Not a fault: two laws of the general kind that write down what they are given.
 * channels.all keeps every channel at both ends of the step in its history; channels.few reads two of them
 * and fails when it is handed any other. */
#include "fixture.h"

enum { NOW = 0, BEFORE = MLAW_N_CHANNELS, TIME = 2 * MLAW_N_CHANNELS, N_VARS };

#define VAR(text, start)                                                                                     \
  { .name = text, .unit = "1", .about = "what was handed over", .init = start }

ONE_PARAMETER("rate");
static const mlaw_var vars[N_VARS] = {
    VAR("Y", -1.0),   VAR("I1", -1.0),  VAR("I2", -1.0),  VAR("L1", -1.0),  VAR("L2", -1.0),
    VAR("T1", -1.0),  VAR("T2", -1.0),  VAR("Y0", -1.0),  VAR("I10", -1.0), VAR("I20", -1.0),
    VAR("L10", -1.0), VAR("L20", -1.0), VAR("T10", -1.0), VAR("T20", -1.0), VAR("time", 0.5),
};

static void grow(const mlaw_damage_args *a, const double *tension) {
  for (ptrdiff_t i = 0; i < a->n; i++)
    a->d1[i] = a->d0[i] + a->dt * mlaw_at(a->param[0], i) * fmax(tension[i], 0.0);
}

static int update_all(const mlaw_damage_args *a) {
  for (int c = 0; c < MLAW_N_CHANNELS; c++)
    for (ptrdiff_t i = 0; i < a->n; i++) {
      a->state1[(NOW + c) * a->ld + i] = a->chan[c][i];
      a->state1[(BEFORE + c) * a->ld + i] = a->chan0[c][i];
    }
  for (ptrdiff_t i = 0; i < a->n; i++) a->state1[TIME * a->ld + i] = a->state0[TIME * a->ld + i] + a->dt;
  grow(a, a->chan[MLAW_T1]);
  return MLAW_OK;
}

enum { FEW = 1u << MLAW_L1 | 1u << MLAW_T1 };

static int update_few(const mlaw_damage_args *a) {
  for (int c = 0; c < (int)a->n_channels; c++)
    if ((a->chan[c] != NULL) != (FEW >> c & 1u) || (a->chan0[c] != NULL) != (FEW >> c & 1u))
      return mlaw_fail(a->err, MLAW_BADARG, -1, "channels other than those asked for");
  grow(a, a->chan[MLAW_T1]);
  return MLAW_OK;
}

static const mlaw_damage all = {
    ALIKE(mlaw_damage, "channels.all"),   .vars = vars,        .n_vars = N_VARS, .var_size = sizeof(mlaw_var),
    .needs = (1u << MLAW_N_CHANNELS) - 1, .update = update_all};
static const mlaw_damage few = {ALIKE(mlaw_damage, "channels.few"), .needs = FEW, .update = update_few};
static const mlaw_damage *const laws[] = {&all, &few};
static const mlaw_plugin plugin = {PLUGIN_HEAD("channels"), .n_damage = 2, .damage = laws};
ENTRY(&plugin)
