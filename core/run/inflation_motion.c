/* The motion of a capsule whose radius is imposed (paper section 4). */
#include "base/array.h"
#include "run/motion.h"
#include <math.h>
#include <string.h>

static InflationMotion *self(Motion *motion) {
  return (InflationMotion *)motion;
}

double inflation_alpha(const InflationMotion *motion, double t) {
  return broken_line_value(motion->path, t);
}

static void at(const Motion *motion, double t, double *x, double *v) {
  const InflationMotion *m = (const InflationMotion *)motion;
  const double scale = 1 + inflation_alpha(m, t);
  const double rate = broken_line_slope(m->path, motion->t); /* of the step: a corner belongs to both sides */
  for (int i = 0; i < 3 * m->mesh->n_nodes; i++) {
    x[i] = scale * m->mesh->X[i];
    if (v) v[i] = rate * m->mesh->X[i];
  }
}

/* The next time at which a step ends: a corner of the path, or `longest` further on, without a crumb of a
 * step from round-off. */
static double next_time(const InflationMotion *m, double t_limit) {
  const double t1 = fmin(t_limit, broken_line_corner(m->path, m->base.t));
  return t1 - m->base.t <= m->longest * (1 + 1e-9) ? t1 : m->base.t + m->longest;
}

static Status propose(Motion *motion, double t_limit, double *t1, Log *log, Error *error) {
  (void)log;
  InflationMotion *m = self(motion);
  Status status = STATUS_OK;
  m->t1 = next_time(m, t_limit);
  *t1 = m->t1;
  at(motion, m->t1, m->x, NULL);
  TRY(membrane_force(m->membrane, m->x, motion->t, m->t1 - motion->t, m->force, error));
  TRY(membrane_load(m->membrane, LOAD_FULL, m->force, m->load, error));
cleanup:
  if (status == STATUS_REJECT) status = error->code = STATUS_FAILED; /* a prescribed step cannot be cut */
  return status;
}

static void shorten(Motion *motion, double t) {
  self(motion)->t1 = t;
}

static void accept(Motion *motion) {
  InflationMotion *m = self(motion);
  motion->last_step = m->t1 - motion->t;
  motion->t = m->t1;
  m->steps++;
}

static size_t restart_items(Motion *motion, RestartItem *items) {
  InflationMotion *m = self(motion);
  const size_t n = 3 * (size_t)m->mesh->n_nodes;
  const RestartItem list[] = {
      {.name = "t", .count = 1, .doubles = &motion->t},
      {.name = "last_step", .count = 1, .doubles = &motion->last_step},
      {.name = "steps", .count = 1, .doubles = &m->steps},
      {.name = "q", .count = n, .doubles = m->load},
  };
  memcpy(items, list, sizeof list);
  return sizeof list / sizeof *list;
}

static long long none(const Motion *motion) {
  (void)motion;
  return 0;
}
static long long steps(const Motion *motion) {
  return (long long)((const InflationMotion *)motion)->steps;
}

Status inflation_start(InflationMotion *m, Error *error) {
  double t1;
  const Status status = propose(&m->base, m->base.t, &t1, NULL, error);
  if (status == STATUS_OK) membrane_commit(m->membrane);
  return status;
}

Status inflation_motion(InflationMotion *motion, const Mesh *mesh, Membrane *membrane,
                        const double (*path)[2], size_t n_path, double longest, Error *error) {
  Status status = STATUS_OK;
  const size_t n = 3 * (size_t)mesh->n_nodes;
  *motion = (InflationMotion){.mesh = mesh, .membrane = membrane, .path = {path, n_path}, .longest = longest};
  TRY(ARRAY_NEW(&motion->x, n, error));
  TRY(ARRAY_NEW(&motion->force, n, error));
  TRY(ARRAY_NEW(&motion->load, n, error));
  motion->base = (Motion){.propose = propose,
                          .at = at,
                          .shorten = shorten,
                          .accept = accept,
                          .restart_items = restart_items,
                          .evaluations = none,
                          .stage_evaluations = none,
                          .rejected = none,
                          .steps = steps,
                          .t = path[0][0],
                          .R = motion->force,
                          .q = motion->load};
cleanup:
  if (status != STATUS_OK) inflation_motion_free(motion);
  return status;
}

void inflation_motion_free(InflationMotion *motion) {
  array_free(motion->x);
  array_free(motion->force);
  array_free(motion->load);
  *motion = (InflationMotion){0};
}
