/* Writes JSON as it is told; the caller keeps objects and arrays in step. */
#include "observe/json.h"

#include "observe/number.h"
#include <math.h>
#include <string.h>

static void put(Json *json, const char *string) {
  if (json->status == STATUS_OK) json->status = text_append(json->text, json->error, "%s", string);
}

static void put_bytes(Json *json, const char *bytes, size_t count) {
  if (json->status == STATUS_OK) json->status = text_append_bytes(json->text, json->error, bytes, count);
}

static void indent(Json *json) {
  put(json, "\n");
  for (int level = 0; level < json->depth; level++) put(json, "  ");
}

/* Length of the UTF-8 character at `s` (1 to 4), or 0 when the bytes are none: a stray or missing
 * continuation, an overlong form, a surrogate, a number beyond U+10FFFF. */
static int utf8_length(const unsigned char *s) {
  static const unsigned smallest[5] = {0, 0, 0x80, 0x800, 0x10000};
  int length = s[0] < 0x80 ? 1 : s[0] >> 5 == 6 ? 2 : s[0] >> 4 == 14 ? 3 : s[0] >> 3 == 30 ? 4 : 0;
  if (length < 2) return length;
  unsigned point = s[0] & (0xffU >> (length + 1));
  for (int i = 1; i < length; i++) {
    if (s[i] >> 6 != 2) return 0;
    point = point << 6 | (s[i] & 0x3fU);
  }
  bool is_surrogate = point >= 0xd800 && point < 0xe000;
  return point < smallest[length] || point > 0x10ffff || is_surrogate ? 0 : length;
}

static void put_quoted(Json *json, const char *string) {
  put(json, "\"");
  for (const unsigned char *s = (const unsigned char *)string; *s && json->status == STATUS_OK;) {
    int length = utf8_length(s);
    if (length == 0)
      put(json, "\xef\xbf\xbd");
    else if (*s == '"' || *s == '\\')
      json->status = text_append(json->text, json->error, "\\%c", *s);
    else if (*s < 0x20)
      json->status = text_append(json->text, json->error, "\\u%04x", *s);
    else
      put_bytes(json, (const char *)s, (size_t)length);
    s += length ? length : 1;
  }
  put(json, "\"");
}

/* What stands in front of a value: comma, new line and key. */
static void begin_value(Json *json, const char *key) {
  if (json->depth > 0) {
    bool *has_entry = &json->has_entry[json->depth - 1];
    if (*has_entry) put(json, ",");
    *has_entry = true;
    indent(json);
  }
  if (!key) return;
  put_quoted(json, key);
  put(json, ": ");
}

static void open_level(Json *json, const char *key, const char *opening, char closing) {
  begin_value(json, key);
  put(json, opening);
  if (json->status != STATUS_OK) return;
  if (json->depth == JSON_MAX_DEPTH) {
    json->status = error_set(json->error, STATUS_FAILED, "JSON: more than %d levels", JSON_MAX_DEPTH);
    return;
  }
  json->closing[json->depth] = closing;
  json->has_entry[json->depth++] = false;
}

void json_begin(Json *json, Text *text, Error *error) {
  *json = (Json){.text = text, .error = error};
}
void json_open_object(Json *json, const char *key) {
  open_level(json, key, "{", '}');
}
void json_open_array(Json *json, const char *key) {
  open_level(json, key, "[", ']');
}

void json_close(Json *json) {
  if (json->status != STATUS_OK) return;
  if (json->depth == 0) {
    json->status = error_set(json->error, STATUS_FAILED, "JSON: closed more often than opened");
    return;
  }
  json->depth--;
  if (json->has_entry[json->depth]) indent(json);
  put(json, (char[]){json->closing[json->depth], '\0'});
}

static void put_number(Json *json, double value) {
  char digits[NUMBER_SIZE] = "null";
  if (isfinite(value)) number_print(value, digits);
  put(json, digits);
}

void json_number(Json *json, const char *key, double value) {
  begin_value(json, key);
  put_number(json, value);
}

void json_numbers(Json *json, const char *key, const double *values, int count) {
  begin_value(json, key);
  put(json, "[");
  for (int k = 0; k < count; k++) {
    if (k > 0) put(json, ", ");
    put_number(json, values[k]);
  }
  put(json, "]");
}

void json_integer(Json *json, const char *key, long long value) {
  begin_value(json, key);
  if (json->status == STATUS_OK) json->status = text_append(json->text, json->error, "%lld", value);
}

void json_string(Json *json, const char *key, const char *value) {
  begin_value(json, key);
  if (value)
    put_quoted(json, value);
  else
    put(json, "null");
}

void json_boolean(Json *json, const char *key, bool value) {
  begin_value(json, key);
  put(json, value ? "true" : "false");
}

void json_null(Json *json, const char *key) {
  begin_value(json, key);
  put(json, "null");
}

void json_raw(Json *json, const char *key, const char *value) {
  begin_value(json, key);
  put(json, value);
}

/* RFC 4648, in pieces that fit a buffer. */
void json_bytes(Json *json, const char *key, const unsigned char *bytes, size_t count) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  char buffer[4096];
  size_t filled = 0;
  begin_value(json, key);
  put(json, "\"");
  for (size_t k = 0; k < count; k += 3) {
    const size_t left = count - k;
    const unsigned group = (unsigned)bytes[k] << 16 | (left > 1 ? (unsigned)bytes[k + 1] << 8 : 0) |
                           (left > 2 ? bytes[k + 2] : 0);
    for (size_t c = 0; c < 4; c++) buffer[filled++] = c <= left ? digits[group >> (18 - 6 * c) & 0x3f] : '=';
    if (filled == sizeof buffer || left <= 3) {
      put_bytes(json, buffer, filled);
      filled = 0;
    }
  }
  put(json, "\"");
}

Status json_end(Json *json) {
  if (json->status == STATUS_OK && json->depth != 0)
    json->status = error_set(json->error, STATUS_FAILED, "JSON: %d levels were left open", json->depth);
  put(json, "\n");
  return json->status;
}
