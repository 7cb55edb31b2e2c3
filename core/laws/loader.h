/* Finding the law that a scene asks for.
 *
 * A law is asked for by its id ("skalak", "acme.creep") or by the path of a shared object ("./acme.so", or
 * "./acme.so#acme.creep" when it holds several laws of the kind).  The id `skalak` is looked for in
 * skalak.so; `acme.creep` in acme.creep.so, creep.so and acme.so.  Only files that a request names are
 * opened.  A file that is there but cannot serve ends the search: it is never passed over in favour of a
 * later one.  Nothing here knows a law by name. */
#ifndef CAPSELLA_LAWS_LOADER_H
#define CAPSELLA_LAWS_LOADER_H

#include "base/status.h"
#include "laws/plugin.h"
#include "laws/search.h"
#include <mlaw/mlaw.h>
#include <stdint.h>

/* A law that was found: exactly one of energy and damage is set. */
typedef struct {
  const mlaw_plugin *plugin;
  const mlaw_energy *energy;
  const mlaw_damage *damage;
  char *file;    /* absolute path of the shared object */
  uint64_t hash; /* of its bytes */
} LoadedLaw;

/* `request` as above; a relative path is taken from each folder of the search in turn.  On failure
 * (STATUS_INPUT) the message names every file tried and why it would not do, and the nearest known name. */
Status law_load(LoadedLaw *law, LawKind kind, const char *request, const LawSearch *search, Error *error);
void law_release(LoadedLaw *law); /* frees the strings; the shared object stays open */

LawDescription law_describe(const LoadedLaw *law);

#endif
