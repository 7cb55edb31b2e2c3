/* The table of keys, and nothing else but what is asked of it.  A new key is one row here and one member of
 * Scene. */
#include "config/schema.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static bool has_damage(const Scene *scene) {
  return scene->membrane.has_damage;
}
static bool has_fluid(const Scene *scene) {
  return scene->flow.kind != FLOW_INFLATION;
}
static bool has_linear_flow(const Scene *scene) {
  return scene->flow.kind == FLOW_LINEAR;
}
static bool has_inflation(const Scene *scene) {
  return scene->flow.kind == FLOW_INFLATION;
}
static bool is_physical(const Scene *scene) {
  return scene->flow.is_physical;
}
static bool is_dimensionless(const Scene *scene) {
  return has_fluid(scene) && !is_physical(scene);
}

static const SchemaCondition WITH_DAMAGE = {has_damage, "`membrane.damage` is given"};
static const SchemaCondition WITH_FLUID = {has_fluid, "`flow.kind` is not `inflation`"};
static const SchemaCondition WITH_LINEAR_FLOW = {has_linear_flow, "`flow.kind` is `linear`"};
static const SchemaCondition WITH_INFLATION = {has_inflation, "`flow.kind` is `inflation`"};
static const SchemaCondition PHYSICAL = {is_physical, "`flow.physical` is given"};
static const SchemaCondition DIMENSIONLESS = {
    is_dimensionless, "`flow.kind` is not `inflation` and `flow.physical` is not given"};

const char *const SCHEMA_ACCURACY[] = {
    [ACCURACY_DRAFT] = "draft", [ACCURACY_STANDARD] = "standard", [ACCURACY_FINE] = "fine", NULL};
static const char *const SHAPES[] = {[SHAPE_SPHERE] = "sphere", NULL};
static const char *const MASS_SOLVERS[] = {[MASS_PCG] = "pcg", [MASS_UMFPACK] = "umfpack", NULL};
static const char *const INTERPOLATIONS[] = {
    [INTERPOLATION_QUADRATIC] = "quadratic", [INTERPOLATION_QUARTIC] = "quartic", NULL};
static const char *const FLOW_KINDS[] = {[FLOW_SIMPLE_SHEAR] = "simple_shear",
                                         [FLOW_PLANAR_HYPERBOLIC] = "planar_hyperbolic",
                                         [FLOW_UNIAXIAL_EXTENSION] = "uniaxial_extension",
                                         [FLOW_LINEAR] = "linear",
                                         [FLOW_INFLATION] = "inflation",
                                         NULL};
static const char *const INTEGRATORS[] = {
    [INTEGRATOR_RK2] = "rk2", [INTEGRATOR_RKC2] = "rkc2", [INTEGRATOR_RKC3] = "rkc3", NULL};
static const char *const RUPTURE_ACTIONS[] = {[RUPTURE_STOP] = "stop", [RUPTURE_CONTINUE] = "continue", NULL};
static const char *const SYMMETRIES[] = {[SYMMETRY_AUTO] = "auto", [SYMMETRY_OFF] = "off", NULL};
static const char *const FLUID_METHODS[] = {
    [FLUID_FAST] = "fast", [FLUID_DIRECT] = "direct", [FLUID_REFERENCE] = "reference", NULL};

#define AT(member)                    .offset = offsetof(Scene, member)
#define ANY                           .low = -INFINITY, .high = INFINITY
#define ABOVE(bound)                  .low = (bound), .above = true, .high = INFINITY
#define AT_LEAST(bound)               .low = (bound), .high = INFINITY
#define WITHIN(least, most)           .low = (least), .high = (most)
#define DIMENSION(mass, length, time) .dim = {mass, length, time, 0}

/* clang-format off */
const SchemaRow SCHEMA[] = {
    {.key = "schema", .type = TYPE_INTEGER, AT(schema), WITHIN(1, 1),
     .meaning = "Version of this format."},
    {.key = "name", .type = TYPE_TEXT, AT(name), .fallback = "unnamed",
     .meaning = "Name of the scene, for reports and for the folder of its results."},

    {.key = "capsule.shape", .type = TYPE_CHOICE, AT(shape), .choices = SHAPES, .fallback = "sphere",
     .meaning = "Shape at rest, of radius 1 (all lengths are in units of the radius)."},
    {.key = "capsule.mesh.subdivisions", .type = TYPE_INTEGER, AT(mesh.subdivisions), WITHIN(0, 7),
     .preset = {"2", "3", "4"},
     .meaning = "How often the icosahedron is halved: n gives 20 * 4^n quadratic triangles (3: 1280 "
                "elements, 2562 nodes)."},
    {.key = "capsule.mesh.rotation.axis", .type = TYPE_VECTOR, AT(mesh.rotation_axis), ANY,
     .fallback = "[0, 0, 1]",
     .meaning = "Axis about which the mesh is turned, of any length; a turned mesh shows how far results "
                "depend on the mesh."},
    {.key = "capsule.mesh.rotation.angle", .type = TYPE_NUMBER, AT(mesh.rotation_angle), ANY, .fallback = "0",
     .meaning = "Angle of this rotation in radians."},
    {.key = "capsule.mesh.jitter", .type = TYPE_NUMBER, AT(mesh.jitter), WITHIN(0, 0.3), .fallback = "0",
     .meaning = "Corners of the elements are shifted on the sphere at random, in each direction by up to this "
                "share of the mean edge: an irregular mesh shows how far results depend on the mesh."},
    {.key = "capsule.mesh.seed", .type = TYPE_INTEGER, AT(mesh.seed), WITHIN(0, 999999), .fallback = "1",
     .meaning = "The same seed gives the same irregular mesh."},

    {.key = "membrane.law", .type = TYPE_LAW, AT(membrane.elastic),
     .meaning = "Elastic law of the membrane."},
    {.key = "membrane.parameters", .type = TYPE_PARAMETERS, AT(membrane.elastic), .fallback = "{}",
     .meaning = "Parameters of the elastic law; each law says which it has."},
    {.key = "membrane.damage", .type = TYPE_GROUP, AT(membrane.has_damage),
     .meaning = "Damage of the membrane; left out, the membrane is purely elastic."},
    {.key = "membrane.damage.law", .type = TYPE_LAW, AT(membrane.damage), .where = &WITH_DAMAGE,
     .meaning = "Damage law of the membrane."},
    {.key = "membrane.damage.parameters", .type = TYPE_PARAMETERS, AT(membrane.damage), .where = &WITH_DAMAGE,
     .fallback = "{}",
     .meaning = "Parameters of the damage law."},
    {.key = "membrane.damage.d_max", .type = TYPE_NUMBER, AT(membrane.d_max), .low = 0, .above = true,
     .high = 1, .where = &WITH_DAMAGE, .fallback = "1",
     .meaning = "Largest damage: d is not let beyond it, and below 1 the membrane never ruptures."},
    {.key = "membrane.damage.nonlocal.length", .type = TYPE_NUMBER, AT(membrane.nonlocal_length), WITHIN(0, 2),
     .where = &WITH_DAMAGE, .fallback = "0",
     .meaning = "What drives damage is first averaged over the surface at rest, with the weight "
                "(1 - r^2/length^2)^2 within this distance; 0: not at all."},
    {.key = "membrane.mass_solver", .type = TYPE_CHOICE, AT(membrane.mass_solver), .choices = MASS_SOLVERS,
     .fallback = "pcg",
     .meaning = "Solver of M q = R for the load q: preconditioned conjugate gradients, or a sparse "
                "factorization."},
    {.key = "membrane.interpolation", .type = TYPE_CHOICE, AT(membrane.interpolation),
     .choices = INTERPOLATIONS, .fallback = "quadratic",
     .meaning = "How stretches follow from the nodes: by each element's own six, or by the fifteen of the four "
                "elements that halving one has given, which makes a smooth shape several times more accurate "
                "on the same mesh (at least one subdivision)."},
    {.key = "membrane.check_laws", .type = TYPE_BOOLEAN, AT(membrane.check_laws), .fallback = "true",
     .meaning = "Check every law that did not come with the program before the run, as `capsella laws check` "
                "does, and refuse one that fails a test."},

    {.key = "flow.kind", .type = TYPE_CHOICE, AT(flow.kind), .companion = offsetof(Scene, flow.place),
     .choices = FLOW_KINDS,
     .meaning = "Undisturbed flow, rates in units of the rate: simple_shear is v = z e_x, "
                "planar_hyperbolic v = x e_x - z e_z, uniaxial_extension v = x e_x - (y e_y + z e_z)/2, "
                "linear v = G x; inflation imposes the radius and sets up no fluid."},
    {.key = "flow.physical", .type = TYPE_GROUP, AT(flow.is_physical), .where = &WITH_FLUID,
     .meaning = "Physical values, from which the capillary number follows, in place of "
                "`flow.capillary_number`."},
    {.key = "flow.physical.radius", .type = TYPE_QUANTITY, AT(flow.radius), ABOVE(0), DIMENSION(0, 1, 0),
     .example = "35 um", .where = &PHYSICAL,
     .meaning = "Radius a of the capsule."},
    {.key = "flow.physical.viscosity", .type = TYPE_QUANTITY, AT(flow.viscosity), ABOVE(0),
     DIMENSION(1, -1, -1), .example = "1 mPa.s", .where = &PHYSICAL,
     .meaning = "Viscosity mu of the fluid, inside and outside."},
    {.key = "flow.physical.shear_rate", .type = TYPE_QUANTITY, AT(flow.shear_rate), ABOVE(0),
     DIMENSION(0, 0, -1), .example = "20 1/s", .where = &PHYSICAL,
     .meaning = "Rate of the flow, by which time is scaled."},
    {.key = "flow.physical.shear_modulus", .type = TYPE_QUANTITY, AT(flow.shear_modulus), ABOVE(0),
     DIMENSION(1, 0, -2), .example = "0.05 N/m", .where = &PHYSICAL,
     .meaning = "Surface shear modulus G_s, by which tensions are scaled."},
    {.key = "flow.capillary_number", .type = TYPE_NUMBER, AT(flow.capillary_number), ABOVE(0),
     .where = &DIMENSIONLESS,
     .meaning = "Capillary number Ca = viscosity * rate * radius / shear modulus."},
    {.key = "flow.gradient", .type = TYPE_MATRIX, AT(flow.gradient), ANY, .where = &WITH_LINEAR_FLOW,
     .meaning = "Velocity gradient G of v = G x, row by row, in units of the rate; its trace is 0."},
    {.key = "flow.strength", .type = TYPE_PATH, AT(flow.strength),
     .companion = offsetof(Scene, flow.n_strength), ANY, .where = &WITH_FLUID, .fallback = "[[0, 1]]",
     .meaning = "What the flow is multiplied by at time t, linear between the points and constant behind the "
                "last: [[0, 1], [5, 1], [5.01, 0]] switches it off at t = 5."},
    {.key = "flow.period", .type = TYPE_NUMBER, AT(flow.period), AT_LEAST(0), .where = &WITH_FLUID,
     .fallback = "0",
     .meaning = "Period of an oscillating flow, which is multiplied by cos(2 pi t/period), in units of 1/rate; "
                "0: it does not oscillate."},
    {.key = "flow.path", .type = TYPE_PATH, AT(flow.path), .companion = offsetof(Scene, flow.n_path), ABOVE(-1),
     .where = &WITH_INFLATION,
     .meaning = "Imposed inflation: the radius is 1 + alpha(t), linear between the points; from t = 0 to "
                "at least `time.end`."},

    {.key = "start.axes", .type = TYPE_VECTOR, AT(start.axes), ABOVE(0), .where = &WITH_FLUID,
     .fallback = "[1, 1, 1]",
     .meaning = "Semi-axes along x, y and z of the ellipsoid as which the capsule starts, stretched from the "
                "sphere at rest: [1.05, 1.05, 1.05] is inflated by 5 %. Its volume is the one that stays."},
    {.key = "start.noise", .type = TYPE_NUMBER, AT(start.noise), WITHIN(0, 0.1), .where = &WITH_FLUID,
     .fallback = "0",
     .meaning = "Random shift of every node at the start, in each coordinate by up to this: what grows from "
                "it, such as wrinkles, would grow from any disturbance."},
    {.key = "start.seed", .type = TYPE_INTEGER, AT(start.seed), WITHIN(0, 999999), .where = &WITH_FLUID,
     .fallback = "1",
     .meaning = "The same seed gives the same noise."},

    {.key = "time.end", .type = TYPE_NUMBER, AT(time.end), ABOVE(0),
     .meaning = "Time at which the run ends, in units of 1/rate."},
    {.key = "time.integrator", .type = TYPE_CHOICE, AT(time.integrator), .choices = INTEGRATORS,
     .fallback = "rkc3",
     .meaning = "Time integrator: rkc3 and rkc2 are stabilized Runge-Kutta-Chebyshev methods of order 3 and 2, rk2 "
                "the explicit midpoint rule, whose steps stability keeps short."},
    {.key = "time.step", .type = TYPE_AUTOMATIC, AT(time.step),
     .companion = offsetof(Scene, time.step_is_auto), ABOVE(0), .fallback = "auto",
     .meaning = "Time step: `auto` follows the error and the stability limit, a number is a fixed step, "
                "which is refused beyond the stability limit."},
    {.key = "time.tolerance", .type = TYPE_NUMBER, AT(time.tolerance), WITHIN(1e-12, 0.1),
     .preset = {"1e-3", "1e-4", "1e-5"},
     .meaning = "Error allowed for automatic steps."},
    {.key = "time.allow_unstable", .type = TYPE_BOOLEAN, AT(time.allow_unstable), .fallback = "false",
     .meaning = "Run a fixed step even beyond the stability limit."},

    {.key = "stop.rupture", .type = TYPE_CHOICE, AT(stop.rupture), .choices = RUPTURE_ACTIONS,
     .fallback = "stop",
     .meaning = "What to do when the damage reaches 1 somewhere."},
    {.key = "stop.steady", .type = TYPE_NUMBER, AT(stop.steady), AT_LEAST(0), .fallback = "0",
     .meaning = "Stop as steady when the rates of D12 and of the largest damage, taken between rows of the "
                "history, stay below this; 0: never."},

    {.key = "observe.criteria", .type = TYPE_CRITERIA, AT(observe.criteria),
     .companion = offsetof(Scene, observe.n_criteria), .fallback = "[]",
     .meaning = "Damage laws that look on, without feedback: each has its own damage, and the summary and "
                "criteria.csv tell when and where it would have begun and ruptured. `name` may be left out; "
                "it is then that of the law."},

    {.key = "accuracy", .type = TYPE_CHOICE, AT(accuracy), .choices = SCHEMA_ACCURACY, .fallback = "standard",
     .meaning = "Sets the defaults of mesh and tolerance together: errors of the shape below 1 %, 0.1 % and 0.01 % "
                "where the membrane is tense and sound (table below; measured in docs/benchmarks.md)."},
    {.key = "symmetry", .type = TYPE_CHOICE, AT(symmetry), .choices = SYMMETRIES, .fallback = "auto",
     .meaning = "Whether a scene with planes of symmetry is computed on a part of the capsule only."},

    {.key = "fluid.method", .type = TYPE_CHOICE, AT(fluid_method), .choices = FLUID_METHODS,
     .fallback = "fast",
     .meaning = "Quadrature of the single layer: fast refines near elements only; direct is the rule of 12 "
                "points per element with polar coordinates on singular ones; reference is the most "
                "accurate."},
    {.key = "fluid.coarse_stages", .type = TYPE_BOOLEAN, AT(coarse_stages), .fallback = "true",
     .meaning = "Inner stages of a stabilized step by a coarser rule, plus what that lacked at the start of the "
                "step; the direct method has none."},
    {.key = "fluid.remove_flux", .type = TYPE_BOOLEAN, AT(flow.remove_flux), .fallback = "true",
     .meaning = "Subtract the mean normal velocity, which is 0 but for the quadrature, so that the volume "
                "stays."},

    {.key = "output.history_every", .type = TYPE_NUMBER, AT(output.history_every), AT_LEAST(0),
     .fallback = "0.05",
     .meaning = "Time between rows of history.csv; 0: only the last state. The steps of an inflation are no longer."},
    {.key = "output.snapshot_every", .type = TYPE_NUMBER, AT(output.snapshot_every), AT_LEAST(0),
     .fallback = "0.5",
     .meaning = "Time between snapshots; 0: only the last state."},
    {.key = "output.report", .type = TYPE_BOOLEAN, AT(output.report), .fallback = "true",
     .meaning = "Write report.html, a page with curves and the capsule, at the end of the run."},
};
/* clang-format on */

const size_t SCHEMA_ROWS = sizeof SCHEMA / sizeof *SCHEMA;

bool schema_applies(const SchemaRow *row, const Scene *scene) {
  return !row->where || row->where->holds(scene);
}

bool schema_has_preset(const SchemaRow *row) {
  return row->preset[0] != NULL;
}

const char *schema_default(const SchemaRow *row, Accuracy accuracy) {
  return schema_has_preset(row) ? row->preset[accuracy] : row->fallback;
}

const SchemaRow *schema_find(const char *key) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++)
    if (strcmp(SCHEMA[i].key, key) == 0) return &SCHEMA[i];
  return NULL;
}

bool schema_is_mapping(const char *key) {
  size_t length = strlen(key);
  for (size_t i = 0; i < SCHEMA_ROWS; i++)
    if (strncmp(SCHEMA[i].key, key, length) == 0 && SCHEMA[i].key[length] == '.') return true;
  return false;
}

static const char *last_name(const char *key) {
  const char *dot = strrchr(key, '.');
  return dot ? dot + 1 : key;
}

/* Whether a sentence has "SYMBOL = ". */
static bool defines(const char *sentence, const char *symbol) {
  const size_t length = strlen(symbol);
  for (const char *at = sentence; (at = strstr(at, symbol)); at++)
    if ((at == sentence || at[-1] == ' ') && strncmp(at + length, " = ", 3) == 0) return true;
  return false;
}

Status schema_suggest(const char *key, Text *suggestion, Error *error) {
  enum { LONGEST = 40 };
  char siblings[sizeof SCHEMA / sizeof *SCHEMA][LONGEST];
  const char *names[sizeof SCHEMA / sizeof *SCHEMA];
  const char *name = last_name(key);
  size_t parent = (size_t)(name - key), count = 0;
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    if (strncmp(SCHEMA[i].key, key, parent) != 0) continue;
    const char *sibling = SCHEMA[i].key + parent;
    snprintf(siblings[count], LONGEST, "%.*s", (int)strcspn(sibling, "."), sibling);
    names[count] = siblings[count];
    count++;
  }
  const char *nearest = text_nearest(name, names, count);
  if (nearest) return text_append(suggestion, error, "%.*s%s", (int)parent, key, nearest);
  for (size_t i = 0; i < SCHEMA_ROWS; i++) names[i] = last_name(SCHEMA[i].key);
  nearest = text_nearest(name, names, SCHEMA_ROWS);
  for (size_t i = 0; nearest && i < SCHEMA_ROWS; i++)
    if (names[i] == nearest) return text_append(suggestion, error, "%s", SCHEMA[i].key);
  for (size_t i = 0; i < SCHEMA_ROWS; i++)
    if (defines(SCHEMA[i].meaning, name)) return text_append(suggestion, error, "%s", SCHEMA[i].key);
  return STATUS_OK;
}

static Status append_range(const SchemaRow *row, Text *text, Error *error) {
  bool from = row->low > -INFINITY, to = row->high < INFINITY;
  if (from && to && row->above) return text_append(text, error, " above %g, at most %g", row->low, row->high);
  if (from && to) return text_append(text, error, " from %g to %g", row->low, row->high);
  if (from) return text_append(text, error, " %s %g", row->above ? "above" : "of at least", row->low);
  return STATUS_OK;
}

static Status append_choices(const SchemaRow *row, Text *text, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; row->choices[i]; i++) {
    const char *separator = i == 0 ? "" : row->choices[i + 1] ? ", " : " or ";
    TRY(text_append(text, error, "%s`%s`", separator, row->choices[i]));
  }
cleanup:
  return status;
}

Status schema_expected(const SchemaRow *row, Text *text, Error *error) {
  Status status = STATUS_OK;
  switch (row->type) {
  case TYPE_TEXT:
    return text_append(text, error, "text");
  case TYPE_INTEGER:
    if (row->low == row->high) return text_append(text, error, "`%g`", row->low);
    TRY(text_append(text, error, "a whole number"));
    return append_range(row, text, error);
  case TYPE_NUMBER:
    TRY(text_append(text, error, "a number"));
    return append_range(row, text, error);
  case TYPE_AUTOMATIC:
    TRY(text_append(text, error, "`auto` or a number"));
    return append_range(row, text, error);
  case TYPE_BOOLEAN:
    return text_append(text, error, "`true` or `false`");
  case TYPE_CHOICE:
    return append_choices(row, text, error);
  case TYPE_QUANTITY:
    TRY(text_append(text, error, "a quantity"));
    TRY(append_range(row, text, error));
    return text_append(text, error, " with a unit, such as `%s`", row->example);
  case TYPE_VECTOR:
    TRY(text_append(text, error, "a list of three numbers"));
    return append_range(row, text, error);
  case TYPE_MATRIX:
    return text_append(text, error, "a list of three rows of three numbers");
  case TYPE_PATH:
    TRY(text_append(text, error, "a list of pairs `[t, value]`"));
    return append_range(row, text, error);
  case TYPE_LAW:
    return text_append(text, error, "the name of a law or the path of a shared object");
  case TYPE_PARAMETERS:
    return text_append(text, error, "a mapping of names to numbers, quantities or fields");
  case TYPE_CRITERIA:
    return text_append(text, error, "a list of mappings `{name: , law: , parameters: }`");
  case TYPE_GROUP:
    return text_append(text, error, "a mapping");
  }
cleanup:
  return status;
}
