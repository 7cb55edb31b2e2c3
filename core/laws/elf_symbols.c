/* Walks the section .dynsym of a native ELF file with every offset checked against the size of the file. */
#include "laws/elf_symbols.h"

#include "base/file.h"
#include <elf.h>
#include <link.h>
#include <stdbool.h>
#include <string.h>

enum { MAX_FILE = 64 << 20 };

typedef struct {
  const char *data;
  size_t size;
} Bytes;

/* A copy of `size` bytes at `offset`; false beyond the end of the file. */
static bool copy_out(Bytes file, size_t offset, void *object, size_t size) {
  if (offset > file.size || size > file.size - offset) return false;
  memcpy(object, file.data + offset, size);
  return true;
}

/* The string at `offset` of a string table, or NULL when it does not end within the file. */
static const char *string_at(Bytes file, const ElfW(Shdr) * table, size_t offset) {
  if (offset >= table->sh_size || table->sh_offset > file.size ||
      table->sh_size > file.size - table->sh_offset) {
    return NULL;
  }
  const char *string = file.data + table->sh_offset + offset;
  return memchr(string, '\0', table->sh_size - offset) ? string : NULL;
}

static bool section(Bytes file, const ElfW(Ehdr) * header, size_t k, ElfW(Shdr) * result) {
  return k < header->e_shnum && copy_out(file, header->e_shoff + k * sizeof *result, result, sizeof *result);
}

static Status list_symbols(Bytes file, const ElfW(Shdr) * symbols, const ElfW(Shdr) * names, Text *offered,
                           Text *taken, Error *error) {
  Status status = STATUS_OK;
  for (size_t at = 0; at + sizeof(ElfW(Sym)) <= symbols->sh_size; at += sizeof(ElfW(Sym))) {
    ElfW(Sym) symbol;
    if (!copy_out(file, symbols->sh_offset + at, &symbol, sizeof symbol)) break;
    const char *name = string_at(file, names, symbol.st_name);
    const int binding = symbol.st_info >> 4;
    if (!name || !*name || binding == STB_LOCAL) continue;
    TRY(text_append(symbol.st_shndx == SHN_UNDEF ? taken : offered, error, "%s ", name));
  }
cleanup:
  return status;
}

Status elf_symbols(const char *path, Text *offered, Text *taken, Error *error) {
  Status status;
  Text content = {0};
  ElfW(Ehdr) header;
  ElfW(Shdr) symbols, names;
  TRY(text_append(offered, error, "%s", ""));
  TRY(text_append(taken, error, "%s", ""));
  TRY(file_read(path, MAX_FILE, &content, error));
  const Bytes file = {content.data, content.length};
  const unsigned char class = sizeof(void *) == 8 ? ELFCLASS64 : ELFCLASS32;
  if (!copy_out(file, 0, &header, sizeof header) || memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != class) {
    TRY(error_set(error, STATUS_INPUT, "%s: expected an ELF object of this machine, found another file",
                  path));
  }
  for (size_t k = 0; section(file, &header, k, &symbols); k++) {
    if (symbols.sh_type != SHT_DYNSYM || !section(file, &header, symbols.sh_link, &names)) continue;
    TRY(list_symbols(file, &symbols, &names, offered, taken, error));
  }
cleanup:
  text_free(&content);
  return status;
}
