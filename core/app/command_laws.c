/* capsella laws: what laws there are and what each takes, printed from the descriptors alone. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "app/child.h"
#include "app/commands.h"
#include "app/help.h"
#include "base/array.h"
#include "laws/plugin.h"
#include "laws/search.h"
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Times after which a law is given up; they take milliseconds. */
enum { OPENING_SECONDS = 10, CALLING_SECONDS = 60 };

static int fail(const Error *error) {
  fprintf(stderr, "capsella laws: %s\n", error->text);
  return exit_code(error->code);
}

/* ---- list ---- */

typedef struct {
  LawKind kind;
  char *id, *title; /* owned */
  const char *file;
  bool hidden; /* an earlier file holds a law of this kind and id */
} Row;

typedef struct {
  Row *row;
  size_t n, capacity;
} Rows;

static void free_rows(Rows *rows) {
  for (size_t i = 0; i < rows->n; i++) {
    array_free(rows->row[i].id);
    array_free(rows->row[i].title);
  }
  array_free(rows->row);
}

static Status make_room(Rows *rows, Error *error) {
  Status status = STATUS_OK;
  Row *grown;
  if (rows->n < rows->capacity) return STATUS_OK;
  TRY(ARRAY_NEW(&grown, 2 * rows->capacity + 8, error));
  if (rows->n) memcpy(grown, rows->row, rows->n * sizeof *grown);
  array_free(rows->row);
  rows->row = grown;
  rows->capacity = 2 * rows->capacity + 8;
cleanup:
  return status;
}

static Status add_row(Rows *rows, LawKind kind, const char *id, const char *title, const char *file,
                      Error *error) {
  Status status = STATUS_OK;
  bool hidden = false;
  for (size_t i = 0; i < rows->n && !hidden; i++)
    hidden = rows->row[i].kind == kind && strcmp(rows->row[i].id, id) == 0;
  TRY(make_room(rows, error));
  Row *row = &rows->row[rows->n++];
  *row = (Row){.kind = kind, .file = file, .hidden = hidden};
  if (!(row->id = text_copy(id, error)) || !(row->title = text_copy(title, error))) status = error->code;
cleanup:
  return status;
}

/* A file describes itself: for each law its kind, id and title, or, with an exit code, why it cannot be used;
 * each ended by NUL. */
static int describe(void *file, FILE *answer) {
  Error reason;
  const mlaw_plugin *plugin;
  if (plugin_open(file, &plugin, &reason) != STATUS_OK) {
    fprintf(answer, "%s%c", reason.text, 0);
    return EXIT_INPUT;
  }
  for (uint32_t k = 0; k < plugin->n_energy; k++)
    fprintf(answer, "%d%c%s%c%s%c", LAW_ENERGY, 0, plugin->energy[k]->id, 0, plugin->energy[k]->title, 0);
  for (uint32_t k = 0; k < plugin->n_damage; k++)
    fprintf(answer, "%d%c%s%c%s%c", LAW_DAMAGE, 0, plugin->damage[k]->id, 0, plugin->damage[k]->title, 0);
  return EXIT_DONE;
}

/* Our own files are opened here: that takes no time, and they are known to open. */
static Status describe_here(char *file, Text *answer, int *code, Error *error) {
  char *bytes = NULL;
  size_t length = 0;
  FILE *stream = open_memstream(&bytes, &length);
  if (!stream) return error_set(error, STATUS_MEMORY, "out of memory");
  *code = describe(file, stream);
  const Status status = fclose(stream) == 0 ? text_append_bytes(answer, error, bytes, length)
                                            : error_set(error, STATUS_MEMORY, "out of memory");
  free(bytes);
  return status;
}

static Status ask(const LawSearch *search, char *file, Text *answer, int *code, Error *error) {
  char *absolute = realpath(file, NULL);
  const bool is_ours = absolute && law_search_owns(search, absolute);
  free(absolute);
  return is_ours ? describe_here(file, answer, code, error)
                 : child_run(describe, file, OPENING_SECONDS, answer, code, error);
}

/* The next text of an answer, or NULL. */
static const char *next_text(const Text *answer, size_t *at) {
  const char *text = answer->data + *at, *end = NULL;
  if (*at < answer->length) end = memchr(text, 0, answer->length - *at);
  if (!end) return NULL;
  *at += (size_t)(end - text) + 1;
  return text;
}

static Status add_answer(Rows *rows, const Text *answer, const char *file, Error *error) {
  Status status = STATUS_OK;
  size_t at = 0;
  for (;;) {
    const char *kind = next_text(answer, &at), *id = next_text(answer, &at), *title = next_text(answer, &at);
    if (!title) return STATUS_OK;
    TRY(add_row(rows, *kind == '0' + LAW_ENERGY ? LAW_ENERGY : LAW_DAMAGE, id, title, file, error));
  }
cleanup:
  return status;
}

/* A file that cannot be used is told of, and the others are listed. */
static Status add_file(Rows *rows, const LawSearch *search, char *file, Error *error) {
  Text answer = {0};
  int code = EXIT_DONE;
  Status status = ask(search, file, &answer, &code, error);
  if (status == STATUS_FAILED) {
    fprintf(stderr, "%s: %s when it was opened\n", file, error->text);
    status = STATUS_OK;
  } else if (status == STATUS_OK && (code != EXIT_DONE || answer.length == 0)) {
    fprintf(stderr, "%s: %s\n", file, answer.length > 0 ? answer.data : "gives no answer");
  } else if (status == STATUS_OK) {
    status = add_answer(rows, &answer, file, error);
  }
  text_free(&answer);
  return status;
}

static void print_rows(const Rows *rows) {
  int id_width = 2, title_width = 5;
  for (size_t i = 0; i < rows->n; i++) {
    const int id = (int)strlen(rows->row[i].id), title = (int)strlen(rows->row[i].title);
    if (id > id_width) id_width = id;
    if (title > title_width) title_width = title;
  }
  for (LawKind kind = LAW_ENERGY; kind <= LAW_DAMAGE; kind++) {
    for (size_t i = 0; i < rows->n; i++) {
      const Row *row = &rows->row[i];
      if (row->kind != kind) continue;
      printf("%s  %-*s  %-*s  %s%s\n", law_kind_name(kind), id_width, row->id, title_width, row->title,
             row->file, row->hidden ? "  (hidden by an earlier file)" : "");
    }
  }
}

/* A page that links to one page for each law (`show ID --markdown`). */
static void print_markdown(const Rows *rows) {
  static const char *const heading[] = {[LAW_ENERGY] = "Elasticity", [LAW_DAMAGE] = "Damage"};
  puts(
      "# Laws\n\n"
      "Written by `capsella laws list --markdown`, and each page by `capsella laws show ID --markdown`.\n"
      "How to add one: [writing a law](../writing-a-law.md).\n\n"
      "l1 >= l2 are the principal stretches, I1 = l1^2 + l2^2 - 2 and I2 = l1^2 l2^2 - 1 the invariants.\n"
      "phi is the energy per reference area; T1 >= T2 are the principal tensions of the undamaged membrane.\n"
      "Damage d scales the tensions by 1 - d; Y = phi of the undamaged membrane.\n"
      "`<x>` is x where positive and 0 elsewhere.\n"
      "A damage law is associated when Y alone drives it, through a threshold f(Y; d) <= 0.");
  for (LawKind kind = LAW_ENERGY; kind <= LAW_DAMAGE; kind++) {
    printf("\n## %s\n\n| id | law |\n|---|---|\n", heading[kind]);
    for (size_t i = 0; i < rows->n; i++) {
      const Row *row = &rows->row[i];
      if (row->kind == kind && !row->hidden) printf("| [`%s`](%s.md) | %s |\n", row->id, row->id, row->title);
    }
  }
}

static int list(bool markdown) {
  Status status;
  Error error;
  LawSearch search = {0};
  LawFiles files = {0};
  Rows rows = {0};
  TRY(law_search_default(&search, NULL, &error));
  TRY(law_search_files(&search, &files, &error));
  for (size_t i = 0; i < files.n; i++) TRY(add_file(&rows, &search, files.path[i], &error));
  (markdown ? print_markdown : print_rows)(&rows);
cleanup:
  free_rows(&rows);
  law_files_free(&files);
  law_search_free(&search);
  return status == STATUS_OK ? EXIT_DONE : fail(&error);
}

/* ---- the others ---- */

typedef struct {
  int (*run)(int argc, char **argv);
  int argc;
  char **argv;
} Command;

static int run_command(void *context, FILE *answer) {
  const Command *command = context;
  (void)answer; /* standard output, as in any process */
  return command->run(command->argc, command->argv);
}

/* A command that calls one law. */
static int call_apart(Command command) {
  Error error;
  int code = EXIT_FAILED;
  const Status status = child_run(run_command, &command, CALLING_SECONDS, NULL, &code, &error);
  if (status != STATUS_OK)
    fprintf(stderr, "capsella laws %s: %s %s; `capsella laws check` tells where\n", command.argv[0],
            command.argc > 1 ? command.argv[1] : "the law", error.text);
  return status == STATUS_OK ? code : exit_code(status);
}

static int unknown(const char *what) {
  const char *nearest = help_nearest("laws", what);
  char message[96];
  snprintf(message, sizeof message, "expected list, show, plot, check or new%s%s%s",
           nearest ? " (did you mean '" : "", nearest ? nearest : "", nearest ? "'?)" : "");
  return help_refuse("laws", message, what);
}

int command_laws(int argc, char **argv) {
  const char *what = argc > 1 ? argv[1] : "list";
  if (strcmp(what, "list") == 0) {
    const bool markdown = argc == 3 && strcmp(argv[2], "--markdown") == 0;
    if (argc > 2 && !markdown) return help_refuse("laws list", "expected no more than --markdown", argv[2]);
    return list(markdown);
  }
  if (strcmp(what, "show") == 0) return call_apart((Command){command_laws_show, argc - 1, argv + 1});
  if (strcmp(what, "plot") == 0) return call_apart((Command){command_laws_plot, argc - 1, argv + 1});
  if (strcmp(what, "check") == 0) return command_laws_check(argc - 1, argv + 1);
  if (strcmp(what, "new") == 0) return command_laws_new(argc - 1, argv + 1);
  return unknown(what);
}
