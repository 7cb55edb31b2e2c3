/* capsella laws new: a folder with a law that builds and passes its check, to be changed into another.  Its
 * files are those of plugins/template and core/sdk/mlaw with other names. */
#define _XOPEN_SOURCE 700 /* readlink */
#include "app/commands.h"
#include "app/help.h"
#include "app/sdk_files.h"
#include "base/file.h"
#include "laws/loader.h"
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef struct {
  const char *name, *template;
} Kind;

static const Kind KINDS[] = {
    {"constitutive", "energy_law"},
    {"damage", "explicit_damage_law"},
    {"damage-general", "general_damage_law"},
};
enum { N_KINDS = sizeof KINDS / sizeof *KINDS };

typedef struct {
  const char *folder, *id;
  const Kind *kind;
  bool cxx;
} Options;

static int refuse(const char *message, const char *found) {
  return help_refuse("laws new", message, found);
}

static int fail(const Error *error) {
  fprintf(stderr, "capsella laws new: %s\n", error->text);
  return exit_code(error->code);
}

/* What follows the last of these characters, or all of it. */
static const char *after_last(const char *text, char separator) {
  const char *at = strrchr(text, separator);
  return at ? at + 1 : text;
}

static const Kind *find_kind(const char *name) {
  for (int k = 0; k < N_KINDS; k++)
    if (strcmp(KINDS[k].name, name) == 0) return &KINDS[k];
  return NULL;
}

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, Options *options) {
  for (int i = 1; i < argc; i++) {
    const char *option = argv[i];
    if (strcmp(option, "--cxx") == 0) {
      options->cxx = true;
    } else if (strcmp(option, "--kind") == 0 || strcmp(option, "--name") == 0) {
      if (++i == argc) return help_refuse("laws new", "expected a value after this option", option);
      if (option[2] == 'n') {
        options->id = argv[i];
      } else if (!(options->kind = find_kind(argv[i]))) {
        return refuse("expected the kind constitutive, damage or damage-general", argv[i]);
      }
    } else if (option[0] == '-' || options->folder) {
      return refuse("expected one folder and options", option);
    } else {
      options->folder = option;
    }
  }
  if (!options->folder) return refuse("expected a folder, found none", NULL);
  if (!options->kind) return refuse("expected --kind constitutive, damage or damage-general", NULL);
  if (!options->id) options->id = after_last(options->folder, '/');
  if (!law_id_is_valid(options->id))
    return refuse("expected an id of lower-case letters, digits, _ and dots (--name vendor.name)",
                  options->id);
  return -1;
}

/* Another law of this id would make one of the two hard to reach. */
static Status check_free(const Options *options, Error *error) {
  Status status;
  Error none;
  LawSearch search = {0};
  LoadedLaw other = {0};
  if (access(options->folder, F_OK) == 0)
    TRY(error_set(error, STATUS_INPUT, "%s: expected a folder that is not there yet", options->folder));
  TRY(law_search_default(&search, NULL, error));
  if (law_load(&other, LAW_ANY, options->id, &search, &none) == STATUS_OK)
    TRY(error_set(error, STATUS_INPUT, "the law `%s` exists, in %s; choose another id with --name",
                  options->id, other.file));
cleanup:
  law_release(&other);
  law_search_free(&search);
  return status;
}

/* ---- Templates with other names ---- */

typedef struct {
  const char *from, *to;
} Replacement;

enum { N_REPLACEMENTS = 9 };

/* What the templates call `acme.newlaw`, in newlaw.c, has these names in the new folder. */
typedef struct {
  Text name, source, program;
  Replacement replacement[N_REPLACEMENTS]; /* the first that fits is taken; in C the last ones are not */
} Names;

static Status names_new(Names *names, const Options *options, Error *error) {
  Status status;
  char program[4096];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program);
  const bool known = length > 0 && length < (ssize_t)sizeof program;
  TRY(text_append(&names->name, error, "%s", after_last(options->id, '.')));
  TRY(text_append(&names->source, error, "%s.%s", names->name.data, options->cxx ? "cpp" : "c"));
  TRY(text_append(&names->program, error, "%.*s", known ? (int)length : 8, known ? program : "capsella"));
  const Replacement list[N_REPLACEMENTS] = {{"acme.newlaw", options->id},
                                            {"newlaw.c", names->source.data},
                                            {"newlaw", names->name.data},
                                            {"@CAPSELLA@", names->program.data},
                                            {options->cxx ? "$(CC) -std=c11" : NULL, "$(CXX) -std=c++20"},
                                            {"cc -std=c11", "c++ -std=c++20"},
                                            {"CFLAGS", "CXXFLAGS"},
                                            {"LANGUAGES C", "LANGUAGES CXX"}};
  memcpy(names->replacement, list, sizeof list);
cleanup:
  return status;
}

static void names_free(Names *names) {
  text_free(&names->name);
  text_free(&names->source);
  text_free(&names->program);
}

static const Replacement *find_replacement(const Names *names, const char *at, size_t left) {
  for (const Replacement *r = names->replacement; r->from; r++)
    if (strlen(r->from) <= left && memcmp(at, r->from, strlen(r->from)) == 0) return r;
  return NULL;
}

static Status rename_words(Text *out, const SdkFile *file, const Names *names, Error *error) {
  Status status = STATUS_OK;
  const char *bytes = (const char *)file->bytes;
  for (size_t i = 0; i < file->length;) {
    const Replacement *r = find_replacement(names, bytes + i, file->length - i);
    TRY(text_append_bytes(out, error, r ? r->to : bytes + i, r ? strlen(r->to) : 1));
    i += r ? strlen(r->from) : 1;
  }
cleanup:
  return status;
}

/* ---- The folder ---- */

/* What a file of the SDK is called in the new folder; NULL: it has no place there. */
static const char *new_name(const SdkFile *file, const Options *options, const Names *names) {
  const char *name = after_last(file->path, '/'), *dot = strrchr(name, '.');
  const size_t stem = strlen(options->kind->template);
  if (strncmp(file->path, "mlaw/", 5) == 0) return file->path;
  if (strcmp(name, "Makefile") == 0 || strcmp(name, "CMakeLists.txt") == 0) return name;
  if (strncmp(name, options->kind->template, stem) != 0 || name[stem] != '.') return NULL;
  return strcmp(dot, ".c") == 0 ? names->source.data : "scene.yaml";
}

static Status write_file(const SdkFile *file, const char *name, const Options *options, const Names *names,
                         Error *error) {
  Status status;
  Text path = {0}, text = {0};
  TRY(file_join(&path, options->folder, name, error));
  if (strncmp(name, "mlaw/", 5) == 0)
    TRY(text_append_bytes(&text, error, (const char *)file->bytes, file->length));
  else
    TRY(rename_words(&text, file, names, error));
  TRY(file_write(path.data, text.data, text.length, error));
cleanup:
  text_free(&text);
  text_free(&path);
  return status;
}

static Status write_folder(const Options *options, const Names *names, Error *error) {
  Status status;
  Text headers = {0};
  TRY(file_join(&headers, options->folder, "mlaw", error));
  TRY(file_make_folder(headers.data, error));
  for (size_t i = 0; i < N_SDK_FILES; i++) {
    const char *name = new_name(&SDK_FILES[i], options, names);
    if (name) TRY(write_file(&SDK_FILES[i], name, options, names, error));
  }
cleanup:
  text_free(&headers);
  return status;
}

static void print_next_steps(const Options *options, const Names *names) {
  printf("%s/%s: the law %s, sound already; put your mathematics in its place.\n\n"
         "  make -C %s check    builds it and checks that it keeps the rules\n"
         "  make -C %s run      runs %s/scene.yaml, a capsule in shear flow, with it\n",
         options->folder, names->source.data, options->id, options->folder, options->folder, options->folder);
}

int command_laws_new(int argc, char **argv) {
  Options options = {0};
  Names names = {0};
  Status status;
  Error error;
  const int code = parse(argc, argv, &options);
  if (code >= 0) return code;
  TRY(check_free(&options, &error));
  TRY(names_new(&names, &options, &error));
  TRY(write_folder(&options, &names, &error));
  print_next_steps(&options, &names);
cleanup:
  names_free(&names);
  return status == STATUS_OK ? EXIT_DONE : fail(&error);
}
