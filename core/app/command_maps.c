/* capsella maps: fields over the membrane, side by side. */
#include "app/commands.h"
#include "app/help.h"
#include "base/file.h"
#include "run/maps.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Cuts a list at its commas into names; false when there are too many or an empty one. */
static bool take_names(char *list, const char *names[MAPS_MOST], size_t *n) {
  for (*n = 0; list; ++*n) {
    char *comma = strchr(list, ',');
    if (comma) *comma = '\0';
    if (*n == MAPS_MOST || !*list) return false;
    names[*n] = list;
    list = comma ? comma + 1 : NULL;
  }
  return true;
}

static bool take_times(char *list, MapsOptions *options) {
  const char *names[MAPS_MOST];
  if (!take_names(list, names, &options->n_times)) return false;
  for (size_t k = 0; k < options->n_times; k++) {
    char *end;
    options->times[k] = strtod(names[k], &end);
    if (end == names[k] || *end) return false;
  }
  return true;
}

/* LOW:HIGH */
static bool take_range(const char *text, MapsOptions *options) {
  char *end;
  options->minimum = strtod(text, &end);
  if (end == text || *end != ':') return false;
  text = end + 1;
  options->maximum = strtod(text, &end);
  return end != text && !*end && options->maximum > options->minimum &&
         isfinite(options->maximum - options->minimum);
}

static bool take_option(const char *flag, char *value, MapsOptions *options, const char **file) {
  if (strcmp(flag, "--at") == 0) return take_times(value, options);
  if (strcmp(flag, "--field") == 0) return take_names(value, options->fields, &options->n_fields);
  if (strcmp(flag, "--view") == 0) return take_names(value, options->views, &options->n_views);
  if (strcmp(flag, "--range") == 0) return take_range(value, options);
  if (strcmp(flag, "-o") != 0) return false;
  *file = value;
  return true;
}

static int refuse(const char *what, const char *found) {
  return help_refuse("maps", what, found);
}

/* Fills in the options; -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, MapsOptions *options, const char **file) {
  for (int i = 1; i < argc; i++) {
    if (argv[i][0] == '-') {
      char *value = i + 1 < argc ? argv[i + 1] : NULL;
      if (!value || !take_option(argv[i], value, options, file))
        return refuse("expected an option with its value", argv[i]);
      i++;
    } else if (options->n_folders == MAPS_MOST) {
      return refuse("too many folders", argv[i]);
    } else {
      options->folders[options->n_folders++] = argv[i];
    }
  }
  if (options->n_folders == 0) return refuse("expected the folder of a run", NULL);
  if (options->n_folders > 1 && options->n_times > 0) return refuse("--at is for one folder", NULL);
  return -1;
}

static Status draw(const MapsOptions *options, const char *file, Text *path, Error *error) {
  Status status;
  Text svg = {0};
  TRY(maps_print(options, &svg, error));
  TRY(file ? text_append(path, error, "%s", file) : file_join(path, options->folders[0], "maps.svg", error));
  TRY(file_write(path->data, svg.data, svg.length, error));
cleanup:
  text_free(&svg);
  return status;
}

int command_maps(int argc, char **argv) {
  MapsOptions options = {.fields = {"d"}, .n_fields = 1, .views = {"shear"}, .n_views = 1};
  const char *file = NULL;
  Text path = {0};
  Error error;
  const int parsed = parse(argc, argv, &options, &file);
  if (parsed >= 0) return parsed;
  const Status status = draw(&options, file, &path, &error);
  if (status == STATUS_OK)
    printf("%s\n", path.data);
  else
    fprintf(stderr, "capsella maps: %s\n", error.text);
  text_free(&path);
  return exit_code(status);
}
