/* What a criterion says of a run: when damage would have begun and the membrane ruptured, and where.
 *
 * criteria.csv has one row for each criterion, summary.json the same figures. */
#ifndef CAPSELLA_OBSERVE_VERDICT_H
#define CAPSELLA_OBSERVE_VERDICT_H

#include "base/status.h"
#include "observe/json.h"
#include "observe/site.h"

/* Dimensionless; nothing but doubles, so that a restart keeps it as numbers.  The state looked at is that at
 * rupture, or without rupture the last one. */
typedef struct {
  double t_c, t_l; /* first time with d > 0, with d >= 1; NAN: not reached */
  double d_max;
  double t;                     /* of the state looked at */
  Site site;                    /* where d is largest */
  double damaged_area_fraction; /* of the reference area with d > 0 */
  double thickness_min;         /* least thickness over that at rest, of a wall that keeps its volume */
  Site thinnest;
  double T1_max; /* largest principal tension of the membrane as it is */
  Site tensest;
} Finding;

typedef struct {
  const char *name, *law;
  Finding finding;
} Verdict;

/* "ruptured", "damaged" or "whole". */
const char *verdict_name(const Finding *finding);

/* The value of the key "criteria" of a summary. */
void verdicts_print_json(const Verdict *verdicts, size_t n, Json *json);

/* criteria.csv, written whole or not at all; NAN is written as `nan`. */
Status verdicts_write(const Verdict *verdicts, size_t n, const char *path, Error *error);

#endif
