/* One case of a study: what is set, its folder, and the figures of the run in it.  When and where it runs is
 * for the runner to say. */
#ifndef CAPSELLA_STUDY_CASE_H
#define CAPSELLA_STUDY_CASE_H

#include "config/yaml_tree.h"
#include "study/study.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum { CASE_WAITING, CASE_RUNNING, CASE_DONE, CASE_FAILED } CaseState;

typedef struct {
  char *label, *folder;
  char **sets; /* [n_sets] "KEY=VALUE" */
  size_t n_sets;
  uint64_t identity;
  CaseState state;
  bool has_begun;          /* an earlier process has left something to go on from */
  YamlNode *summary;       /* summary.json; NULL: none */
  char *reason;            /* of a failure, on one line; NULL otherwise */
  double started, seconds; /* of its process, here */
} Case;

/* The case STUDY_FOLDER/cases/LABEL with these settings; `identity` is that of the base scene, which the
 * settings are added to. */
Status case_new(Case **made, const char *study_folder, uint64_t identity, const char *label,
                const Override *settings, size_t n, Error *error);
void case_free(Case *item); /* may be NULL */

/* ---- figures ---- */

bool case_ended(const Case *item);

/* A figure of the case's summary.json by its key with dots, lists being counted from 0
 * ("rupture.angle_to_vorticity_deg", "criteria.0.t_l"); NAN when there is none. */
double case_number(const Case *item, const char *key);
/* Component `k` of a list there: "rupture.X". */
double case_component(const Case *item, const char *key, size_t k);
/* "steady", "end", "ruptured", "failed". */
const char *case_status(const Case *item);

/* Whether the figures are those of a run that came to its end. */
bool case_has_result(const Case *item);

/* ---- folder ---- */

/* Reads summary.json, when it is there. */
Status case_read_summary(Case *item, Error *error);

/* Makes the folder, without anything that would pass for a part of this case: figures and snapshots. */
Status case_clear(const Case *item, Error *error);
Status case_remove_snapshots(const Case *item, Error *error);
/* A file that is not there is no error. */
Status case_remove_file(const Case *item, const char *name, Error *error);

/* Removes the folder of a case with all that a run leaves in it, but nothing else. */
Status case_erase(const char *folder, Error *error);

#endif
