/* From a request to candidates, from candidates to a law, and the report when there is none.  Opening a file
 * is plugin.c's work, parameters and values are material.c's. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "laws/loader.h"

#include "base/array.h"
#include "base/file.h"
#include "base/text.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

LawDescription law_describe(const LoadedLaw *law) {
  return law->energy ? law_describe_energy(law->energy) : law_describe_damage(law->damage);
}

/* What is asked for, what was found, and what was tried. */
typedef struct {
  LawKind kind;
  const char *id; /* NULL: the only law of the kind that the file holds */
  bool by_path;
  LoadedLaw *law;
  bool done; /* found, or a file that is there cannot serve */
  Text tried;
} Attempt;

static Status report(Attempt *attempt, const char *file, const char *reason, Error *error) {
  return text_append(&attempt->tried, error, "\n  %s: %s", file, reason);
}

static bool fits(const Attempt *attempt, LawKind kind, const char *id) {
  return (attempt->kind == kind || attempt->kind == LAW_ANY) &&
         (!attempt->id || strcmp(attempt->id, id) == 0);
}

/* Takes the law that fits; returns how many fit. */
static uint32_t choose(const Attempt *attempt, const mlaw_plugin *plugin) {
  uint32_t fit = 0;
  for (uint32_t k = 0; k < plugin->n_energy; k++) {
    if (!fits(attempt, LAW_ENERGY, plugin->energy[k]->id)) continue;
    *attempt->law = (LoadedLaw){.plugin = plugin, .energy = plugin->energy[k]};
    fit++;
  }
  for (uint32_t k = 0; k < plugin->n_damage; k++) {
    if (!fits(attempt, LAW_DAMAGE, plugin->damage[k]->id)) continue;
    *attempt->law = (LoadedLaw){.plugin = plugin, .damage = plugin->damage[k]};
    fit++;
  }
  return fit;
}

static Status report_contents(Attempt *attempt, const char *file, const mlaw_plugin *plugin, Error *error) {
  Status status;
  Text holds = {0};
  TRY(text_append(&holds, error, "has no law that fits; it holds"));
  for (uint32_t k = 0; k < plugin->n_energy; k++) {
    TRY(text_append(&holds, error, " %s (energy)", plugin->energy[k]->id));
  }
  for (uint32_t k = 0; k < plugin->n_damage; k++) {
    TRY(text_append(&holds, error, " %s (damage)", plugin->damage[k]->id));
  }
  if (attempt->by_path && !attempt->id) TRY(text_append(&holds, error, "; choose one with FILE.so#ID"));
  TRY(report(attempt, file, holds.data, error));
cleanup:
  text_free(&holds);
  return status;
}

static Status admit(const LawSearch *search, const char *file, Error *reason) {
  return search->admit && !law_search_owns(search, file) ? search->admit(file, reason) : STATUS_OK;
}

static bool is_source(const char *file) {
  const char *end = strrchr(file, '.');
  return end && (strcmp(end, ".c") == 0 || strcmp(end, ".cpp") == 0);
}

static Status try_file(Attempt *attempt, const char *file, const LawSearch *search, Error *error) {
  Status status = STATUS_OK;
  Error reason;
  const mlaw_plugin *plugin;
  char *absolute = NULL;
  if (!file_exists(file)) {
    return report(attempt, file, access(file, F_OK) == 0 ? "not a file that can be read" : "no such file",
                  error);
  }
  if (is_source(file))
    return report(attempt, file, "is a source; what a scene names is the .so that is built from it", error);
  absolute = realpath(file, NULL);
  if (!absolute) TRY(error_set(error, STATUS_IO, "%s: its absolute path cannot be had", file));
  attempt->done = true; /* the file is there: no later one takes its place */
  status = admit(search, absolute, &reason);
  if (status == STATUS_OK) status = plugin_open(absolute, &plugin, &reason);
  if (status == STATUS_INPUT) {
    TRY(report(attempt, file, reason.text, error));
  } else if (status != STATUS_OK) { /* no fault of the file */
    TRY(error_set(error, status, "%s: %s", file, reason.text));
  } else if (choose(attempt, plugin) != 1) {
    attempt->done = attempt->by_path;
    TRY(report_contents(attempt, file, plugin, error));
  } else {
    TRY(file_hash(absolute, &attempt->law->hash, error));
    if (!(attempt->law->file = text_copy(absolute, error))) status = error->code;
  }
cleanup:
  free(absolute);
  return status;
}

/* The file name in every folder of the search, or as it stands when it is absolute. */
static Status try_folders(Attempt *attempt, const char *name, const LawSearch *search, Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  const size_t n = name[0] == '/' ? 1 : search->n;
  for (size_t i = 0; i < n && !attempt->done; i++) {
    path.length = 0;
    TRY(file_join(&path, name[0] == '/' ? "" : search->folder[i], name, error));
    TRY(try_file(attempt, path.data, search, error));
  }
cleanup:
  text_free(&path);
  return status;
}

static Status try_name(Attempt *attempt, int length, const char *name, const LawSearch *search,
                       Error *error) {
  Status status;
  Text file = {0};
  if (attempt->done) return STATUS_OK;
  TRY(text_append(&file, error, "%.*s.so", length, name));
  TRY(try_folders(attempt, file.data, search, error));
cleanup:
  text_free(&file);
  return status;
}

/* `skalak`: skalak.so; `acme.creep`: acme.creep.so, creep.so, acme.so. */
static Status try_id(Attempt *attempt, const LawSearch *search, Error *error) {
  Status status;
  const char *id = attempt->id, *last = strrchr(id, '.'), *first = strchr(id, '.');
  TRY(try_name(attempt, (int)strlen(id), id, search, error));
  if (last) {
    TRY(try_name(attempt, (int)strlen(last + 1), last + 1, search, error));
    TRY(try_name(attempt, (int)(first - id), id, search, error));
  }
cleanup:
  return status;
}

/* `acme.so` or `acme.so#acme.creep`. */
static Status try_path(Attempt *attempt, const char *request, const LawSearch *search, Error *error) {
  Status status;
  Text file = {0};
  const char *hash = strchr(request, '#');
  attempt->by_path = true;
  attempt->id = hash ? hash + 1 : NULL;
  TRY(text_append(&file, error, "%.*s", (int)(hash ? (size_t)(hash - request) : strlen(request)), request));
  TRY(try_folders(attempt, file.data, search, error));
cleanup:
  text_free(&file);
  return status;
}

/* A slash, or the suffix .so, makes a path of a request. */
static bool is_path(const char *request) {
  const char *end = strchr(request, '#');
  const size_t length = end ? (size_t)(end - request) : strlen(request);
  return strchr(request, '/') || (length > 3 && strncmp(request + length - 3, ".so", 3) == 0);
}

static Status not_found(const Attempt *attempt, const char *request, const LawSearch *search, Error *error) {
  Status status;
  LawFiles files = {0};
  const char *nearest = NULL;
  TRY(law_search_files(search, &files, error));
  if (!attempt->done) nearest = text_nearest(request, (const char *const *)files.name, files.n);
  if (nearest && strcmp(nearest, request) == 0) nearest = NULL; /* such a file is there: see the report */
  error_set(error, STATUS_INPUT, "expected the %s law `%s`, found none that can be used%s%s%s; tried%s:%s",
            law_kind_name(attempt->kind), request, nearest ? " (did you mean `" : "", nearest ? nearest : "",
            nearest ? "`?)" : "", attempt->done || attempt->by_path ? "" : " (MLAW_PLUGIN_PATH adds folders)",
            attempt->tried.data ? attempt->tried.data : " nothing, for lack of folders");
  status = STATUS_INPUT;
cleanup:
  law_files_free(&files);
  return status;
}

Status law_load(LoadedLaw *law, LawKind kind, const char *request, const LawSearch *search, Error *error) {
  Status status;
  Attempt attempt = {.kind = kind, .id = request, .law = law};
  *law = (LoadedLaw){0};
  if (is_path(request)) {
    TRY(try_path(&attempt, request, search, error));
  } else {
    TRY(try_id(&attempt, search, error));
  }
  if (!law->file) TRY(not_found(&attempt, request, search, error));
cleanup:
  text_free(&attempt.tried);
  if (status != STATUS_OK) *law = (LoadedLaw){0};
  return status;
}

void law_release(LoadedLaw *law) {
  array_free(law->file);
  *law = (LoadedLaw){0};
}
