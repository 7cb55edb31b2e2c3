/* Any bytes as the tables of a plugin: what opening it checks, what the tests of descriptions look at, and
 * the parameters of a scene against them.  Counts and sizes are those of memory that is there, or the table
 * is absent, or an entry says that it is shorter than it is: a plugin that lies about more than that cannot
 * be told from one that does not. */
#include "fuzz.h"
#include "laws/conformance_test.h"
#include "laws/parameters.h"
#include "laws/plugin.h"
#include <math.h>
#include <string.h>

enum { MOST_LAWS = 3, MOST_ENTRIES = 5, MOST_KEPT = 256 };

/* The bytes that are left, and what was made of those before. */
typedef struct {
  const uint8_t *data;
  size_t left;
  void *kept[MOST_KEPT];
  size_t n_kept;
} Source;

static void *keep(Source *from, size_t size) {
  void *memory = calloc(1, size > 0 ? size : 1);
  if (!memory || from->n_kept == MOST_KEPT) abort();
  return from->kept[from->n_kept++] = memory;
}

static unsigned take(Source *from) {
  if (from->left == 0) return 0;
  from->left--;
  return *from->data++;
}

static void take_bytes(Source *from, void *to, size_t size) {
  for (size_t i = 0; i < size; i++) ((uint8_t *)to)[i] = (uint8_t)take(from);
}

static double take_number(Source *from) {
  static const double common[] = {0.0, 1.0, -1.0, 0.5, INFINITY, -INFINITY, NAN, 1e300};
  const unsigned kind = take(from);
  double number;
  if (kind < 200) return common[kind % 8];
  take_bytes(from, &number, sizeof number);
  return number;
}

/* A string of up to 31 bytes, a long one, or none. */
static const char *take_string(Source *from) {
  static const char *const common[] = {"skalak", "N/m", "1", "m^2.s^-1", "a.b"};
  const unsigned kind = take(from);
  if (kind == 255) return NULL;
  if (kind < 5) return common[kind];
  const size_t length = kind == 254 ? 3000 : kind % 32;
  char *string = keep(from, length + 1);
  memset(string, 'x', length);
  if (length < 32) take_bytes(from, string, length);
  return string;
}

/* Mostly the true size; else one below it, or that of a header to come. */
static uint32_t take_size(Source *from, size_t true_size) {
  const unsigned kind = take(from);
  return (uint32_t)(kind < 128 ? true_size : kind % (true_size + 17));
}

static const void *take_params(Source *from, uint32_t n, uint32_t size) {
  char *table = keep(from, (size_t)n * size);
  for (uint32_t k = 0; k < n; k++) {
    mlaw_param param = {.name = take_string(from), .unit = take_string(from), .about = take_string(from)};
    take_bytes(from, param.dim, sizeof param.dim);
    param.flags = take(from);
    param.value = take_number(from);
    param.lo = take_number(from);
    param.hi = take_number(from);
    param.ok_lo = take_number(from);
    param.ok_hi = take_number(from);
    memcpy(table + (size_t)k * size, &param, size < sizeof param ? size : sizeof param);
  }
  return take(from) == 255 ? NULL : table;
}

static const void *take_vars(Source *from, uint32_t n, uint32_t size) {
  char *table = keep(from, (size_t)n * size);
  for (uint32_t k = 0; k < n; k++) {
    mlaw_var var = {.name = take_string(from), .unit = take_string(from), .about = take_string(from)};
    take_bytes(from, var.dim, sizeof var.dim);
    var.init = take_number(from);
    memcpy(table + (size_t)k * size, &var, size < sizeof var ? size : sizeof var);
  }
  return take(from) == 255 ? NULL : table;
}

static int check(const double *param, mlaw_error *err) {
  (void)param;
  memset(err, 'x', sizeof *err); /* no end of the text, which the host must put there */
  return MLAW_BADPARAM;
}

static int eval(const mlaw_energy_args *a) {
  (void)a;
  return MLAW_OK;
}

static int step(const mlaw_damage_args *a) {
  (void)a;
  return MLAW_OK;
}

static const mlaw_energy *take_energy(Source *from) {
  if (take(from) == 255) return NULL;
  mlaw_energy *law = keep(from, sizeof *law);
  law->size = take_size(from, sizeof *law);
  law->id = take_string(from);
  law->title = take_string(from);
  law->source = take_string(from);
  law->about = take_string(from);
  law->n_params = take(from) % MOST_ENTRIES;
  law->param_size = take_size(from, sizeof(mlaw_param));
  law->params = take_params(from, law->n_params, law->param_size);
  law->n_vars = take(from) % MOST_ENTRIES;
  law->var_size = take_size(from, sizeof(mlaw_var));
  law->vars = take_vars(from, law->n_vars, law->var_size);
  law->check = take(from) % 2 ? check : NULL;
  law->eval = take(from) == 255 ? NULL : eval;
  return law;
}

static const mlaw_damage *take_damage(Source *from) {
  if (take(from) == 255) return NULL;
  mlaw_damage *law = keep(from, sizeof *law);
  law->size = take_size(from, sizeof *law);
  law->id = take_string(from);
  law->title = take_string(from);
  law->source = take_string(from);
  law->about = take_string(from);
  law->n_params = take(from) % MOST_ENTRIES;
  law->param_size = take_size(from, sizeof(mlaw_param));
  law->params = take_params(from, law->n_params, law->param_size);
  law->n_vars = take(from) % MOST_ENTRIES;
  law->var_size = take_size(from, sizeof(mlaw_var));
  law->vars = take_vars(from, law->n_vars, law->var_size);
  law->needs = take(from);
  const unsigned given = take(from);
  law->check = given & 1 ? check : NULL;
  law->threshold = given & 2 ? step : NULL;
  law->evolution = given & 4 ? step : NULL;
  law->update = given & 8 ? step : NULL;
  return law;
}

static const mlaw_plugin *take_plugin(Source *from) {
  const mlaw_energy **energy = keep(from, MOST_LAWS * sizeof *energy);
  const mlaw_damage **damage = keep(from, MOST_LAWS * sizeof *damage);
  mlaw_plugin *plugin = keep(from, sizeof *plugin);
  plugin->size = take_size(from, sizeof *plugin);
  plugin->host_minor_min = (uint16_t)(take(from) % 4);
  plugin->id = take_string(from);
  plugin->version = take_string(from);
  plugin->license = take_string(from);
  plugin->author = take_string(from);
  plugin->n_energy = take(from) % MOST_LAWS;
  plugin->n_damage = take(from) % MOST_LAWS;
  for (uint32_t k = 0; k < plugin->n_energy; k++) energy[k] = take_energy(from);
  for (uint32_t k = 0; k < plugin->n_damage; k++) damage[k] = take_damage(from);
  plugin->energy = take(from) == 255 ? NULL : energy;
  plugin->damage = take(from) == 255 ? NULL : damage;
  return plugin;
}

/* A scene that names some parameter, or none. */
static void meet_scene(Source *from, const LawDescription *law) {
  const LawScales scales = {1.0, 2.0, 3.0};
  const char *name = take_string(from);
  char nothing[] = "", *given = nothing;
  if (law->n_params > 0 && take(from) % 2) name = law_param(law, take(from) % law->n_params)->name;
  if (name) {
    given = keep(from, strlen(name) + 1);
    memcpy(given, name, strlen(name));
  }
  SceneParameter parameter = {.name = given};
  parameter.value.value = take_number(from);
  parameter.value.has_unit = take(from) % 2;
  take_bytes(from, parameter.value.dim, 3);
  const SceneLaw scene = {.parameters = &parameter, .n_parameters = name ? 1 : 0};
  ParameterValues values;
  Error error = {0};
  const LawScales *used = take(from) % 2 ? &scales : NULL;
  if (law_parameters(law, &scene, used, NULL, NULL, &values, &error) == STATUS_OK) {
    parameter_values_free(&values);
  } else if (!error.text[0]) {
    abort();
  }
}

static void describe(const Subject *subject, TestScope scope) {
  for (size_t i = 0; i < conformance_description.n; i++) {
    if (conformance_description.test[i].scope != scope) continue;
    const Verdict verdict = conformance_description.test[i].run(subject);
    if (verdict.outcome == CONFORMANCE_FAILED && !verdict.text[0]) abort();
  }
}

static void use_law(Source *from, Subject subject, LawDescription table) {
  subject.table = table;
  describe(&subject, FOR_LAW);
  meet_scene(from, &table);
}

static void use_plugin(Source *from, const mlaw_plugin *plugin) {
  Subject subject = {.plugin = plugin};
  describe(&subject, FOR_PLUGIN);
  for (uint32_t k = 0; k < plugin->n_energy; k++) {
    subject.energy = plugin->energy[k];
    use_law(from, subject, law_describe_energy(subject.energy));
  }
  subject.energy = NULL;
  for (uint32_t k = 0; k < plugin->n_damage; k++) {
    subject.damage = plugin->damage[k];
    use_law(from, subject, law_describe_damage(subject.damage));
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Source from = {.data = data, .left = size};
  Error error = {0};
  const mlaw_plugin *plugin = take_plugin(&from);
  if (plugin_check(plugin, &error) == STATUS_OK)
    use_plugin(&from, plugin);
  else if (!error.text[0])
    abort();
  while (from.n_kept > 0) free(from.kept[--from.n_kept]);
  return 0;
}
