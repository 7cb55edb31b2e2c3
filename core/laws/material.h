/* A material: an energy law and, if any, a damage law, with parameter values and everything that the ABI
 * leaves to the host: defaults, ranges, scales, irreversibility, capping, checks of what a law returns.
 *
 * All values are dimensionless: tensions and energies per area by G (a shear modulus), lengths by a, times by
 * 1/rate. */
#ifndef CAPSELLA_LAWS_MATERIAL_H
#define CAPSELLA_LAWS_MATERIAL_H

#include "base/log.h"
#include "base/status.h"
#include "config/scene.h"
#include "laws/failure.h"
#include "laws/loader.h"
#include "laws/parameters.h"
#include <stdbool.h>

typedef struct {
  LoadedLaw elastic;
  LoadedLaw damage; /* damage.damage == NULL: none */
  ParameterValues elastic_values, damage_values;
  mlaw_field *elastic_field, *damage_field; /* [n_params] views of the above, from element 0 on */
  double d_max;
  double nonlocal_length;    /* over which what drives damage is averaged; 0: not at all */
  double shear_modulus;      /* G_s = 2 phi_1 at rest, for the means of parameters that vary */
  double dilatation_modulus; /* K_s = 4 (phi_11 + 2 phi_12 + phi_22) - G_s at rest, for the same */
} Material;

/* Loads both laws of the scene, fills parameters (convert units -> hard range -> law's own check ->
 * calibrated range, a warning in `log`), and measures the moduli at rest, which must be those of a stable,
 * stress-free membrane in every element.  `scales` are used when flow.is_physical; `place` is what parameters
 * that vary are laid over (NULL: they are refused). */
Status material_new(Material *material, const Scene *scene, const LawSearch *search, const LawScales *scales,
                    const FieldPlace *place, Log *log, Error *error);
/* A material that only damages: the law of a criterion, which looks on, in the same way.  Everything of the
 * elastic law is zero. */
Status material_criterion(Material *material, const Scene *scene, const SceneLaw *law,
                          const LawSearch *search, const LawScales *scales, const FieldPlace *place, Log *log,
                          Error *error);
void material_free(Material *material);

/* Leaves of every parameter that varies the values at the `n` elements kept[0] < kept[1] < ..., which are
 * numbered anew. */
void material_keep_elements(Material *material, const int *kept, int n);

/* A batch of points handed to the elastic law: those of elements `first` to first + n - 1 (0 where no
 * parameter varies).  I1, I2 [n] in; phi [n], dphi [2][ld] and d2phi [3][ld] out
 * (each may be NULL; d2phi is for laws with MLAW_HESSIAN only). state0/state1 [n_vars][ld], NULL when the law
 * has no variables.  STATUS_REJECT when the law refuses a point or returns a value that is not finite;
 * STATUS_FAILED when it says stop.  `point` (may be NULL) receives the failing one, `failure` (may be NULL)
 * the batch when it is the law that fails. */
typedef struct {
  ptrdiff_t n, ld, first;
  double t, dt;
  const double *I1, *I2;
  const double *state0;
  double *state1;
  double *phi, *dphi, *d2phi;
  LawFailure *failure;
} ElasticBatch;
Status material_elastic(const Material *material, const ElasticBatch *batch, ptrdiff_t *point, Error *error);

/* A batch handed to the damage law.  chan[MLAW_Y] (the energy release rate Y = phi of the undamaged membrane)
 * is always needed; the other channels only when material_channels says so. Ymax1 = max(Ymax0, Y);  explicit
 * kind: d1 = min(d_max, max(d0, <zeta(Ymax1)>)); general kind: d1 from update(), refused below d0, capped at
 * d_max. Points whose Ymax did not grow keep d0 without a call where the kind allows. */
typedef struct {
  ptrdiff_t n, ld, first; /* as above */
  double t, dt;
  const double *chan0[MLAW_N_CHANNELS]; /* at the accepted step; NULL where not asked for */
  const double *chan[MLAW_N_CHANNELS];  /* now */
  const double *Ymax0, *d0, *state0;    /* accepted */
  double *Ymax1, *d1, *state1;          /* trial, written in full */
  LawFailure *failure;                  /* as above */
} DamageBatch;
Status material_damage(const Material *material, const DamageBatch *batch, ptrdiff_t *point, Error *error);

/* Bit mask (1u << channel) of what the damage law reads; MLAW_Y is always set when there is a damage law. */
unsigned material_channels(const Material *material);

bool material_has_damage(const Material *material);
int material_elastic_vars(const Material *material); /* history variables per point */
int material_damage_vars(const Material *material);

/* state [n_vars][ld]: the history variables of one of the laws at the start of a run. */
void material_start_state(const Material *material, LawKind kind, ptrdiff_t n, ptrdiff_t ld, double *state);

#endif
