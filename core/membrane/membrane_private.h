/* What membrane.c, membrane_history.c and membrane_fields.c share. */
#ifndef CAPSELLA_MEMBRANE_MEMBRANE_PRIVATE_H
#define CAPSELLA_MEMBRANE_MEMBRANE_PRIVATE_H

#include "membrane/assembly.h"
#include "membrane/element_kernel.h"
#include "membrane/mass.h"
#include "membrane/membrane.h"
#include "membrane/quartic.h"
#include "membrane/surface_average.h"

struct Membrane {
  const Mesh *mesh;
  const Material *material;
  const Symmetry *symmetry;
  Symmetry own_symmetry; /* the trivial one, when none was given */
  int n_elements;        /* computed: one of each orbit */
  int n_points;
  bool has_damage;
  unsigned channels;    /* what the damage law reads, bit mask */
  bool channel_history; /* a damage law of the general kind also reads the accepted values */
  ElementBasis basis;
  Interpolation interpolation;
  QuarticBasis quartic; /* filled in where it is used */
  double rule_weight[RULE_POINTS];

  /* Reference configuration, [n_points]. */
  double *A11, *A12, *A22, *inverse_det, *dS0;
  double *weight; /* dS0 times the number of elements in the orbit: sum f weight integrates over the whole
                     surface */

  /* Last evaluation, [n_points]; dphi [2][n_points]. */
  double *I1, *I2, *J, *phi, *dphi;
  double *channel[MLAW_N_CHANNELS]; /* owned, but for MLAW_Y, I1, I2, which are views of the above */
  double *drive[MLAW_N_CHANNELS]; /* what the damage law is handed: the channels or, non-local, their means */
  double *element_force;          /* [18][n_elements] */
  double *element_mass;           /* [21][n_elements] */

  MembraneHistory accepted, trial;
  bool is_nonlocal;
  SurfaceAverage average; /* non-local only */
  Assembly assembly;
  MassSystem mass;
  LawFailure failure; /* of the last evaluation */
  LawWatch *watch;    /* [LAW_WATCHES] or NULL */
};

/* ---- membrane_history.c ---- */

/* Arrays for what the laws of the membrane remember, which it knows already; none of what they do not. */
Status membrane_history_new(MembraneHistory *history, const Membrane *m, Error *error);
void membrane_history_free(MembraneHistory *history);

/* History variables start at the values that their law declares, channels at those of the undeformed
 * membrane. */
void membrane_history_start(MembraneHistory *history, const Membrane *m);

/* ---- membrane.c ---- */

/* Base vectors of computed elements first .. first + n - 1 from positions (or velocities) x [n_nodes][3]. */
void membrane_base_vectors(const Membrane *m, int first, int n, const double *x, ElementBlock *block);

ReferenceMetric membrane_metric(const Membrane *m, int first);

/* Number of computed elements in the block that begins with `first`. */
int membrane_block_size(const Membrane *m, int first);

#endif
