/* capsella laws: what laws there are and what each takes, printed from the descriptors alone. */
#include "app/commands.h"
#include "base/array.h"
#include "laws/material.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char USAGE[] = "usage: capsella laws [list | show ID | check FILE.so | new DIR]\n";

static const char HELP[] =
    "\n"
    "  list      every law on the search path: kind, id, title, file\n"
    "  show ID   one law: source, parameters with units and ranges, moduli, channels; ID may be the path\n"
    "            of a plugin, FILE.so or FILE.so#ID\n"
    "  check FILE.so [--only REGEX] [--json]   does a plugin keep the rules, and are its laws sound?\n"
    "  new DIR --kind KIND [--cxx] [--name ID]   a folder with a law that builds, to be changed into yours\n"
    "\n"
    "Laws are looked for in the folders of MLAW_PLUGIN_PATH (colon-separated), then in those of the "
    "program.\n";

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

static int list(void) {
  Status status;
  Error error;
  LawSearch search = {0};
  LawFiles files = {0};
  Rows rows = {0};
  TRY(law_search_default(&search, NULL, &error));
  TRY(law_search_files(&search, &files, &error));
  for (size_t i = 0; i < files.n; i++) TRY(add_file(&rows, files.path[i], &error));
  print_rows(&rows);
cleanup:
  array_free(rows.row);
  law_files_free(&files);
  law_search_free(&search);
  return status == STATUS_OK ? EXIT_DONE : fail(&error);
}

/* ---- show ---- */

/* As in mathematics: [ and ] for ends that belong to the range, ( and ) for those that do not. */
static void print_range(double lo, double hi, bool open_lo, bool open_hi) {
  printf("%c%g, %g%c", open_lo || isinf(lo) ? '(' : '[', lo, hi, open_hi || isinf(hi) ? ')' : ']');
}

static void print_parameter(const mlaw_param *param) {
  printf("  %s (%s)  %s\n    ", param->name, param->unit, param->about);
  if (param->flags & MLAW_REQUIRED) {
    printf("required");
  } else {
    printf("default %g", param->value);
  }
  printf(", range ");
  print_range(param->lo, param->hi, param->flags & MLAW_OPEN_LO, param->flags & MLAW_OPEN_HI);
  if (param->ok_lo > param->lo || param->ok_hi < param->hi) {
    printf(", calibrated in ");
    print_range(param->ok_lo, param->ok_hi, false, false);
  }
  printf("\n");
}

static void print_tables(const LawDescription *law) {
  printf("parameters (dimensionless, or with a unit like the one shown)\n");
  for (uint32_t k = 0; k < law->n_params; k++) print_parameter(law_param(law, k));
  if (law->n_params == 0) printf("  none\n");
  if (law->n_vars) printf("history at each point\n");
  for (uint32_t k = 0; k < law->n_vars; k++) {
    const mlaw_var *var = law_var(law, k);
    printf("  %s (%s)  %s; starts at %g\n", var->name, var->unit, var->about, var->init);
  }
}

static void print_channels(const mlaw_damage *law) {
  static const char *const names[MLAW_N_CHANNELS] = {[MLAW_Y] = "Y (energy release rate)",
                                                     [MLAW_I1] = "I1",
                                                     [MLAW_I2] = "I2",
                                                     [MLAW_L1] = "L1 (larger principal stretch)",
                                                     [MLAW_L2] = "L2",
                                                     [MLAW_T1] = "T1 (larger principal tension)",
                                                     [MLAW_T2] = "T2"};
  printf("form       %s\ndriven by ",
         law->update ? "general (steps in time)" : "explicit (a function of the largest Y)");
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    if (law->needs & 1u << c) printf(" %s", names[c]);
  }
  printf("\n");
}

/* The moduli that a membrane of this law has with every parameter at its default; silent without defaults. */
static void print_moduli(const LoadedLaw *law, const LawSearch *search) {
  Material material;
  Error error;
  Scene scene = {0};
  Text request = {0};
  const LawDescription table = law_describe(law);
  for (uint32_t k = 0; k < table.n_params; k++) {
    if (law_param(&table, k)->flags & MLAW_REQUIRED) return;
  }
  if (text_append(&request, &error, "%s#%s", law->file, table.id) != STATUS_OK) return;
  scene.membrane.elastic.law = request.data;
  if (material_new(&material, &scene, search, NULL, NULL, NULL, &error) == STATUS_OK) {
    printf("moduli     G_s = %.10g, K_s = %.10g at rest, with defaults\n", material.shear_modulus,
           material.dilatation_modulus);
    material_free(&material);
  } else {
    printf("moduli     %s\n", error.text);
  }
  text_free(&request);
}

static void print_law(const LoadedLaw *law, const LawSearch *search) {
  const LawDescription table = law_describe(law);
  printf("%s: %s\n", table.id, table.title);
  printf("kind       %s\n", law_kind_name(law->energy ? LAW_ENERGY : LAW_DAMAGE));
  printf("source     %s\n", table.source);
  printf("file       %s (hash %016llx)\n", law->file, (unsigned long long)law->hash);
  printf("plugin     %s %s, ABI %d.%d, %s, by %s\n", law->plugin->id, law->plugin->version, MLAW_ABI_MAJOR,
         law->plugin->abi_minor, law->plugin->license, law->plugin->author);
  if (law->energy) {
    printf("gives      phi, first%s derivatives\n", law->energy->flags & MLAW_HESSIAN ? " and second" : "");
    print_moduli(law, search);
  } else {
    print_channels(law->damage);
  }
  print_tables(&table);
}

static int show(const char *request) {
  Status status;
  Error error;
  LawSearch search = {0};
  LoadedLaw law = {0};
  TRY(law_search_default(&search, ".", &error)); /* a path is meant from where the user is */
  TRY(law_load(&law, LAW_ANY, request, &search, &error));
  print_law(&law, &search);
cleanup:
  law_release(&law);
  law_search_free(&search);
  return status == STATUS_OK ? EXIT_DONE : fail(&error);
}

int command_laws(int argc, char **argv) {
  const char *what = argc > 1 ? argv[1] : "list";
  if (strcmp(what, "--help") == 0 || strcmp(what, "-h") == 0) {
    fputs(USAGE, stdout);
    fputs(HELP, stdout);
    return EXIT_DONE;
  }
  if (strcmp(what, "list") == 0 && argc <= 2) return list();
  if (strcmp(what, "show") == 0 && argc == 3) return show(argv[2]);
  if (strcmp(what, "check") == 0) return command_laws_check(argc - 1, argv + 1);
  if (strcmp(what, "new") == 0) return command_laws_new(argc - 1, argv + 1);
  fprintf(stderr, "capsella laws: expected list, show ID, new DIR or check FILE.so, found '%s%s%s'\n%s", what,
          argc > 2 ? " " : "", argc > 2 ? argv[2] : "", USAGE);
  return EXIT_INPUT;
}
