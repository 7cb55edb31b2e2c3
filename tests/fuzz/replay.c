/* Gives a fuzz target the files of a folder, and each of them cut off and with single bits turned, in any
 * compiler. */
#include "fuzz.h"

#include <dirent.h>
#include <string.h>

enum { LONGEST = 1 << 20, TURNS = 40 };

static size_t read_input(const char *folder, const char *name, uint8_t *data) {
  char path[1024];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  FILE *file = fopen(path, "rb");
  if (!file) return 0;
  const size_t size = fread(data, 1, LONGEST, file);
  fclose(file);
  return size;
}

static void replay(uint8_t *data, size_t size) {
  LLVMFuzzerTestOneInput(data, size);
  for (size_t k = 0; k < TURNS && size > 0; k++) {
    const size_t place = k * 7919 % size;
    data[place] ^= (uint8_t)(1 << k % 8);
    LLVMFuzzerTestOneInput(data, size);
    data[place] ^= (uint8_t)(1 << k % 8);
    LLVMFuzzerTestOneInput(data, place);
  }
}

int main(int argc, char **argv) {
  static uint8_t data[LONGEST];
  DIR *folder = argc == 2 ? opendir(argv[1]) : NULL;
  if (!folder) {
    fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  int files = 0;
  for (struct dirent *entry; (entry = readdir(folder));) {
    if (entry->d_name[0] == '.') continue;
    replay(data, read_input(argv[1], entry->d_name, data));
    files++;
  }
  closedir(folder);
  printf("%d files\n", files);
  return files == 0;
}
