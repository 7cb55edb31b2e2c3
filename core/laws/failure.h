/* The batch on which a law failed, in a file, so that it can be evaluated again (laws/replay.h).
 *
 * The rows of a batch are those of a KernelCall (conformance_kernel.h): all that the law was handed. */
#ifndef CAPSELLA_LAWS_FAILURE_H
#define CAPSELLA_LAWS_FAILURE_H

#include "base/status.h"
#include "base/text.h"
#include "laws/loader.h"
#include <stddef.h>

enum { FAILURE_ROWS = 32 };

/* Starts from `LawFailure failure = {0}`; n == 0: there is none. */
typedef struct {
  const LoadedLaw *law; /* of the material, which must outlive this */
  ptrdiff_t n;
  double t, dt;
  double *param; /* [n_params][n] */
  double *in;    /* [n_rows][n] */
  int n_rows;
  char message[512];
} LawFailure;

/* What a law was handed: n_rows pointers to [n] values each. */
typedef struct {
  ptrdiff_t n;
  double t, dt;
  const mlaw_field *param;
  int n_rows;
  const double *row[FAILURE_ROWS];
} LawCall;

/* Copies a call.  Without memory, or with more rows than there is room for, nothing is kept. */
void law_failure_keep(LawFailure *failure, const LoadedLaw *law, const LawCall *call, const char *message);
void law_failure_free(LawFailure *failure);

/* As YAML. */
Status law_failure_print(const LawFailure *failure, Text *yaml, Error *error);

#endif
