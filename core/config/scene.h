/* The typed scene: what a scene file says, with every default filled in, checked, in plain structs.
 *
 * A scene holds what the user wrote: no law is opened and no scale is applied here (that is the work of laws/
 * and run/).  The table in schema.c is the only place where keys, types, ranges, defaults and meanings stand;
 * reading, resolved.yaml, the nearest-name messages and the manual are printed from it. */
#ifndef CAPSELLA_CONFIG_SCENE_H
#define CAPSELLA_CONFIG_SCENE_H

#include "base/status.h"
#include "base/text.h"
#include "config/place.h"
#include "config/scene_field.h"
#include "config/units.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct {
  char *name;
  Quantity value;
  SourcePlace place;
  SceneField *field; /* in place of `value` where the parameter varies over the membrane; NULL: it does not */
} SceneParameter;

/* A law by name or path, with its parameters as written. */
typedef struct {
  char *law; /* NULL: none */
  SourcePlace place;
  SceneParameter *parameters;
  size_t n_parameters;
} SceneLaw;

/* A damage law that looks on along a run, without feedback. */
typedef struct {
  char *name; /* letters, digits, `_`, `-` and `.`; no two criteria share one */
  SceneLaw law;
} SceneCriterion;

typedef enum { SHAPE_SPHERE } CapsuleShape;
typedef enum { MASS_PCG, MASS_UMFPACK } MassSolver;
typedef enum { INTERPOLATION_QUADRATIC, INTERPOLATION_QUARTIC } Interpolation;
typedef enum {
  FLOW_SIMPLE_SHEAR,       /* v = z e_x */
  FLOW_PLANAR_HYPERBOLIC,  /* v = x e_x - z e_z */
  FLOW_UNIAXIAL_EXTENSION, /* v = x e_x - (y e_y + z e_z)/2 */
  FLOW_LINEAR,             /* v = G x */
  FLOW_INFLATION           /* imposed radius, no fluid */
} FlowKind;
typedef enum { INTEGRATOR_RK2, INTEGRATOR_RKC2, INTEGRATOR_RKC3 } IntegratorKind;
typedef enum { RUPTURE_STOP, RUPTURE_CONTINUE } RuptureAction;
typedef enum { ACCURACY_DRAFT, ACCURACY_STANDARD, ACCURACY_FINE } Accuracy;
typedef enum { SYMMETRY_AUTO, SYMMETRY_OFF } SymmetryChoice;
typedef enum { FLUID_FAST, FLUID_DIRECT, FLUID_REFERENCE } FluidMethod;

typedef struct {
  char *file;     /* as given on the command line, for messages */
  char **sources; /* [n_sources] the "--set KEY=VALUE" that places name */
  size_t n_sources;

  int schema; /* version of the scene format: 1 */
  char *name;
  CapsuleShape shape;

  struct {
    int subdivisions;
    double rotation_axis[3]; /* mesh.rotation: {axis: [x, y, z], angle: radians} */
    double rotation_angle;
    double jitter; /* random shift of the corners on the sphere, share of the length of an edge */
    int seed;
  } mesh;

  struct {
    SceneLaw elastic;
    bool has_damage; /* membrane.damage was given: damage.law is not NULL */
    SceneLaw damage;
    double d_max;
    double nonlocal_length; /* 0: the drive of damage is local */
    MassSolver mass_solver;
    Interpolation interpolation; /* of positions, for the stretches */
    bool check_laws;             /* those that are not the program's, before the run */
  } membrane;

  struct {
    FlowKind kind;
    SourcePlace place;
    double capillary_number; /* 0 until run/ derives it from `physical` */
    double gradient[3][3];   /* FLOW_LINEAR: v_i = gradient[i][j] x_j; filled in for the other kinds too */
    double (*strength)[2];   /* (t, factor), t rising */
    size_t n_strength;
    double period;     /* of an oscillating flow; 0: it is steady */
    double (*path)[2]; /* FLOW_INFLATION: (t, alpha), t rising */
    size_t n_path;
    bool is_physical; /* flow.physical was given: */
    Quantity radius, viscosity, shear_rate, shear_modulus;
    bool remove_flux; /* subtract the mean normal flux (default true) */
  } flow;

  struct {
    double axes[3]; /* semi-axes of the ellipsoid as which the capsule starts */
    double noise;   /* largest random shift of a node in each coordinate */
    int seed;
  } start;

  struct {
    double end;
    IntegratorKind integrator;
    bool step_is_auto;
    double step; /* fixed step when !step_is_auto */
    double tolerance;
    bool allow_unstable;
  } time;

  struct {
    RuptureAction rupture;
    double steady; /* 0: do not stop when steady */
  } stop;

  struct {
    SceneCriterion *criteria;
    size_t n_criteria;
  } observe;

  Accuracy accuracy;
  SymmetryChoice symmetry;
  FluidMethod fluid_method;
  bool coarse_stages; /* inner stages of rkc3 and rkc2 by a coarser rule */

  struct {
    double history_every, snapshot_every; /* 0: only the last state */
    bool report;                          /* write report.html */
  } output;
} Scene;

/* Reads, checks and completes a scene.  `sets` are "key.path=value" strings that replace or add to what the
 * file says, in order, as if written there; an empty value removes the key.  Errors are STATUS_INPUT with
 * "file:line:column: expected, found". */
Status scene_read(Scene *scene, const char *path, const char *const *sets, size_t n_sets, Error *error);

/* The same from text in memory; `file` is the name used in messages. */
Status scene_read_text(Scene *scene, const char *file, const char *bytes, size_t length,
                       const char *const *sets, size_t n_sets, Error *error);

/* The same from a tree that is there already, with its overrides; `file` is the one whose folder is the
 * scene's.  The file names in the tree's places must outlive the scene; the tree need not. */
struct YamlNode;
Status scene_read_tree(Scene *scene, const char *file, const struct YamlNode *root, Error *error);

void scene_free(Scene *scene);

/* The whole scene as YAML with every default: reads back to the same numbers.  `comments` (may be NULL) are
 * lines put at the top, each with "# " in front. */
Status scene_print(const Scene *scene, const char *comments, Text *yaml, Error *error);

/* The configuration manual in Markdown, from the same table. */
Status scene_print_manual(Text *markdown, Error *error);

#endif
