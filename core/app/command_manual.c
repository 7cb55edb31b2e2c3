/* capsella manual: the keys of a scene, from the table that reads them. */
#include "app/commands.h"
#include "base/text.h"
#include "config/scene.h"
#include <stdio.h>

int command_manual(int argc, char **argv) {
  if (argc > 1) {
    fprintf(stderr, "usage: capsella %s\n", argv[0]);
    return EXIT_INPUT;
  }
  Text manual = {0};
  Error error;
  const Status status = scene_print_manual(&manual, &error);
  if (status == STATUS_OK)
    fputs(manual.data, stdout);
  else
    fprintf(stderr, "%s\n", error.text);
  text_free(&manual);
  return exit_code(status);
}
