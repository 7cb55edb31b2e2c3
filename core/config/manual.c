/* The manual of scene files in Markdown: a short text, and the schema as tables. */
#include "config/schema.h"

#include <string.h>

static const char INTRODUCTION[] =
    "# Configuration\n"
    "\n"
    "A scene is one YAML file.\n"
    "The tables below hold every key that it may have; they are printed from the table by which the program\n"
    "reads scenes (`core/config/schema.c`).\n"
    "Keys are written with dots here and as nested mappings in the file:\n"
    "`flow.kind` is the key `kind` in the mapping `flow`.\n"
    "\n"
    "```yaml\n"
    "schema: 1\n"
    "membrane:\n"
    "  law: neo_hookean\n"
    "  parameters: {G_s: 1.0}\n"
    "  damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: 2.0}}\n"
    "flow: {kind: simple_shear, capillary_number: 0.7}\n"
    "time: {end: 10}\n"
    "```\n"
    "\n"
    "- **Mistakes stop the program** before anything is computed, with `FILE:LINE:COLUMN: expected ..., "
    "found\n"
    "  ...`: an unknown or a repeated key, a value of the wrong type or out of range, a missing key, a key "
    "that\n"
    "  another one excludes. Anchors, aliases and tags are not part of the format.\n"
    "- **Units.** Lengths are in units of the radius a, times of 1/rate, tensions of the shear modulus G_s.\n"
    "  With `flow.physical`, parameters of laws may have units: `0.1 N/m`, `35 um`, `1 mPa.s`, `20 1/s`.\n"
    "  A unit is a product of m, g, s, Hz, N, Pa, J, dyn, P and bar with prefixes f to G and powers such as\n"
    "  `s^-1`; a `/` divides by the one unit behind it.\n"
    "- **Types** follow from the key, not from the spelling: `name: no` is the text \"no\". Numbers are "
    "decimal\n"
    "  (`.5`, `1e3`); `nan` and `inf` are refused.\n"
    "- **`--set KEY=VALUE`** on the command line changes one value as if it were written in the file:\n"
    "  `--set membrane.damage.parameters.Y_D=0.3`. Without a value it removes the key: `--set "
    "membrane.damage=`.\n"
    "- **`resolved.yaml`**, beside the results, is the scene with every default written out. It is a scene "
    "file,\n"
    "  and gives the same numbers again.\n";

/* Length of the first name of a key when it is in a mapping, 0 for a key of the top level. */
static size_t section_length(const char *key) {
  const char *dot = strchr(key, '.');
  return dot ? (size_t)(dot - key) : 0;
}

static Status print_default(const SchemaRow *row, Text *markdown, Error *error) {
  Status status;
  if (row->fallback) {
    TRY(text_append(markdown, error, "`%s`", row->fallback));
  } else if (schema_has_preset(row)) {
    TRY(text_append(markdown, error, "by `accuracy`"));
  } else {
    TRY(text_append(markdown, error, row->type == TYPE_GROUP ? "none" : "required"));
  }
  if (row->where) TRY(text_append(markdown, error, "; only where %s", row->where->words));
cleanup:
  return status;
}

static Status print_row(const SchemaRow *row, Text *markdown, Error *error) {
  Status status;
  TRY(text_append(markdown, error, "| `%s` | ", row->key));
  TRY(schema_expected(row, markdown, error));
  TRY(text_append(markdown, error, " | "));
  TRY(print_default(row, markdown, error));
  TRY(text_append(markdown, error, " | %s |\n", row->meaning));
cleanup:
  return status;
}

/* One table: the rows whose key begins with the `length` bytes of `name`. */
static Status print_section(const char *name, size_t length, Text *markdown, Error *error) {
  Status status;
  if (length) {
    TRY(text_append(markdown, error, "\n## `%.*s`\n\n", (int)length, name));
  } else {
    TRY(text_append(markdown, error, "\n## Top level\n\n"));
  }
  TRY(text_append(markdown, error, "| key | value | default | meaning |\n|---|---|---|---|\n"));
  for (size_t i = 0; i < SCHEMA_ROWS; i++)
    if (section_length(SCHEMA[i].key) == length && strncmp(SCHEMA[i].key, name, length) == 0)
      TRY(print_row(&SCHEMA[i], markdown, error));
cleanup:
  return status;
}

static Status print_presets(Text *markdown, Error *error) {
  Status status;
  TRY(text_append(markdown, error, "\n## What `accuracy` sets\n\n| key |"));
  for (int k = 0; SCHEMA_ACCURACY[k]; k++) TRY(text_append(markdown, error, " `%s` |", SCHEMA_ACCURACY[k]));
  TRY(text_append(markdown, error, "\n|---|---|---|---|\n"));
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    if (!schema_has_preset(&SCHEMA[i])) continue;
    TRY(text_append(markdown, error, "| `%s` |", SCHEMA[i].key));
    for (int k = 0; SCHEMA_ACCURACY[k]; k++)
      TRY(text_append(markdown, error, " `%s` |", SCHEMA[i].preset[k]));
    TRY(text_append(markdown, error, "\n"));
  }
cleanup:
  return status;
}

Status scene_print_manual(Text *markdown, Error *error) {
  Status status;
  size_t before = 0;
  const char *section = "";
  TRY(text_append(markdown, error, "%s", INTRODUCTION));
  TRY(print_section("", 0, markdown, error));
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    size_t length = section_length(SCHEMA[i].key);
    bool is_new = length && (length != before || strncmp(SCHEMA[i].key, section, length) != 0);
    if (is_new) TRY(print_section(SCHEMA[i].key, length, markdown, error));
    if (length) {
      section = SCHEMA[i].key;
      before = length;
    }
  }
  TRY(scene_field_print_manual(markdown, error));
  TRY(print_presets(markdown, error));
cleanup:
  return status;
}
