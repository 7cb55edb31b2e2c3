/* A study as its file says it: a scene, what is varied, and what is to be found from it.
 *
 * The parts that all kinds share are read here; each kind (sweep, threshold, ...) reads its own keys from
 * `root` in its own file, and is one row of STUDY_KINDS. */
#ifndef CAPSELLA_STUDY_STUDY_H
#define CAPSELLA_STUDY_STUDY_H

#include "base/status.h"
#include "config/scene.h"
#include "config/yaml_tree.h"
#include "run/simulation.h"

/* One setting of a scene: what `--set KEY=VALUE` says, and where it is written. */
typedef struct {
  const char *key, *value; /* the value as YAML; empty: the key is removed */
  SourcePlace place;
} Override;

/* A varied key and its values: one axis of the outer product. */
typedef struct {
  const char *key;  /* owned by the tree */
  Override *values; /* [n] */
  double *numbers;  /* [n]; NAN where a value is no number */
  bool is_numeric;  /* all are numbers */
  char **texts;     /* [n] owns the values of `values` */
  size_t n;
} Axis;

typedef struct Study Study;
typedef struct StudyRun StudyRun;

typedef struct {
  const char *name;
  const char *const *keys; /* of its own in a study file; ends in NULL */
  Status (*prepare)(Study *study,
                    Error *error); /* checks its keys and sets what it needs of the scene; or NULL */
  Status (*run)(StudyRun *run, Error *error);
  bool keeps_states; /* the last state of each case is left in its folder */
} StudyKind;

/* Ends in NULL. */
extern const StudyKind *const STUDY_KINDS[];

struct Study {
  char *file; /* as given */
  char *name;
  const StudyKind *kind;
  YamlNode *root;   /* the whole file */
  YamlNode *scene;  /* the base scene, with the --set of the command line */
  char *scene_file; /* names the folder where the scene's laws are */
  char **sources;   /* [n_sources] "--set KEY=VALUE", which places name */
  size_t n_sources;
  Axis *axes;
  size_t n_axes;
  size_t n_points; /* of the outer product; 1 without axes */
};

/* Reads a study file; `sets` ("KEY=VALUE") change its scene.  STATUS_INPUT with "FILE:LINE:COLUMN: expected,
 * found". */
Status study_read(Study *study, const char *path, const char *const *sets, size_t n_sets, Error *error);
void study_free(Study *study);

/* One of several parts of a study that are computed apart: keeps the values of the first varied key that fall
 * to part `part` of `parts`, counted from 1, in order, so that the tables of the parts make up the whole one.
 * STATUS_INPUT when there are not that many values. */
Status study_take_part(Study *study, int part, int parts, Error *error);

/* The settings of point `index` of the outer product into settings [n_axes]; the last axis runs fastest. */
void study_point(const Study *study, size_t index, Override *settings);

/* Place of point `index` along each axis: [n_axes]. */
void study_place(const Study *study, size_t index, size_t *places);

/* The base scene with `settings` in order, typed and checked; with `laws` (else NULL) its laws are opened
 * too, and their parameters checked: simulation_free(laws), then scene_free(scene). */
Status study_scene(const Study *study, const Override *settings, size_t n, Scene *scene, Simulation *laws,
                   Error *error);

/* The same for a check alone. */
Status study_check(const Study *study, const Override *settings, size_t n, Error *error);

/* Checks the scene of every point of the outer product. */
Status study_check_points(const Study *study, Error *error);

/* Puts a value into the base scene: what a kind of study needs of every case. */
Status study_set(Study *study, const char *key, const char *value, Error *error);

/* Whether the base scene gives a key: "stop.steady". */
bool study_scene_gives(const Study *study, const char *key);

#endif
