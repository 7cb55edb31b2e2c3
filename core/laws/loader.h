/* Finding, opening and negotiating law plugins (mlaw.h).
 *
 * A law is asked for by name ("skalak", "acme.creep") or by the path of a shared object ("./acme.so", or
 * "./acme.so#acme.creep" when it holds several laws of the kind).  Only files that the request names are
 * opened, with RTLD_NOW | RTLD_LOCAL, and they stay open to the end of the process.  Nothing here knows a law
 * by name. */
#ifndef CAPSELLA_LAWS_LOADER_H
#define CAPSELLA_LAWS_LOADER_H

#include "base/status.h"
#include "base/text.h"
#include <mlaw/mlaw.h>
#include <stdint.h>

/* Folders in the order they are searched; made by law_search_default. */
typedef struct {
  char **folder;
  size_t n;
} LawSearch;

/* The scene's folder (may be NULL), then MLAW_PLUGIN_PATH (colon-separated), then `plugins` beside the
 * program (build tree), then the installed folder relative to the program.  Duplicates and empty entries are
 * dropped. */
Status law_search_default(LawSearch *search, const char *scene_folder, Error *error);
void law_search_free(LawSearch *search);

/* A law that was found: exactly one of energy and damage is set. */
typedef struct {
  const mlaw_plugin *plugin;
  const mlaw_energy *energy;
  const mlaw_damage *damage;
  char *file;    /* path of the shared object */
  uint64_t hash; /* of its bytes */
} LoadedLaw;

typedef enum { LAW_ENERGY, LAW_DAMAGE } LawKind;

/* On failure the message names every file tried and why it would not do, and the nearest known name. */
Status law_load(LoadedLaw *law, LawKind kind, const char *request, const LawSearch *search, Error *error);
void law_release(LoadedLaw *law); /* frees the strings; the shared object stays open */

#endif
