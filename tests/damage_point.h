/* One point of a membrane with a damage law, taken step by step along a path of channel values as the host
 * does it. */
#ifndef CAPSELLA_TESTS_DAMAGE_POINT_H
#define CAPSELLA_TESTS_DAMAGE_POINT_H

#include "law_scene.h"
#include <math.h>
#include <string.h>

enum { POINT_VARS = 4 };

typedef struct {
  Material material;
  double t, d, Ymax, state[POINT_VARS], chan[MLAW_N_CHANNELS];
} DamagePoint;

/* A sound point at rest, below a neo-Hookean membrane. */
static inline DamagePoint damage_point(const char *law, SceneParameter *parameters, size_t n) {
  const SceneLaw elastic = scene_law("neo_hookean", NULL, 0);
  DamagePoint point = {.material = make_material(elastic, scene_law(law, parameters, n)),
                       .chan = {[MLAW_L1] = 1.0, [MLAW_L2] = 1.0}};
  ck_assert_int_le(material_damage_vars(&point.material), POINT_VARS);
  if (material_damage_vars(&point.material))
    material_start_state(&point.material, LAW_DAMAGE, 1, 1, point.state);
  return point;
}

/* To the channel values `now` in one accepted step; returns d. */
static inline double damage_step(DamagePoint *point, const double now[MLAW_N_CHANNELS], double dt) {
  Error error;
  double Ymax, d, state[POINT_VARS];
  DamageBatch batch = {.n = 1,
                       .ld = 1,
                       .t = point->t,
                       .dt = dt,
                       .Ymax0 = &point->Ymax,
                       .d0 = &point->d,
                       .state0 = point->state,
                       .Ymax1 = &Ymax,
                       .d1 = &d,
                       .state1 = state};
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    batch.chan0[c] = &point->chan[c];
    batch.chan[c] = &now[c];
  }
  const Status status = material_damage(&point->material, &batch, NULL, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  point->t += dt;
  point->d = d;
  point->Ymax = Ymax;
  memcpy(point->state, state, (size_t)material_damage_vars(&point->material) * sizeof *state);
  memcpy(point->chan, now, sizeof point->chan);
  return d;
}

/* The same for a law that is driven by one channel. */
static inline double damage_drive(DamagePoint *point, int channel, double value, double dt) {
  double now[MLAW_N_CHANNELS];
  memcpy(now, point->chan, sizeof now);
  now[channel] = value;
  return damage_step(point, now, dt);
}

#endif
