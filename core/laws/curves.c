#include "laws/curves.h"

#include "base/array.h"
#include <math.h>
#include <string.h>

/* ---- Tensions ---- */

/* Energy and its derivatives at two stretches. */
typedef struct {
  double I1, I2, phi, dphi[2];
} Energy;

static Status find_energy(const Material *material, const double l[2], Energy *energy, Error *error) {
  const int n_vars = material_elastic_vars(material);
  double *state = NULL;
  Status status = ARRAY_NEW(&state, 2 * n_vars, error);
  if (status != STATUS_OK) return status;
  material_start_state(material, LAW_ENERGY, 1, 1, state);
  energy->I1 = l[0] * l[0] + l[1] * l[1] - 2;
  energy->I2 = l[0] * l[0] * l[1] * l[1] - 1;
  const ElasticBatch batch = {.n = 1,
                              .ld = 1,
                              .I1 = &energy->I1,
                              .I2 = &energy->I2,
                              .state0 = n_vars ? state : NULL,
                              .state1 = n_vars ? state + n_vars : NULL,
                              .phi = &energy->phi,
                              .dphi = energy->dphi};
  status = material_elastic(material, &batch, NULL, error);
  array_free(state);
  return status;
}

static void find_tensions(const Energy *energy, const double l[2], double T[2]) {
  for (int i = 0; i < 2; i++) {
    const double across = l[1 - i];
    T[i] = 2 * l[i] / across * (energy->dphi[0] + across * across * energy->dphi[1]);
  }
}

Status curve_tensions(const Material *material, const double l[2], double T[2], Error *error) {
  Energy energy;
  const Status status = find_energy(material, l, &energy, error);
  if (status == STATUS_OK) find_tensions(&energy, l, T);
  return status;
}

/* The stretch across at which there is no tension across, by bisection: tension grows with stretch. */
static Status relax(const Material *material, double l[2], Error *error) {
  double low = 0.02 / l[0], high = 1.5 * fmax(1, 1 / l[0]), T[2];
  Status status = STATUS_OK;
  for (int k = 0; k < 100; k++) {
    l[1] = 0.5 * (low + high);
    status = curve_tensions(material, l, T, error);
    if (status != STATUS_OK) break;
    if (T[1] > 0)
      high = l[1];
    else
      low = l[1];
  }
  return status;
}

Status curve_stretches(const Material *material, StretchMode mode, double along, double l[2], Error *error) {
  l[0] = along;
  l[1] = mode == STRETCH_EQUIBIAXIAL ? along : 1;
  return mode == STRETCH_UNIAXIAL ? relax(material, l, error) : STATUS_OK;
}

/* ---- Damage ---- */

/* The Y at which f(Y; d) = 0. */
static Status find_threshold(const Material *material, double d, double *Y, Error *error) {
  const mlaw_damage *law = material->damage.damage;
  double low = 0, high = 1e6, f;
  *Y = NAN;
  if (!law->threshold) return STATUS_OK;
  for (int k = 0; k < 100; k++) {
    const double middle = 0.5 * (low + high), *chan[MLAW_N_CHANNELS] = {[MLAW_Y] = &middle};
    mlaw_error err = {.point = -1};
    const mlaw_damage_args arguments = {.size = sizeof arguments,
                                        .n_channels = MLAW_N_CHANNELS,
                                        .n = 1,
                                        .ld = 1,
                                        .param = material->damage_field,
                                        .chan = chan,
                                        .d0 = &d,
                                        .f = &f,
                                        .err = &err};
    const int code = law->threshold(&arguments);
    if (code != MLAW_OK)
      return error_set(error, STATUS_REJECT, "law %s: no threshold at d = %g (status %d)", law->id, d, code);
    if (f > 0)
      high = middle;
    else
      low = middle;
  }
  if (high < 1e6) *Y = high;
  return STATUS_OK;
}

/* Channels of the undamaged membrane in pure shear. */
static Status find_channels(const Material *material, double stretch, double channel[MLAW_N_CHANNELS],
                            Error *error) {
  const double l[2] = {stretch, 1};
  const int larger = stretch >= 1 ? 0 : 1;
  Energy energy;
  double T[2];
  const Status status = find_energy(material, l, &energy, error);
  if (status != STATUS_OK) return status;
  find_tensions(&energy, l, T);
  channel[MLAW_Y] = energy.phi;
  channel[MLAW_I1] = energy.I1;
  channel[MLAW_I2] = energy.I2;
  channel[MLAW_L1] = l[larger];
  channel[MLAW_L2] = l[1 - larger];
  channel[MLAW_T1] = T[larger];
  channel[MLAW_T2] = T[1 - larger];
  return status;
}

/* History of one point. */
typedef struct {
  double t, Ymax, d, channel[MLAW_N_CHANNELS];
  double *state0, *state1; /* [n_vars] */
} PointHistory;

static Status advance(const Material *material, PointHistory *point, double dt,
                      const double channel[MLAW_N_CHANNELS], Error *error) {
  double Ymax, d;
  DamageBatch batch = {.n = 1,
                       .ld = 1,
                       .t = point->t,
                       .dt = dt,
                       .Ymax0 = &point->Ymax,
                       .d0 = &point->d,
                       .state0 = point->state0,
                       .Ymax1 = &Ymax,
                       .d1 = &d,
                       .state1 = point->state1};
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    batch.chan0[c] = &point->channel[c];
    batch.chan[c] = &channel[c];
  }
  const Status status = material_damage(material, &batch, NULL, error);
  if (status != STATUS_OK) return status;
  memcpy(point->channel, channel, sizeof point->channel);
  memcpy(point->state0, point->state1, (size_t)material_damage_vars(material) * sizeof *point->state0);
  point->t += dt;
  point->Ymax = Ymax;
  point->d = d;
  return status;
}

Status curve_damage(const Material *material, int n, const double *stretch, double rate, DamageState *state,
                    Error *error) {
  const int n_vars = material_damage_vars(material);
  PointHistory point = {.channel = {[MLAW_L1] = 1, [MLAW_L2] = 1}};
  double before = 1;
  Status status;
  TRY(ARRAY_NEW(&point.state0, n_vars, error));
  TRY(ARRAY_NEW(&point.state1, n_vars, error));
  material_start_state(material, LAW_DAMAGE, 1, 1, point.state0);
  for (int k = 0; k < n; k++) {
    DamageState *now = &state[k];
    now->stretch = stretch[k];
    TRY(find_channels(material, stretch[k], now->channel, error));
    TRY(advance(material, &point, fabs(stretch[k] - before) / rate, now->channel, error));
    TRY(find_threshold(material, point.d, &now->threshold, error));
    now->d = point.d;
    now->tension = (1 - point.d) * now->channel[stretch[k] >= 1 ? MLAW_T1 : MLAW_T2];
    before = stretch[k];
  }
cleanup:
  array_free(point.state0);
  array_free(point.state1);
  return status;
}
