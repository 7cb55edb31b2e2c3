/* The files that a folder for a new law is made of, inside the program: those of core/sdk/mlaw and of
 * plugins/template, written by embed.cmake. */
#ifndef CAPSELLA_APP_SDK_FILES_H
#define CAPSELLA_APP_SDK_FILES_H

#include <stddef.h>

typedef struct {
  const char *path; /* "mlaw/mlaw.h", "template/energy_law.c" */
  const unsigned char *bytes;
  size_t length;
} SdkFile;

extern const SdkFile SDK_FILES[];
extern const size_t N_SDK_FILES;

#endif
