/* One plugin file (mlaw.h): open it, negotiate, and read its tables.
 *
 * Shared objects are opened with RTLD_NOW | RTLD_LOCAL and never closed. */
#ifndef CAPSELLA_LAWS_PLUGIN_H
#define CAPSELLA_LAWS_PLUGIN_H

#include "base/status.h"
#include <mlaw/mlaw.h>
#include <stdbool.h>

typedef enum { LAW_ENERGY, LAW_DAMAGE, LAW_ANY } LawKind;

const char *law_kind_name(LawKind kind); /* "energy", "damage", "energy or damage" */

/* Lower-case letters, digits, _ and single dots inside, as in `vendor.name`; no part need be there but one.
 */
bool law_id_is_valid(const char *id);

/* Opens a file (a path with a slash) and negotiates.  On success every structure and string of the plugin can
 * be read as mlaw.h says.  On failure (STATUS_INPUT) the message is the reason alone, without the file's
 * name. */
Status plugin_open(const char *file, const mlaw_plugin **plugin, Error *error);

/* The part of plugin_open that looks at the tables; NULL is refused. */
Status plugin_check(const mlaw_plugin *plugin, Error *error);

/* What both kinds of law have in common. */
typedef struct {
  const char *id, *title, *source;
  const char *about;        /* NULL: the law says nothing, or was built before ABI 1.1 */
  const mlaw_param *params; /* walk with law_param */
  const mlaw_var *vars;     /* walk with law_var */
  uint32_t n_params, param_size, n_vars, var_size;
  int (*check)(const double *param, mlaw_error *err);
} LawDescription;

LawDescription law_describe_energy(const mlaw_energy *law);
LawDescription law_describe_damage(const mlaw_damage *law);

/* Entry k of a table, whatever the size that the plugin was built with. */
const mlaw_param *law_param(const LawDescription *law, uint32_t k);
const mlaw_var *law_var(const LawDescription *law, uint32_t k);

#endif
