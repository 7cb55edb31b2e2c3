/* capsella laws: what laws there are and what each takes, printed from the descriptors alone. */
#include "app/commands.h"
#include "app/help.h"
#include "base/array.h"
#include "laws/plugin.h"
#include "laws/search.h"
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static int fail(const Error *error) {
  fprintf(stderr, "capsella laws: %s\n", error->text);
  return exit_code(error->code);
}

/* ---- list ---- */

typedef struct {
  LawKind kind;
  const char *id, *title, *file;
  bool hidden; /* an earlier file holds a law of this kind and id */
} Row;

typedef struct {
  Row *row;
  size_t n, capacity;
} Rows;

static Status add_row(Rows *rows, Row row, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < rows->n; i++) {
    if (rows->row[i].kind == row.kind && strcmp(rows->row[i].id, row.id) == 0) row.hidden = true;
  }
  if (rows->n == rows->capacity) {
    Row *grown;
    TRY(ARRAY_NEW(&grown, 2 * rows->capacity + 8, error));
    if (rows->n) memcpy(grown, rows->row, rows->n * sizeof *grown);
    array_free(rows->row);
    rows->row = grown;
    rows->capacity = 2 * rows->capacity + 8;
  }
  rows->row[rows->n++] = row;
cleanup:
  return status;
}

static Status add_file(Rows *rows, const char *file, Error *error) {
  Status status = STATUS_OK;
  Error reason;
  const mlaw_plugin *plugin;
  if (plugin_open(file, &plugin, &reason) != STATUS_OK) {
    fprintf(stderr, "%s: %s\n", file, reason.text);
    return STATUS_OK;
  }
  for (uint32_t k = 0; k < plugin->n_energy; k++) {
    const mlaw_energy *law = plugin->energy[k];
    TRY(add_row(rows, (Row){LAW_ENERGY, law->id, law->title, file, false}, error));
  }
  for (uint32_t k = 0; k < plugin->n_damage; k++) {
    const mlaw_damage *law = plugin->damage[k];
    TRY(add_row(rows, (Row){LAW_DAMAGE, law->id, law->title, file, false}, error));
  }
cleanup:
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
  for (size_t i = 0; i < files.n; i++) TRY(add_file(&rows, files.path[i], &error));
  (markdown ? print_markdown : print_rows)(&rows);
cleanup:
  array_free(rows.row);
  law_files_free(&files);
  law_search_free(&search);
  return status == STATUS_OK ? EXIT_DONE : fail(&error);
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
  if (strcmp(what, "show") == 0) return command_laws_show(argc - 1, argv + 1);
  if (strcmp(what, "plot") == 0) return command_laws_plot(argc - 1, argv + 1);
  if (strcmp(what, "check") == 0) return command_laws_check(argc - 1, argv + 1);
  if (strcmp(what, "new") == 0) return command_laws_new(argc - 1, argv + 1);
  return unknown(what);
}
