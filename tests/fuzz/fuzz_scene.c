/* Any bytes as a scene file: a scene or a message, and what a scene prints reads back to the same. */
#include "config/scene.h"
#include "fuzz.h"
#include <string.h>

static void expect(bool holds, const char *what, const Error *error) {
  if (holds) return;
  fprintf(stderr, "fuzz_scene: %s: %s\n", what, error->text);
  abort();
}

static void print(const Scene *scene, Text *yaml) {
  Error error;
  expect(scene_print(scene, "fuzz", yaml, &error) == STATUS_OK, "a scene cannot be printed", &error);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Error error = {0};
  Scene scene, again;
  Text first = {0}, second = {0};
  const Status status = scene_read_text(&scene, "fuzz.yaml", (const char *)data, size, NULL, 0, &error);
  expect(status == STATUS_OK || error.text[0], "no message", &error);
  if (status == STATUS_OK) {
    print(&scene, &first);
    expect(scene_read_text(&again, "printed.yaml", first.data, first.length, NULL, 0, &error) == STATUS_OK,
           "what was printed is refused", &error);
    print(&again, &second);
    expect(strcmp(first.data, second.data) == 0, "what was printed reads back to something else", &error);
    scene_free(&again);
    scene_free(&scene);
  }
  text_free(&first);
  text_free(&second);
  return 0;
}
