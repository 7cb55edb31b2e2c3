/* The solid problem (paper sections 2.2, 2.3, 3.2): from positions to tensions, internal force R, load q and
 * trial damage.
 *
 * Integration points: six per computed element (one of each orbit of the symmetry); that of orbit e and rule
 * point g has index g * n_orbits + e in every [n_points] array.  Trial and accepted damage are apart:
 * membrane_force writes the trial, membrane_commit accepts it. */
#ifndef CAPSELLA_MEMBRANE_MEMBRANE_H
#define CAPSELLA_MEMBRANE_MEMBRANE_H

#include "base/status.h"
#include "laws/material.h"
#include "laws/watch.h"
#include "membrane/mass.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"
#include <stdbool.h>

enum { POINTS_PER_ELEMENT = 6 };

/* History of the material at the integration points; what a restart needs. */
typedef struct {
  double *Ymax, *d;                     /* [n_points]; NULL without a damage law */
  double *elastic_state, *damage_state; /* [n_vars][n_points]; NULL when there are none */
  double
      *channel[MLAW_N_CHANNELS]; /* [n_points] values at the accepted step, only those the damage law reads */
  double *Y; /* [n_points] with a non-local drive of damage: at each point itself; NULL otherwise */
} MembraneHistory;

typedef struct Membrane Membrane;

typedef struct {
  MassSolver solver;
  Interpolation interpolation; /* of positions, for the stretches (docs/decisions/quartic.md) */
} MembraneMethod;

/* Reference metric once, from mesh->X.  Mesh, symmetry (NULL: none is used) and material must outlive the
 * membrane.  STATUS_INPUT: degenerate mesh, or quartic interpolation on an icosahedron not halved.  With a
 * symmetry, positions and loads are whole fields that have it, and one element of each orbit is computed. */
Status membrane_new(Membrane **membrane, const Mesh *mesh, const Symmetry *symmetry, const Material *material,
                    MembraneMethod method, Error *error);
void membrane_free(Membrane *membrane);

/* R [n_nodes][3] from positions x [n_nodes][3] at time t + dt, where t is the time of the accepted history
 * (paper eq. 3.2), and the trial damage.  STATUS_REJECT: inverted element, law out of its domain, value not
 * finite. */
Status membrane_force(Membrane *membrane, const double *x, double t, double dt, double *R, Error *error);

/* The batch on which a law failed in the last membrane_force; n is 0 when it did not. */
const LawFailure *membrane_law_failure(const Membrane *membrane);

/* From now on the laws being called are told in `watch` [LAW_WATCHES], which must outlive the membrane. */
void membrane_watch_laws(Membrane *membrane, LawWatch *watch);

/* M q = R on the surface at the positions of the last membrane_force (paper eq. 3.4a).  q [n_nodes][3] holds
 * the start of the iteration on entry. */
Status membrane_load(Membrane *membrane, LoadAccuracy accuracy, const double *R, double *q, Error *error);

/* Accepts the trial history of the last membrane_force; the trial state stays readable. */
void membrane_commit(Membrane *membrane);

int membrane_points(const Membrane *membrane);
const MembraneHistory *membrane_accepted(const Membrane *membrane);
MembraneHistory *membrane_restored(Membrane *membrane); /* to fill in from a snapshot */
const MembraneHistory *membrane_trial(const Membrane *membrane);

/* Values at the positions of the last membrane_force; pointers into the membrane, [n_points]. */
typedef struct {
  const double *phi; /* energy per reference area of the undamaged membrane = Y */
  const double *J;   /* area ratio dS/dS0 */
  const double *dS0; /* reference area weight: sum f dS0 integrates over the reference surface */
  const double *d;   /* trial damage; NULL without a damage law */
} MembranePoints;
MembranePoints membrane_points_view(const Membrane *membrane);

/* What may drive damage, of the undamaged membrane: fills in those of the arrays [n_points] that are not
 * NULL. */
void membrane_channels(const Membrane *membrane, double *const channel[MLAW_N_CHANNELS]);

/* Index of the largest of `value` [n_points]: the first of those that are equal by symmetry. */
int membrane_largest(const Membrane *membrane, const double *value);

/* By how much the largest trial damage exceeds the largest accepted one; 0 without a damage law. */
double membrane_damage_growth(const Membrane *membrane);

/* Share of the reference area on which d [n_points] is above 0. */
double membrane_damaged_area(const Membrane *membrane, const double *d);

/* The same on which the membrane is compressed: the smaller principal tension T2 [n_points] is negative.
 * There a membrane without bending stiffness wrinkles, at the scale of the mesh. */
double membrane_compressed_area(const Membrane *membrane, const double *T2);

/* Principal tensions T1 >= T2 of the damaged membrane at the integration points, [n_points] each (any may be
 * NULL). */
void membrane_principal_tensions(const Membrane *membrane, double *T1, double *T2);

/* A field known at the integration points, at the nodes: element-wise least-squares plane through the six
 * values, averaged over the elements at a node with weights dS0, and clipped to the range of those values. */
void membrane_nodal_field(const Membrane *membrane, const double *point_values, double *node_values);

/* Elastic energy int (1 - d) phi dS0 of the last evaluation. */
double membrane_energy(const Membrane *membrane);
/* Energy per reference area that damage releases where it grows, and damage, [n_points] each; NULL without a
 * damage law. */
typedef struct {
  const double *Y, *d;
} MembraneRelease;
MembraneRelease membrane_release_accepted(const Membrane *membrane);
MembraneRelease membrane_release_trial(const Membrane *membrane);
/* Gradient of that energy at frozen damage, [n_nodes][3], where x are the positions of the last
 * membrane_force: its product with velocities is the rate at which the membrane takes up energy.  R is handed
 * in as found there, which is the gradient with quadratic interpolation, and is replaced with quartic. */
void membrane_energy_gradient(const Membrane *membrane, const double *x, double *R);

/* int Y dd dS0 between the accepted state and the trial one (trapezoid in Y; exact for d linear in Y). */
double membrane_dissipation(const Membrane *membrane);

/* Reference position and current position of integration point k. */
void membrane_point_position(const Membrane *membrane, int k, const double *nodes, double position[3]);

typedef struct {
  long long mass_iterations; /* of the conjugate gradients, so far */
} MembraneCount;
MembraneCount membrane_count(const Membrane *membrane);

#endif
