/* What the material remembers at the integration points: made, started and committed. */
#include "base/array.h"
#include "membrane/membrane_private.h"
#include <string.h>

Status membrane_history_new(MembraneHistory *history, const Membrane *m, Error *error) {
  Status status = STATUS_OK;
  const size_t n = (size_t)m->n_points;
  const int elastic_vars = material_elastic_vars(m->material),
            damage_vars = material_damage_vars(m->material);
  if (elastic_vars > 0) TRY(ARRAY_NEW(&history->elastic_state, n * (size_t)elastic_vars, error));
  if (m->has_damage) {
    TRY(ARRAY_NEW(&history->Ymax, n, error));
    TRY(ARRAY_NEW(&history->d, n, error));
    if (damage_vars > 0) TRY(ARRAY_NEW(&history->damage_state, n * (size_t)damage_vars, error));
  }
  if (m->channel_history)
    for (int c = 0; c < MLAW_N_CHANNELS; c++)
      if (m->channels & (1u << c)) TRY(ARRAY_NEW(&history->channel[c], n, error));
  if (m->is_nonlocal && history == &m->accepted) TRY(ARRAY_NEW(&history->Y, n, error));
cleanup:
  return status;
}

void membrane_history_free(MembraneHistory *history) {
  array_free(history->Ymax);
  array_free(history->d);
  array_free(history->elastic_state);
  array_free(history->damage_state);
  array_free(history->Y);
  for (int c = 0; c < MLAW_N_CHANNELS; c++) array_free(history->channel[c]);
}

void membrane_history_start(MembraneHistory *history, const Membrane *m) {
  if (history->elastic_state)
    material_start_state(m->material, LAW_ENERGY, m->n_points, m->n_points, history->elastic_state);
  if (history->damage_state)
    material_start_state(m->material, LAW_DAMAGE, m->n_points, m->n_points, history->damage_state);
  for (int c = MLAW_L1; c <= MLAW_L2; c++)
    if (history->channel[c])
      for (int k = 0; k < m->n_points; k++) history->channel[c][k] = 1;
}

void membrane_commit(Membrane *m) {
  const size_t bytes = (size_t)m->n_points * sizeof(double);
  const MembraneHistory *from = &m->trial, *to = &m->accepted;
  if (m->has_damage) {
    memcpy(to->Ymax, from->Ymax, bytes);
    memcpy(to->d, from->d, bytes);
  }
  if (to->elastic_state)
    memcpy(to->elastic_state, from->elastic_state, (size_t)material_elastic_vars(m->material) * bytes);
  if (to->damage_state)
    memcpy(to->damage_state, from->damage_state, (size_t)material_damage_vars(m->material) * bytes);
  for (int c = 0; c < MLAW_N_CHANNELS; c++)
    if (to->channel[c]) memcpy(to->channel[c], from->channel[c], bytes);
  if (to->Y) memcpy(to->Y, m->phi, bytes);
}
