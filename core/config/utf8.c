/* Decoding of UTF-8 for the only question asked of it: is this printable? */
#include "config/utf8.h"

#include <stdbool.h>
#include <stdint.h>

/* Bytes of the character at the start of `bytes`, 0 when it is broken; its code point in *code. */
static size_t decode(const unsigned char *bytes, size_t length, uint32_t *code) {
  static const uint32_t SMALLEST[] = {0, 0, 0x80, 0x800, 0x10000}; /* a longer form than needed is broken */
  unsigned char lead = bytes[0];
  size_t size = lead < 0x80 ? 1 : lead >> 5 == 0x6 ? 2 : lead >> 4 == 0xE ? 3 : lead >> 3 == 0x1E ? 4 : 0;
  if (size == 0 || size > length) return 0;
  *code = size == 1 ? lead : lead & (0x7FU >> size);
  for (size_t i = 1; i < size; i++) {
    if (bytes[i] >> 6 != 0x2) return 0;
    *code = *code << 6 | (bytes[i] & 0x3F);
  }
  return *code < SMALLEST[size] ? 0 : size;
}

static bool is_printable(uint32_t code) {
  if (code == '\t' || code == '\n' || code == '\r') return true;
  if (code < 0x20 || (code >= 0x7F && code < 0xA0)) return false;       /* controls */
  if (code == 0x2028 || code == 0x2029 || code == 0xFEFF) return false; /* line ends, byte order mark */
  if (code >= 0xD800 && code < 0xE000) return false;                    /* halves of UTF-16 pairs */
  return code <= 0x10FFFF && code != 0xFFFE && code != 0xFFFF;
}

size_t utf8_printable(const char *bytes, size_t length) {
  size_t at = 0;
  while (at < length) {
    uint32_t code;
    size_t size = decode((const unsigned char *)bytes + at, length - at, &code);
    if (size == 0 || !is_printable(code)) break;
    at += size;
  }
  return at;
}

size_t utf8_cut(const char *text, size_t limit) {
  size_t whole = 0;
  for (size_t i = 0; i <= limit; i++) {
    bool continues = ((unsigned char)text[i] & 0xC0) == 0x80;
    if (!continues) whole = i;
    if (text[i] == '\0' || text[i] == '\n' || text[i] == '\r') break;
  }
  return whole;
}
