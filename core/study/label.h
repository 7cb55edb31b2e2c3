/* Names of cases, from what distinguishes them; they become names of folders. */
#ifndef CAPSELLA_STUDY_LABEL_H
#define CAPSELLA_STUDY_LABEL_H

#include "base/text.h"
#include "study/study.h"

/* "Y_D=0.2,capillary_number=0.7": for each setting the last name of its key and its value; "base" for none.
 * Settings that differ get labels that differ. */
Status label_append(Text *label, const Override *settings, size_t n, Error *error);

/* 64-bit FNV-1a of a text, going on from `hash` (LABEL_HASH_START at first). */
#define LABEL_HASH_START UINT64_C(0xcbf29ce484222325)
uint64_t label_hash(uint64_t hash, const char *text);

#endif
