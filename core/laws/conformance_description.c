/* Group `description`: the tables that scenes, manuals and restarts are read against. */
#include "config/units.h"
#include "laws/conformance_test.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

static Verdict id_well_formed(const Subject *subject) {
  if (law_id_is_valid(subject->table.id)) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected an id of lower-case letters, digits, _ and dots (`vendor.name`), found `%.60s`",
                 subject->table.id);
}

static const char *law_id(const mlaw_plugin *plugin, uint32_t k) {
  return k < plugin->n_energy ? plugin->energy[k]->id : plugin->damage[k - plugin->n_energy]->id;
}

static Verdict ids_unique(const Subject *subject) {
  const mlaw_plugin *plugin = subject->plugin;
  const uint32_t n = plugin->n_energy + plugin->n_damage;
  if (n == 0) return verdict(CONFORMANCE_FAILED, "expected at least one law, found none");
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t j = 0; j < k; j++) {
      if (strcmp(law_id(plugin, j), law_id(plugin, k)) != 0) continue;
      return verdict(CONFORMANCE_FAILED, "expected each id once, found `%.60s` twice", law_id(plugin, k));
    }
  }
  return verdict_passed();
}

static Verdict strings_present(const Subject *subject) {
  const LawDescription *law = &subject->table;
  if (!*law->title || !*law->source) {
    return verdict(CONFORMANCE_FAILED, "expected a title and a source, found an empty one");
  }
  for (uint32_t k = 0; k < law->n_params; k++) {
    const mlaw_param *param = law_param(law, k);
    if (!*param->name || !*param->unit || !*param->about) {
      return verdict(CONFORMANCE_FAILED,
                     "expected name, unit and meaning of parameter %u, found an empty one", k);
    }
  }
  for (uint32_t k = 0; k < law->n_vars; k++) {
    const mlaw_var *var = law_var(law, k);
    if (!*var->name || !*var->unit || !*var->about) {
      return verdict(CONFORMANCE_FAILED, "expected name, unit and meaning of variable %u, found an empty one",
                     k);
    }
  }
  return verdict_passed();
}

static Verdict names_unique(const Subject *subject) {
  const LawDescription *law = &subject->table;
  for (uint32_t k = 0; k < law->n_params; k++) {
    for (uint32_t j = 0; j < k; j++) {
      if (strcmp(law_param(law, j)->name, law_param(law, k)->name) != 0) continue;
      return verdict(CONFORMANCE_FAILED, "expected each parameter once, found %.60s twice",
                     law_param(law, k)->name);
    }
  }
  return verdict_passed();
}

/* In the hard range, with open ends left out? */
static bool is_allowed(const mlaw_param *param, double value) {
  const bool above = param->flags & MLAW_OPEN_LO ? value > param->lo : value >= param->lo;
  const bool below = param->flags & MLAW_OPEN_HI ? value < param->hi : value <= param->hi;
  return above && below;
}

static Verdict default_inside_hard(const Subject *subject) {
  for (uint32_t k = 0; k < subject->table.n_params; k++) {
    const mlaw_param *param = law_param(&subject->table, k);
    if (!(param->lo < param->hi)) {
      return verdict(CONFORMANCE_FAILED, "%.60s: expected a range with lo < hi, found %g .. %g", param->name,
                     param->lo, param->hi);
    }
    if (param->flags & MLAW_REQUIRED || (isfinite(param->value) && is_allowed(param, param->value))) continue;
    return verdict(CONFORMANCE_FAILED, "%.60s: expected a default inside %g .. %g, found %g", param->name,
                   param->lo, param->hi, param->value);
  }
  return verdict_passed();
}

static Verdict calibrated_inside_hard(const Subject *subject) {
  for (uint32_t k = 0; k < subject->table.n_params; k++) {
    const mlaw_param *param = law_param(&subject->table, k);
    if (param->lo <= param->ok_lo && param->ok_lo < param->ok_hi && param->ok_hi <= param->hi) continue;
    return verdict(CONFORMANCE_FAILED, "%.60s: expected a calibrated range inside %g .. %g, found %g .. %g",
                   param->name, param->lo, param->hi, param->ok_lo, param->ok_hi);
  }
  return verdict_passed();
}

static Verdict check_unit(const char *name, const char *unit, const int8_t dim[4]) {
  signed char read[4] = {0};
  int decade = 0;
  Error error;
  if (strcmp(unit, "1") != 0 && units_parse_unit(unit, read, &decade, &error) != STATUS_OK) {
    return verdict(CONFORMANCE_FAILED, "%.60s: %.400s", name, error.text);
  }
  if (!units_agree(read, dim) || dim[3] != 0) {
    return verdict(
        CONFORMANCE_FAILED,
        "%.60s: expected powers of mass, length and time {%d, %d, %d, 0} for the unit %.40s, found "
        "{%d, %d, %d, %d}",
        name, read[0], read[1], read[2], unit, dim[0], dim[1], dim[2], dim[3]);
  }
  if (decade != 0) {
    return verdict(CONFORMANCE_FAILED, "%.60s: expected an SI unit without prefix, found %.40s", name, unit);
  }
  return verdict_passed();
}

static Verdict unit_agrees_with_exponents(const Subject *subject) {
  Verdict result = verdict_passed();
  const LawDescription *law = &subject->table;
  for (uint32_t k = 0; k < law->n_params && result.outcome == CONFORMANCE_PASSED; k++) {
    const mlaw_param *param = law_param(law, k);
    result = check_unit(param->name, param->unit, param->dim);
  }
  for (uint32_t k = 0; k < law->n_vars && result.outcome == CONFORMANCE_PASSED; k++) {
    const mlaw_var *var = law_var(law, k);
    result = check_unit(var->name, var->unit, var->dim);
  }
  return result;
}

static Verdict sizes_sane(const Subject *subject) {
  const LawDescription *law = &subject->table;
  const uint32_t size = subject->energy ? subject->energy->size : subject->damage->size;
  if (size > 4096 || law->param_size > 4096 || law->var_size > 4096) {
    return verdict(CONFORMANCE_FAILED,
                   "expected sizes below 4096 bytes, found law %u, parameter %u, variable %u", size,
                   law->param_size, law->var_size);
  }
  if (law->n_params > 64 || law->n_vars > 16) {
    return verdict(CONFORMANCE_FAILED, "expected at most 64 parameters and 16 variables, found %u and %u",
                   law->n_params, law->n_vars);
  }
  return verdict_passed();
}

static Verdict start_finite(const Subject *subject) {
  for (uint32_t k = 0; k < subject->table.n_vars; k++) {
    const mlaw_var *var = law_var(&subject->table, k);
    if (isfinite(var->init)) continue;
    return verdict(CONFORMANCE_FAILED, "variable %.60s: expected a finite start, found %g", var->name,
                   var->init);
  }
  return verdict_passed();
}

static const ConformanceTest tests[] = {
    {FOR_PLUGIN, "ids-unique", "the plugin holds laws, each with an id of its own", ids_unique},
    {FOR_LAW, "id-well-formed", "the id is one that scenes can name", id_well_formed},
    {FOR_LAW, "strings-present", "title, source, names, units and meanings are given", strings_present},
    {FOR_LAW, "names-unique", "no two parameters share a name", names_unique},
    {FOR_LAW, "default-inside-hard", "defaults can be used", default_inside_hard},
    {FOR_LAW, "calibrated-inside-hard", "the calibrated range lies inside the hard one",
     calibrated_inside_hard},
    {FOR_LAW, "unit-agrees-with-exponents", "units and exponents say the same", unit_agrees_with_exponents},
    {FOR_LAW, "sizes-sane", "sizes and counts are believable", sizes_sane},
    {FOR_LAW, "start-finite", "history starts at finite values", start_finite},
};

const ConformanceGroup conformance_description = {"description", tests, sizeof tests / sizeof *tests};
