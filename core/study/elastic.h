/* The largest Y of elastic runs as a function of the searched key: shared by all points of a study that
 * differ in their damage law alone.
 *
 * Until damage begins a damaged run is the elastic one, so a law in which damage begins at Y_c damages the
 * capsule exactly where the largest Y of the elastic run passes Y_c.  The runs are made in rounds: what a
 * round asks for follows from the rounds before and from the levels alone. */
#ifndef CAPSELLA_STUDY_ELASTIC_H
#define CAPSELLA_STUDY_ELASTIC_H

#include "study/level_curve.h"
#include "study/runner.h"

enum { ELASTIC_TRIALS = 64 }; /* in one round */

typedef struct {
  const char *key;    /* that is searched */
  Override *settings; /* [n_settings] of the points, without those of the damage law */
  size_t n_settings;
  double low, high, tolerance;
  double *levels; /* [n_levels] of Y, one for each point of the group */
  size_t n_levels, capacity;
  LevelCurve curve;
  double trial[ELASTIC_TRIALS];
  int cases[ELASTIC_TRIALS];
  size_t n_trials;
  long runs;
  bool begun, over;
  char *reason; /* of the first run that failed, if any */
} Elastic;

/* Takes the settings of a point, and drops those of the damage law. */
Status elastic_new(Elastic *elastic, const char *key, const Override *settings, size_t n, double low,
                   double high, double tolerance, Error *error);
void elastic_free(Elastic *elastic);

/* Whether a point with these settings belongs here. */
bool elastic_is_of(const Elastic *elastic, const char *key, const Override *settings, size_t n);

Status elastic_add_level(Elastic *elastic, double level, Error *error);

/* Goes on as far as the cases that have ended allow; `moved` is set when it did. */
Status elastic_advance(Elastic *elastic, Runner *runner, bool *moved, Error *error);

/* Where a level is passed, once over. */
LevelCrossing elastic_cross(const Elastic *elastic, double level);

#endif
