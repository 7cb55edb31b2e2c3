/* dlopen and the checks that make a plugin readable.  Which law is wanted is loader.c's business; what a law
 * computes is looked at by material.c and conformance.c. */
#include "laws/plugin.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

const char *law_kind_name(LawKind kind) {
  static const char *const names[] = {"energy", "damage", "energy or damage"};
  return names[kind];
}

bool law_id_is_valid(const char *id) {
  for (const char *c = id; *c; c++) {
    const bool letter = *c >= 'a' && *c <= 'z', digit = *c >= '0' && *c <= '9';
    const bool dot = *c == '.' && c != id && c[1] && c[1] != '.';
    if (!(letter || *c == '_' || dot || (digit && c != id))) return false;
  }
  return *id != '\0';
}

LawDescription law_describe_energy(const mlaw_energy *law) {
  return (LawDescription){.id = law->id,
                          .title = law->title,
                          .source = law->source,
                          .about = MLAW_HAS(mlaw_energy, law, about) ? law->about : NULL,
                          .params = law->params,
                          .vars = law->vars,
                          .n_params = law->n_params,
                          .param_size = law->param_size,
                          .n_vars = law->n_vars,
                          .var_size = law->var_size,
                          .check = law->check};
}

LawDescription law_describe_damage(const mlaw_damage *law) {
  return (LawDescription){.id = law->id,
                          .title = law->title,
                          .source = law->source,
                          .about = MLAW_HAS(mlaw_damage, law, about) ? law->about : NULL,
                          .params = law->params,
                          .vars = law->vars,
                          .n_params = law->n_params,
                          .param_size = law->param_size,
                          .n_vars = law->n_vars,
                          .var_size = law->var_size,
                          .check = law->check};
}

const mlaw_param *law_param(const LawDescription *law, uint32_t k) {
  return (const void *)((const char *)law->params + (size_t)k * law->param_size);
}

const mlaw_var *law_var(const LawDescription *law, uint32_t k) {
  return (const void *)((const char *)law->vars + (size_t)k * law->var_size);
}

#define REFUSE(...) return error_set(error, STATUS_INPUT, __VA_ARGS__)

/* Whether a table has entries of a size in which each can be read where it stands. */
static bool is_readable(const void *table, uint32_t size, size_t least, size_t alignment) {
  return table && size >= least && size % alignment == 0;
}

static Status check_tables(const LawDescription *law, LawKind kind, Error *error) {
  if (!law->id || !law->title || !law->source) {
    REFUSE("%s law `%s`: id, title and source must be given", law_kind_name(kind), law->id ? law->id : "?");
  }
  if (law->n_params &&
      !is_readable(law->params, law->param_size, offsetof(mlaw_param, ok_hi) + sizeof law->params->ok_hi,
                   _Alignof(mlaw_param))) {
    REFUSE("law `%s`: %u parameters of %u bytes each cannot be read", law->id, law->n_params,
           law->param_size);
  }
  for (uint32_t k = 0; k < law->n_params; k++) {
    const mlaw_param *param = law_param(law, k);
    if (!param->name || !param->unit || !param->about) {
      REFUSE("law `%s`: parameter %u has no name, unit or description", law->id, k);
    }
  }
  if (law->n_vars && !is_readable(law->vars, law->var_size, offsetof(mlaw_var, init) + sizeof law->vars->init,
                                  _Alignof(mlaw_var))) {
    REFUSE("law `%s`: %u variables of %u bytes each cannot be read", law->id, law->n_vars, law->var_size);
  }
  for (uint32_t k = 0; k < law->n_vars; k++) {
    const mlaw_var *var = law_var(law, k);
    if (!var->name || !var->unit || !var->about) {
      REFUSE("law `%s`: variable %u has no name, unit or description", law->id, k);
    }
  }
  return STATUS_OK;
}

static Status check_energy(const mlaw_energy *law, Error *error) {
  if (!law || !MLAW_HAS(mlaw_energy, law, eval)) {
    REFUSE("an energy law's descriptor is absent or shorter than that of ABI 1.0");
  }
  LawDescription description = law_describe_energy(law);
  Status status = check_tables(&description, LAW_ENERGY, error);
  if (status == STATUS_OK && !law->eval) REFUSE("energy law `%s` has no eval", law->id);
  return status;
}

static Status check_damage(const mlaw_damage *law, Error *error) {
  if (!law || !MLAW_HAS(mlaw_damage, law, update)) {
    REFUSE("a damage law's descriptor is absent or shorter than that of ABI 1.0");
  }
  LawDescription description = law_describe_damage(law);
  Status status = check_tables(&description, LAW_DAMAGE, error);
  if (status != STATUS_OK) return status;
  if (law->needs >> MLAW_N_CHANNELS) {
    REFUSE("damage law `%s` needs channels (mask 0x%x) that this host does not have (it has 0 to %d)",
           law->id, law->needs, MLAW_N_CHANNELS - 1);
  }
  if (law->update) {
    if (law->threshold || law->evolution) {
      REFUSE("damage law `%s` is of both kinds: it gives update as well as threshold or evolution", law->id);
    }
  } else {
    if (!law->threshold || !law->evolution) {
      REFUSE("damage law `%s` must give either threshold and evolution, or update", law->id);
    }
    if (law->needs != 1u << MLAW_Y || law->n_vars) {
      REFUSE("damage law `%s` is of the explicit kind: it needs the channel Y alone and has no variables",
             law->id);
    }
  }
  return STATUS_OK;
}

Status plugin_check(const mlaw_plugin *plugin, Error *error) {
  if (!plugin) {
    REFUSE("the plugin declines to serve a host of ABI %d.%d", MLAW_ABI_MAJOR, MLAW_ABI_MINOR);
  }
  if (!MLAW_HAS(mlaw_plugin, plugin, damage)) {
    REFUSE("the plugin's descriptor has %u bytes, fewer than that of ABI 1.0", plugin->size);
  }
  if (plugin->host_minor_min > MLAW_ABI_MINOR) {
    REFUSE("the plugin needs a host of ABI %d.%d or newer; this host has %d.%d", MLAW_ABI_MAJOR,
           plugin->host_minor_min, MLAW_ABI_MAJOR, MLAW_ABI_MINOR);
  }
  if (!plugin->id || !plugin->version || !plugin->license || !plugin->author) {
    REFUSE("the plugin's id, version, license and author must be given");
  }
  if ((plugin->n_energy && !plugin->energy) || (plugin->n_damage && !plugin->damage)) {
    REFUSE("plugin `%s` counts laws but has no table of them", plugin->id);
  }
  Status status = STATUS_OK;
  for (uint32_t k = 0; k < plugin->n_energy && status == STATUS_OK; k++) {
    status = check_energy(plugin->energy[k], error);
  }
  for (uint32_t k = 0; k < plugin->n_damage && status == STATUS_OK; k++) {
    status = check_damage(plugin->damage[k], error);
  }
  return status;
}

/* dlerror's words, without the path that they often begin with. */
static Status linker_says(const char *file, Error *error) {
  const char *words = dlerror();
  size_t length = strlen(file);
  if (!words) words = "the dynamic linker gives no reason";
  if (strncmp(words, file, length) == 0 && strncmp(words + length, ": ", 2) == 0) words += length + 2;
  REFUSE("cannot be opened: %s", words);
}

static Status no_entry(void *handle, Error *error) {
  for (int major = 0; major <= 9; major++) {
    char name[32];
    snprintf(name, sizeof name, "mlaw_plugin_v%d", major);
    if (dlsym(handle, name)) {
      REFUSE("the plugin speaks ABI %d (it exports %s), this host speaks ABI %d", major, name,
             MLAW_ABI_MAJOR);
    }
  }
  REFUSE("not a law plugin: it does not export %s", MLAW_ENTRY_NAME);
}

Status plugin_open(const char *file, const mlaw_plugin **plugin, Error *error) {
  dlerror();
  void *handle = dlopen(file, RTLD_NOW | RTLD_LOCAL); /* never closed: descriptors live for ever */
  if (!handle) return linker_says(file, error);
  void *symbol = dlsym(handle, MLAW_ENTRY_NAME);
  if (!symbol) return no_entry(handle, error);
  mlaw_entry_fn *entry;
  memcpy(&entry, &symbol, sizeof entry); /* ISO C has no conversion from object to function pointer */
  *plugin = entry(MLAW_ABI_MINOR);
  return plugin_check(*plugin, error);
}
