/* Printable UTF-8: what may stand in a scene. */
#ifndef CAPSELLA_CONFIG_UTF8_H
#define CAPSELLA_CONFIG_UTF8_H

#include <stddef.h>

/* How many bytes from the start are whole printable characters; `length` when all are.  Tab, line feed and
 * carriage return count as printable; other controls, the byte order mark, and the line ends of Unicode
 * (U+0085, U+2028, U+2029) do not. */
size_t utf8_printable(const char *bytes, size_t length);

/* The largest length of at most `limit` bytes that does not cut a character of `text` or pass a line end. */
size_t utf8_cut(const char *text, size_t limit);

#endif
