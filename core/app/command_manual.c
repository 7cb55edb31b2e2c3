/* capsella manual: the keys of a scene from the table that reads them, as Markdown or as JSON Schema, and the
 * files by which a system knows the program: man pages and completions. */
#include "app/commands.h"
#include "app/help.h"
#include "base/file.h"
#include "config/scene.h"
#include "study/json_schema_scene.h"
#include "study/json_schema_study.h"
#include <stdio.h>
#include <string.h>

typedef Status (*Print)(Text *text, Error *error);

/* ---- Files ---- */

static Status write_text(const char *folder, const char *below, const char *name, const Text *text,
                         Error *error) {
  Status status;
  Text place = {0}, path = {0};
  TRY(file_join(&place, folder, below, error));
  TRY(file_make_folder(place.data, error));
  TRY(file_join(&path, place.data, name, error));
  TRY(file_write(path.data, text->data, text->length, error));
cleanup:
  text_free(&place);
  text_free(&path);
  return status;
}

static Status write_man_page(const char *folder, const HelpPage *page, Error *error) {
  Status status;
  Text name = {0}, text = {0};
  TRY(help_print_man_name(page, &name, error));
  TRY(text_append(&name, error, ".1"));
  TRY(help_print_man(page, &text, error));
  TRY(write_text(folder, "man/man1", name.data, &text, error));
cleanup:
  text_free(&name);
  text_free(&text);
  return status;
}

/* Below `folder` as below /usr/share. */
static Status write_files(const char *folder, Error *error) {
  static const struct {
    const char *below, *name;
    Print print;
  } files[] = {
      {"bash-completion/completions", "capsella", help_print_bash},
      {"zsh/site-functions", "_capsella", help_print_zsh},
      {"capsella/schema", "scene.schema.json", json_schema_scene},
      {"capsella/schema", "study.schema.json", json_schema_study},
  };
  Status status = STATUS_OK;
  Text text = {0};
  for (size_t i = 0; i < N_HELP_PAGES; i++) TRY(write_man_page(folder, &HELP_PAGES[i], error));
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    text.length = 0;
    TRY(files[i].print(&text, error));
    TRY(write_text(folder, files[i].below, files[i].name, &text, error));
  }
cleanup:
  text_free(&text);
  return status;
}

/* ---- Standard output ---- */

static Status put(Print print, Error *error) {
  Text text = {0};
  const Status status = print(&text, error);
  if (status == STATUS_OK) fputs(text.data, stdout);
  text_free(&text);
  return status;
}

static int end(Status status, const Error *error) {
  if (status != STATUS_OK) fprintf(stderr, "%s\n", error->text);
  return exit_code(status);
}

int command_manual(int argc, char **argv) {
  Error error;
  const char *option = argc > 1 ? argv[1] : NULL, *value = argc == 3 ? argv[2] : NULL;
  if (!option) return end(put(scene_print_manual, &error), &error);
  if (value && strcmp(option, "--files") == 0) return end(write_files(value, &error), &error);
  if (value && strcmp(option, "--json-schema") == 0) {
    if (strcmp(value, "scene") == 0) return end(put(json_schema_scene, &error), &error);
    if (strcmp(value, "study") == 0) return end(put(json_schema_study, &error), &error);
    return help_refuse("manual", "expected scene or study after --json-schema", value);
  }
  return help_refuse("manual", "expected one option with its value, or none", option);
}
