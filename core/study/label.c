#include "study/label.h"

#include <inttypes.h>
#include <string.h>

enum { LONGEST = 120 };
static const char SAFE[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.+-";

uint64_t label_hash(uint64_t hash, const char *text) {
  for (const unsigned char *c = (const unsigned char *)text; *c; c++)
    hash = (hash ^ *c) * UINT64_C(0x100000001b3);
  return hash;
}

static const char *last_name(const char *key) {
  const char *dot = strrchr(key, '.');
  return dot ? dot + 1 : key;
}

/* Whether the readable label says all: no other settings of the same study have the same one. */
static bool is_faithful(const Override *settings, size_t n) {
  for (size_t i = 0; i < n; i++) {
    if (settings[i].value[strspn(settings[i].value, SAFE)]) return false;
    for (size_t j = 0; j < i; j++)
      if (strcmp(last_name(settings[i].key), last_name(settings[j].key)) == 0) return false;
  }
  return true;
}

static Status append_safely(Text *label, const char *text, Error *error) {
  Status status = text_append(label, error, "%s", text);
  if (status != STATUS_OK) return status;
  for (char *c = label->data + label->length - strlen(text); *c; c++)
    if (!strchr(SAFE, *c)) *c = '_';
  return STATUS_OK;
}

Status label_append(Text *label, const Override *settings, size_t n, Error *error) {
  Status status = STATUS_OK;
  const size_t start = label->length;
  uint64_t hash = LABEL_HASH_START;
  if (n == 0) return text_append(label, error, "base");
  for (size_t i = 0; i < n; i++) {
    if (i > 0) TRY(text_append(label, error, ","));
    TRY(append_safely(label, last_name(settings[i].key), error));
    TRY(text_append(label, error, "="));
    TRY(append_safely(label, settings[i].value, error));
    hash = label_hash(label_hash(label_hash(hash, settings[i].key), "="), settings[i].value);
  }
  const bool is_long = label->length - start > LONGEST;
  if (is_long) {
    label->length = start + LONGEST;
    label->data[label->length] = '\0';
  }
  if (is_long || !is_faithful(settings, n)) TRY(text_append(label, error, "-%016" PRIx64, hash));
cleanup:
  return status;
}
