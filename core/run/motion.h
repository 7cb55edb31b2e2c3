/* How the nodes move: carried by the flow, or prescribed (inflation).  The loop of a run sees only this. */
#ifndef CAPSELLA_RUN_MOTION_H
#define CAPSELLA_RUN_MOTION_H

#include "base/broken_line.h"
#include "base/log.h"
#include "base/status.h"
#include "coupling/stepper.h"
#include "coupling/system.h"
#include "membrane/membrane.h"
#include "mesh/mesh.h"
#include "observe/snapshot.h"

typedef struct Motion Motion;
struct Motion {
  /* Proposes a step from the accepted time to t1 <= t_limit and leaves the membrane's trial state at t1. */
  Status (*propose)(Motion *motion, double t_limit, double *t1, Log *log, Error *error);
  /* Positions and velocities [n_nodes][3] at a time inside the proposed step; v may be NULL. */
  void (*at)(const Motion *motion, double t, double *x, double *v);
  /* Ends the proposed step early, at t; R and q are then the caller's to renew. */
  void (*shorten)(Motion *motion, double t);
  /* Accepts the proposed step; the caller commits the membrane. */
  void (*accept)(Motion *motion);
  /* What a restart must keep: appends to items, at most MOTION_RESTART_ITEMS. */
  size_t (*restart_items)(Motion *motion, RestartItem *items);

  double t;         /* accepted time */
  double last_step; /* size of the last accepted step */
  const double *R;  /* [n_nodes][3] internal force at the end of the proposed step */
  double *q;        /* [n_nodes][3] load there */
  long long (*evaluations)(const Motion *motion);
  long long (*stage_evaluations)(const Motion *motion); /* those of them by the coarse rule */
  long long (*rejected)(const Motion *motion);
  long long (*steps)(const Motion *motion);
};

enum { MOTION_RESTART_ITEMS = 9 };

/* Carried by the flow: the stepper does the work and must be started (or restored) before the first proposal.
 * Steps end on the times at which the strength of the flow has a corner. */
typedef struct {
  Motion base;
  CoupledSystem *system;
  Stepper *stepper;
} FlowMotion;
void flow_motion(FlowMotion *motion, CoupledSystem *system, Stepper *stepper);

/* x = (1 + alpha(t)) X with alpha piecewise linear (paper section 4).  Steps end on the times of the path and
 * at most `longest` apart. */
typedef struct {
  Motion base;
  const Mesh *mesh;
  Membrane *membrane;
  BrokenLine path; /* (t, alpha) */
  double longest;
  double t1;
  double *x, *force, *load; /* [n_nodes][3] */
  double steps;
} InflationMotion;
Status inflation_motion(InflationMotion *motion, const Mesh *mesh, Membrane *membrane,
                        const double (*path)[2], size_t n_path, double longest, Error *error);
/* First evaluation, at the start of the path. */
Status inflation_start(InflationMotion *motion, Error *error);
void inflation_motion_free(InflationMotion *motion);
double inflation_alpha(const InflationMotion *motion, double t);

#endif
