/* Any bytes as the file of a law: its symbols are listed, or it is no object of this machine. */
#include "fuzz.h"
#include "laws/elf_symbols.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Error error = {0};
  Text offered = {0}, taken = {0};
  const Status status = elf_symbols(fuzz_file(data, size), &offered, &taken, &error);
  if (status != STATUS_OK && !error.text[0]) abort();
  text_free(&offered);
  text_free(&taken);
  return 0;
}
