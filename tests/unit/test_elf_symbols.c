/* What shared objects offer and take, read from their bytes. */
#include "base/file.h"
#include "law_scene.h"
#include "laws/elf_symbols.h"
#include "scratch.h"
#include "suite.h"
#include <string.h>

START_TEST(a_plugin_offers_its_entry_alone) {
  Text offered = {0}, taken = {0};
  Error error;
  ck_assert_int_eq(elf_symbols(PLUGINS "/skalak.so", &offered, &taken, &error), STATUS_OK);
#ifndef __SANITIZE_ADDRESS__
  ck_assert_str_eq(offered.data, "mlaw_plugin_v1 ");
#endif
  text_free(&offered);
  text_free(&taken);
}
END_TEST

START_TEST(what_is_called_elsewhere_is_listed_as_taken) {
  Text offered = {0}, taken = {0};
  Error error;
  ck_assert_int_eq(elf_symbols(BROKEN "/undefined.so", &offered, &taken, &error), STATUS_OK);
  ck_assert_ptr_nonnull(strstr(taken.data, "missing_from_every_library "));
  ck_assert_ptr_null(strstr(offered.data, "missing_from_every_library "));
  text_free(&offered);
  text_free(&taken);
}
END_TEST

START_TEST(another_file_is_refused) {
  Text offered = {0}, taken = {0};
  Error error;
  ck_assert_int_eq(elf_symbols(SOURCE_DIR "/CMakeLists.txt", &offered, &taken, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "expected an ELF object of this machine"));
  ck_assert_int_eq(elf_symbols("/nowhere/at/all.so", &offered, &taken, &error), STATUS_IO);
  text_free(&offered);
  text_free(&taken);
}
END_TEST

/* Whatever offsets point beyond the end, nothing is read there (the sanitizers watch). */
START_TEST(a_file_cut_off_anywhere_is_survived) {
  Text whole = {0};
  Error error;
  ck_assert_int_eq(file_read(PLUGINS "/skalak.so", 1 << 24, &whole, &error), STATUS_OK);
  ck_assert(scratch_make());
  for (size_t length = 0; length < whole.length; length += 97) {
    Text offered = {0}, taken = {0};
    ck_assert_int_eq(file_write(scratch_path("cut.so"), whole.data, length, &error), STATUS_OK);
    const Status status = elf_symbols(scratch_path("cut.so"), &offered, &taken, &error);
    ck_assert(status == STATUS_OK || status == STATUS_INPUT);
    text_free(&offered);
    text_free(&taken);
  }
  scratch_remove();
  text_free(&whole);
}
END_TEST

int main(void) {
  return suite_run("elf_symbols",
                   (SuiteTests){a_plugin_offers_its_entry_alone, what_is_called_elsewhere_is_listed_as_taken,
                                another_file_is_refused, a_file_cut_off_anywhere_is_survived, NULL});
}
