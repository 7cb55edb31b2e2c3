/* capsella laws show: one law, from its descriptor alone, as text or as a page of Markdown. */
#include "app/commands.h"
#include "app/help.h"
#include "base/text.h"
#include "benchmark/law_timing.h"
#include "laws/material.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const char *const CHANNELS[MLAW_N_CHANNELS] = {[MLAW_Y] = "Y (energy release rate)",
                                                      [MLAW_I1] = "I1",
                                                      [MLAW_I2] = "I2",
                                                      [MLAW_L1] = "L1 (larger principal stretch)",
                                                      [MLAW_L2] = "L2",
                                                      [MLAW_T1] = "T1 (larger principal tension)",
                                                      [MLAW_T2] = "T2"};

/* As in mathematics: [ and ] for ends that belong to the range, ( and ) for those that do not. */
static void print_range(double lo, double hi, bool open_lo, bool open_hi) {
  printf("%c%g, %g%c", open_lo || isinf(lo) ? '(' : '[', lo, hi, open_hi || isinf(hi) ? ')' : ']');
}

static void print_hard_range(const mlaw_param *param) {
  print_range(param->lo, param->hi, param->flags & MLAW_OPEN_LO, param->flags & MLAW_OPEN_HI);
}

static bool is_calibrated(const mlaw_param *param) {
  return param->ok_lo > param->lo || param->ok_hi < param->hi;
}

static void print_default(const mlaw_param *param, const char *before) {
  if (param->flags & MLAW_REQUIRED)
    printf("required");
  else
    printf("%s%g", before, param->value);
}

static const char *form(const mlaw_damage *law) {
  return law->update ? "general (steps in time)" : "explicit (a function of the largest Y)";
}

static const char *derivatives(const mlaw_energy *law) {
  return law->flags & MLAW_HESSIAN ? "phi, first and second derivatives" : "phi, first derivatives";
}

static void print_channels(const mlaw_damage *law) {
  const char *separator = "";
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    if (!(law->needs & 1u << c)) continue;
    printf("%s%s", separator, CHANNELS[c]);
    separator = ", ";
  }
}

/* The moduli that a membrane of this law has with every parameter at its default; none without defaults. */
static void print_moduli(const char *before, const LoadedLaw *law, const LawSearch *search,
                         const char *after) {
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
    printf("%sG_s = %.10g, K_s = %.10g at rest, with defaults%s", before, material.shear_modulus,
           material.dilatation_modulus, after);
    material_free(&material);
  } else {
    printf("%s%s%s", before, error.text, after);
  }
  text_free(&request);
}

/* ---- Text ---- */

static void print_parameter(const mlaw_param *param) {
  printf("  %s (%s)  %s\n    ", param->name, param->unit, param->about);
  print_default(param, "default ");
  printf(", range ");
  print_hard_range(param);
  if (is_calibrated(param)) {
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

static void print_text(const LoadedLaw *law, const LawSearch *search) {
  const LawDescription table = law_describe(law);
  printf("%s: %s\n", table.id, table.title);
  printf("kind       %s\n", law_kind_name(law->energy ? LAW_ENERGY : LAW_DAMAGE));
  printf("source     %s\n", table.source);
  printf("file       %s (hash %016llx)\n", law->file, (unsigned long long)law->hash);
  printf("plugin     %s %s, ABI %d.%d, %s, by %s\n", law->plugin->id, law->plugin->version, MLAW_ABI_MAJOR,
         law->plugin->abi_minor, law->plugin->license, law->plugin->author);
  if (law->energy) {
    printf("gives      %s\n", derivatives(law->energy));
    print_moduli("moduli     ", law, search, "\n");
  } else {
    printf("form       %s\ndriven by  ", form(law->damage));
    print_channels(law->damage);
    printf("\n");
  }
  if (table.about) printf("\n%s\n", table.about);
  print_tables(&table);
}

/* ---- Markdown ---- */

static void print_parameter_row(const mlaw_param *param) {
  printf("| `%s` | %s | %s | ", param->name, param->unit, param->about);
  print_default(param, "");
  printf(" | ");
  print_hard_range(param);
  printf(" | ");
  if (is_calibrated(param)) print_range(param->ok_lo, param->ok_hi, false, false);
  printf(" |\n");
}

static void print_markdown_tables(const LawDescription *law) {
  if (law->n_params)
    printf("\n| parameter | unit | meaning | default | range | calibrated |\n|---|---|---|---|---|---|\n");
  for (uint32_t k = 0; k < law->n_params; k++) print_parameter_row(law_param(law, k));
  if (law->n_vars) printf("\n| history at each point | unit | meaning | start |\n|---|---|---|---|\n");
  for (uint32_t k = 0; k < law->n_vars; k++) {
    const mlaw_var *var = law_var(law, k);
    printf("| `%s` | %s | %s | %g |\n", var->name, var->unit, var->about, var->init);
  }
}

static void print_markdown(const LoadedLaw *law, const LawSearch *search) {
  const LawDescription table = law_describe(law);
  printf("# `%s`\n\n%s.\n\n", table.id, table.title);
  if (table.about) printf("%s\n", table.about);
  if (law->energy) {
    printf("| | |\n|---|---|\n| kind | elasticity, an energy law |\n| gives | %s |\n",
           derivatives(law->energy));
    print_moduli("| moduli | ", law, search, " |\n");
    if (table.n_vars == 0) printf("| dissipation | none: the tensions derive from phi |\n");
  } else {
    printf("| | |\n|---|---|\n| kind | damage, %s |\n| driven by | ", form(law->damage));
    print_channels(law->damage);
    printf(" |\n");
  }
  printf("| source | %s |\n| plugin | %s %s, %s, by %s |\n", table.source, law->plugin->id,
         law->plugin->version, law->plugin->license, law->plugin->author);
  print_markdown_tables(&table);
}

/* ---- Cost ---- */

static Status print_timing(const LoadedLaw *law, Error *error) {
  LawTiming timing;
  const Status status = law_timing(law, &timing, error);
  if (status != STATUS_OK) return status;
  printf("cost       ");
  for (int k = 0; k < LAW_BATCHES; k++)
    printf("%s%.1f ns per point in batches of %d", k ? ", " : "", timing.nanoseconds[k], law_batch_points[k]);
  printf("\n");
  return status;
}

static int fail(const Error *error) {
  fprintf(stderr, "capsella laws: %s\n", error->text);
  return exit_code(error->code);
}

int command_laws_show(int argc, char **argv) {
  Status status;
  Error error;
  LawSearch search = {0};
  LoadedLaw law = {0};
  const bool markdown = argc == 3 && strcmp(argv[2], "--markdown") == 0;
  const bool timing = argc == 3 && strcmp(argv[2], "--timing") == 0;
  if (argc != 2 && !markdown && !timing)
    return help_refuse("laws show", "expected one law and at most one option", argc > 2 ? argv[2] : NULL);
  TRY(law_search_default(&search, ".", &error)); /* a path is meant from where the user is */
  TRY(law_load(&law, LAW_ANY, argv[1], &search, &error));
  (markdown ? print_markdown : print_text)(&law, &search);
  if (timing) TRY(print_timing(&law, &error));
cleanup:
  law_release(&law);
  law_search_free(&search);
  return status == STATUS_OK ? EXIT_DONE : fail(&error);
}
