#include "study/onset.h"

#include <math.h>

static const double SMALLEST = 1e-9, LARGEST = 1e9;
enum { HALVINGS = 100, SCAN = 400 };

/* d at the largest Y so far. */
static Status damage_at(const Material *material, double Y, double *d, Error *error) {
  const double none = 0;
  double largest;
  DamageBatch batch = {.n = 1, .ld = 1, .Ymax0 = &none, .d0 = &none, .Ymax1 = &largest, .d1 = d};
  batch.chan[MLAW_Y] = &Y;
  return material_damage(material, &batch, NULL, error);
}

static bool is_uniform(const Material *material) {
  for (uint32_t i = 0; i < material->damage.damage->n_params; i++)
    if (material->damage_field[i].inc != 0) return false;
  return true;
}

/* The Y beyond which the law gives more damage than `level`; LARGEST when none does. */
static Status find_level(const Material *material, double level, double *Y, Error *error) {
  Status status = STATUS_OK;
  double low = 0, high = SMALLEST, d;
  for (;; high *= 2) {
    TRY(damage_at(material, high, &d, error));
    if (d > level || high > LARGEST) break;
    low = high;
  }
  for (int k = 0; k < HALVINGS && high <= LARGEST; k++) {
    const double middle = 0.5 * (low + high);
    TRY(damage_at(material, middle, &d, error));
    *(d > level ? &high : &low) = middle;
  }
  *Y = high;
cleanup:
  return status;
}

static Status find_severity(const Material *material, double from, double *severity, Error *error) {
  Status status = STATUS_OK;
  double to;
  *severity = from;
  TRY(find_level(material, 0.999, &to, error));
  const double start = fmax(from, SMALLEST), ratio = to / start;
  for (int k = 1; k <= SCAN && ratio > 1; k++) {
    const double Y = start * pow(ratio, (double)k / SCAN);
    double d;
    TRY(damage_at(material, Y, &d, error));
    *severity = fmax(*severity, (1 - d) * (1 - d) * Y);
  }
cleanup:
  return status;
}

Status damage_onset(const Material *material, bool *known, DamageOnset *onset, Error *error) {
  Status status = STATUS_OK;
  *known = material_has_damage(material) && !material->damage.damage->update && is_uniform(material) &&
           material->nonlocal_length == 0;
  if (!*known) return STATUS_OK;
  TRY(find_level(material, 0, &onset->onset, error));
  *known = onset->onset < LARGEST;
  TRY(find_severity(material, onset->onset, &onset->severity, error));
  onset->onset /= material->shear_modulus;
  onset->severity /= material->shear_modulus;
cleanup:
  return status;
}
