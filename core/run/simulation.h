/* A simulation: the parts that a scene calls for, built once, and nothing that it does not need. */
#ifndef CAPSELLA_RUN_SIMULATION_H
#define CAPSELLA_RUN_SIMULATION_H

#include "base/log.h"
#include "base/status.h"
#include "config/scene.h"
#include "coupling/stepper.h"
#include "coupling/system.h"
#include "fluid/flow.h"
#include "fluid/single_layer.h"
#include "laws/material.h"
#include "membrane/membrane.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"
#include "run/motion.h"

enum { MAX_SKIPPED = 8 };

typedef struct {
  Scene *scene; /* outlives the simulation; capillary_number is filled in when the scene is physical */
  LawScales scales;
  Material material;
  Material *criterion; /* [n_criteria] laws that look on, in the order of the scene */
  size_t n_criteria;
  Mesh mesh;
  Symmetry symmetry; /* of mesh, flow and laws */
  Membrane *membrane;
  double *start;  /* [n_nodes][3] positions at t = 0 */
  double volume0; /* enclosed at the start */
  double area0;   /* of the surface at rest */

  Flow flow; /* of an inflation only the axis, y */
  /* Flow scenes only: */
  SingleLayer *layer;
  CoarseLayer *coarse; /* for inner stages, or NULL */
  CoupledSystem system;
  Stepper stepper;
  FlowMotion carried;
  /* Inflation scenes only: */
  InflationMotion inflated;

  Motion *motion; /* one of the two above */
  const char *skipped[MAX_SKIPPED];
  char skipped_text[MAX_SKIPPED][160];
  size_t n_skipped;
} Simulation;

/* Loads the laws, builds mesh, membrane and, for a flow scene, the fluid. */
Status simulation_new(Simulation *simulation, Scene *scene, Log *log, Error *error);
void simulation_free(Simulation *simulation);

/* The laws of the scene alone, to check it or to ask them: the first part of simulation_new. */
Status simulation_load_laws(Simulation *simulation, Scene *scene, Log *log, Error *error);

/* Brings the initial state to life: first evaluation, spectral radius, refusal of an unstable fixed step. Not
 * called for a run that is resumed. */
Status simulation_start(Simulation *simulation, Error *error);

bool simulation_is_inflation(const Simulation *simulation);

#endif
