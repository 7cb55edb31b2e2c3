/* capsella laws plot: what a law does, as a chart. */
#include "app/commands.h"
#include "app/help.h"
#include "base/array.h"
#include "base/file.h"
#include "laws/curves.h"
#include "observe/chart.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MAX_SETS = 64, POINTS = 241, CYCLE = 4 * (POINTS - 1) + 1 };

typedef struct {
  const char *request, *file;
  SceneParameter parameters[MAX_SETS];
  char names[MAX_SETS][64];
  size_t n_parameters;
} Options;

static int refuse(const char *message, const char *found) {
  return help_refuse("laws plot", message, found);
}

static int fail(const Error *error) {
  fprintf(stderr, "capsella laws plot: %s\n", error->text);
  return exit_code(error->code);
}

/* PARAMETER=VALUE; false when it is not. */
static bool take_set(Options *options, const char *set) {
  const char *equals = strchr(set, '=');
  if (!equals || equals == set || options->n_parameters == MAX_SETS) return false;
  SceneParameter *parameter = &options->parameters[options->n_parameters];
  char *name = options->names[options->n_parameters];
  Error why;
  snprintf(name, sizeof options->names[0], "%.*s", (int)(equals - set), set);
  *parameter = (SceneParameter){.name = name, .place = {.file = "--set"}};
  if (units_parse(equals + 1, &parameter->value, &why) != STATUS_OK) return false;
  options->n_parameters++;
  return true;
}

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, Options *options) {
  for (int i = 1; i < argc; i++) {
    const char *argument = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
    if (strcmp(argument, "-o") == 0 && value) {
      options->file = argv[++i];
    } else if (strcmp(argument, "--set") == 0 && value) {
      if (!take_set(options, argv[++i])) return refuse("expected PARAMETER=VALUE after --set", value);
    } else if (argument[0] == '-' || options->request) {
      return refuse("expected one law and options with their values", argument);
    } else {
      options->request = argument;
    }
  }
  return options->request ? -1 : refuse("expected a law, found none", NULL);
}

/* ---- Constitutive laws ---- */

/* Tension against stretch; a point without an answer of the law is left out. */
typedef struct {
  double stretch[POINTS], along[POINTS], across[POINTS];
} TensionCurve;

static void fill_tensions(const Material *material, StretchMode mode, TensionCurve *curve) {
  const double from = 0.8, to = 2;
  for (int k = 0; k < POINTS; k++) {
    double l[2], T[2];
    Error ignored;
    curve->stretch[k] = from + (to - from) * k / (POINTS - 1);
    const bool found = curve_stretches(material, mode, curve->stretch[k], l, &ignored) == STATUS_OK &&
                       curve_tensions(material, l, T, &ignored) == STATUS_OK;
    curve->along[k] = found ? T[0] : NAN;
    curve->across[k] = found ? T[1] : NAN;
  }
}

static Status plot_elastic(const Material *material, const char *title, Text *svg, Error *error) {
  TensionCurve *curve = NULL;
  Status status = ARRAY_NEW(&curve, N_STRETCHES, error);
  if (status != STATUS_OK) return status;
  for (int mode = 0; mode < N_STRETCHES; mode++) fill_tensions(material, (StretchMode)mode, &curve[mode]);
  const TensionCurve *shear = &curve[STRETCH_PURE_SHEAR], *uniaxial = &curve[STRETCH_UNIAXIAL],
                     *equibiaxial = &curve[STRETCH_EQUIBIAXIAL];
  const ChartSeries series[] = {
      {.label = "uniaxial", .x = uniaxial->stretch, .y = uniaxial->along, .n = POINTS, .color = 1},
      {.label = "equibiaxial", .x = equibiaxial->stretch, .y = equibiaxial->along, .n = POINTS, .color = 2},
      {.label = "pure shear (l2 = 1)", .x = shear->stretch, .y = shear->along, .n = POINTS, .color = 3},
      {.label = "the same, across",
       .x = shear->stretch,
       .y = shear->across,
       .n = POINTS,
       .color = 3,
       .style = CHART_DASHES},
  };
  const Chart chart = {.title = title,
                       .x = {.label = "stretch"},
                       .y = {.label = "tension"},
                       .series = series,
                       .n_series = sizeof series / sizeof *series};
  status = chart_print(&chart, svg, error);
  array_free(curve);
  return status;
}

/* ---- Damage laws ---- */

/* From 1 to `first`, back, to `last`, and back. */
static void fill_path(double first, double last, double path[CYCLE]) {
  const double corner[] = {1, first, 1, last, 1};
  for (int leg = 0; leg < 4; leg++)
    for (int k = 0; k < POINTS; k++)
      path[leg * (POINTS - 1) + k] = corner[leg] + (corner[leg + 1] - corner[leg]) * k / (POINTS - 1);
}

/* The stretch at which damage is full, or 3. */
static Status find_end(const Material *material, DamageState *state, double *end, Error *error) {
  double path[CYCLE];
  for (int k = 0; k < CYCLE; k++) path[k] = 1 + 2.0 * k / (CYCLE - 1);
  *end = 3;
  const Status status = curve_damage(material, CYCLE, path, 1, state, error);
  for (int k = CYCLE - 1; k >= 0 && status == STATUS_OK && state[k].d >= 1; k--) *end = path[k];
  return status;
}

typedef struct {
  double stretch[CYCLE], d[CYCLE], threshold[CYCLE], tension[CYCLE], channel[MLAW_N_CHANNELS][CYCLE];
} DamageCurve;

static void sort_out(const DamageState *state, DamageCurve *curve) {
  for (int k = 0; k < CYCLE; k++) {
    curve->stretch[k] = state[k].stretch;
    curve->d[k] = state[k].d;
    curve->tension[k] = state[k].tension;
    curve->threshold[k] = state[k].d < 1 ? state[k].threshold : NAN;
    for (int c = 0; c < MLAW_N_CHANNELS; c++) curve->channel[c][k] = state[k].channel[c];
  }
}

static Status draw_damage(const Material *material, const DamageCurve *curve, const char *title, Text *svg,
                          Error *error) {
  static const char *const names[MLAW_N_CHANNELS] = {"drive Y",
                                                     "drive I1",
                                                     "drive I2",
                                                     "larger stretch",
                                                     "smaller stretch",
                                                     "larger tension, undamaged",
                                                     "smaller tension, undamaged"};
  const mlaw_damage *law = material->damage.damage;
  ChartSeries series[MLAW_N_CHANNELS + 3] = {
      {.label = "damage d", .y = curve->d, .color = 2},
      {.label = "tension of the damaged membrane", .y = curve->tension, .color = 1},
  };
  size_t n = 2;
  if (law->threshold)
    series[n++] = (ChartSeries){.label = "threshold: the Y it withstands", .y = curve->threshold, .color = 4};
  int color = 3; /* damage 2, tension 1, threshold 4 */
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    if (!(law->needs >> c & 1u)) continue;
    series[n++] =
        (ChartSeries){.label = names[c], .y = curve->channel[c], .style = CHART_DASHES, .color = color};
    color = color == 3 ? 5 : color + 1;
  }
  for (size_t k = 0; k < n; k++) {
    series[k].x = curve->stretch;
    series[k].n = CYCLE;
  }
  const Chart chart = {.title = title,
                       .x = {.label = "stretch in pure shear: loaded, unloaded, loaded on, unloaded"},
                       .y = {.label = "d; Y and tensions in units of G_s"},
                       .series = series,
                       .n_series = n};
  return chart_print(&chart, svg, error);
}

static Status plot_damage(const Material *material, const char *title, Text *svg, Error *error) {
  Status status;
  DamageState *state = NULL;
  DamageCurve *curve = NULL;
  double end, path[CYCLE];
  TRY(ARRAY_NEW(&state, CYCLE, error));
  TRY(ARRAY_NEW(&curve, 1, error));
  TRY(find_end(material, state, &end, error));
  fill_path(1 + 0.75 * (end - 1), 1 + 1.05 * (end - 1), path);
  TRY(curve_damage(material, CYCLE, path, 1, state, error));
  sort_out(state, curve);
  TRY(draw_damage(material, curve, title, svg, error));
cleanup:
  array_free(state);
  array_free(curve);
  return status;
}

/* ---- The chart ---- */

static Status make_material(const Options *options, const LoadedLaw *law, const LawSearch *search,
                            Material *material, Error *error) {
  static char membrane[] = "neo_hookean";
  Status status;
  Text request = {0};
  Scene scene = {0};
  TRY(text_append(&request, error, "%s#%s", law->file, law_describe(law).id));
  SceneLaw given = {.law = request.data,
                    .parameters = (SceneParameter *)(uintptr_t)options->parameters,
                    .n_parameters = options->n_parameters};
  scene.membrane.d_max = 1;
  scene.membrane.elastic = law->energy ? given : (SceneLaw){.law = membrane};
  if (law->damage) scene.membrane.damage = given;
  TRY(material_new(material, &scene, search, NULL, NULL, NULL, error));
cleanup:
  text_free(&request);
  return status;
}

/* "marigo: Brittle damage ...; Y_D = 0.2, Y_C = 2" */
static Status print_title(const LoadedLaw *law, const Material *material, Text *title, Error *error) {
  Status status;
  const LawDescription table = law_describe(law);
  const ParameterValues *values = law->energy ? &material->elastic_values : &material->damage_values;
  TRY(text_append(title, error, "%s", table.id));
  for (uint32_t k = 0; k < table.n_params; k++)
    TRY(text_append(title, error, "%s%s = %g", k ? ", " : ": ", law_param(&table, k)->name,
                    values->value[k]));
cleanup:
  return status;
}

static Status plot(const Options *options, Text *file, Error *error) {
  Status status;
  LawSearch search = {0};
  LoadedLaw law = {0};
  Material material = {0};
  Text svg = {0}, title = {0};
  TRY(law_search_default(&search, ".", error)); /* a path is meant from where the user is */
  TRY(law_load(&law, LAW_ANY, options->request, &search, error));
  TRY(make_material(options, &law, &search, &material, error));
  TRY(print_title(&law, &material, &title, error));
  TRY(law.energy ? plot_elastic(&material, title.data, &svg, error)
                 : plot_damage(&material, title.data, &svg, error));
  if (options->file)
    TRY(text_append(file, error, "%s", options->file));
  else
    TRY(text_append(file, error, "%s.svg", law_describe(&law).id));
  TRY(file_write(file->data, svg.data, svg.length, error));
cleanup:
  text_free(&svg);
  text_free(&title);
  material_free(&material);
  law_release(&law);
  law_search_free(&search);
  return status;
}

int command_laws_plot(int argc, char **argv) {
  Options options = {0};
  Text file = {0};
  Error error;
  const int code = parse(argc, argv, &options);
  if (code >= 0) return code;
  const Status status = plot(&options, &file, &error);
  if (status == STATUS_OK) printf("%s\n", file.data);
  text_free(&file);
  return status == STATUS_OK ? EXIT_DONE : fail(&error);
}
