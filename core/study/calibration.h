/* Criteria of equal severity: the strength of each multiplied by the factor at which damage just begins, or
 * just reaches 1, at a given capillary number.
 *
 * One run judges every criterion at many factors side by side, so that three runs find the factors of all to
 * about 0.1 %.  Damage that the membrane feels brings rupture sooner: for criteria that act on it, runs of
 * their own find the factor to about 1 %. */
#ifndef CAPSELLA_STUDY_CALIBRATION_H
#define CAPSELLA_STUDY_CALIBRATION_H

#include "study/contender.h"
#include "study/runner.h"

typedef struct {
  bool is_asked;
  bool onset;         /* Ca_c: damage just begins; else Ca_l: it just reaches 1 */
  const YamlNode *Ca; /* a number, or `scene`: at the capillary number of each scene */
} CalibrationGoal;

/* The largest factor found at which the event comes; NAN with a reason when there is none. */
typedef struct {
  double scale;
  const char *reason;
} Calibrated;

/* `calibrate: {Ca_l: 0.73}`; node NULL: nothing is asked, and every factor is 1. */
Status calibration_read(const YamlNode *node, CalibrationGoal *goal, Error *error);

/* passive [n_points][n]: for each point of the outer product and each contender, without feedback; coupled,
 * the same with it, where `acts` [n] says so.  After an interrupt what is not known is NAN. */
Status calibrate(const StudyRun *run, const CalibrationGoal *goal, const Contender *contenders, size_t n,
                 const bool *acts, Calibrated *passive, Calibrated *coupled, Error *error);

#endif
