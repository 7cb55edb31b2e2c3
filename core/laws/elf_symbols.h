/* Dynamic symbols of an ELF shared object, read from its bytes: nothing is loaded or run. */
#ifndef CAPSELLA_LAWS_ELF_SYMBOLS_H
#define CAPSELLA_LAWS_ELF_SYMBOLS_H

#include "base/status.h"
#include "base/text.h"

/* Appends the names to two lists, each name followed by one blank: what the object offers to others, and what
 * it takes from others.  STATUS_INPUT when the file is not an ELF object of this machine's word size. */
Status elf_symbols(const char *file, Text *offered, Text *taken, Error *error);

#endif
