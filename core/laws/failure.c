#include "laws/failure.h"

#include "base/array.h"
#include "config/yaml_print.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

void law_failure_free(LawFailure *failure) {
  array_free(failure->param);
  array_free(failure->in);
  *failure = (LawFailure){0};
}

void law_failure_keep(LawFailure *failure, const LoadedLaw *law, const LawCall *call, const char *message) {
  const ptrdiff_t n = call->n;
  const uint32_t n_params = law_describe(law).n_params;
  Error ignored;
  law_failure_free(failure);
  if (call->n_rows > FAILURE_ROWS || ARRAY_NEW(&failure->param, n_params * n, &ignored) != STATUS_OK ||
      ARRAY_NEW(&failure->in, call->n_rows * n, &ignored) != STATUS_OK) {
    law_failure_free(failure);
    return;
  }
  for (uint32_t k = 0; k < n_params; k++)
    for (ptrdiff_t i = 0; i < n; i++) failure->param[k * n + i] = mlaw_at(call->param[k], i);
  for (int row = 0; row < call->n_rows; row++)
    memcpy(failure->in + row * n, call->row[row], (size_t)n * sizeof *failure->in);
  failure->law = law;
  failure->n = n;
  failure->t = call->t;
  failure->dt = call->dt;
  failure->n_rows = call->n_rows;
  snprintf(failure->message, sizeof failure->message, "%s", message);
}

/* Not units_print_number: what made a law fail need not be finite. */
static Status print_row(const double *values, ptrdiff_t n, Text *yaml, Error *error) {
  Status status = STATUS_OK;
  for (ptrdiff_t i = 0; i < n; i++) TRY(text_append(yaml, error, "%s%.17g", i ? ", " : "[", values[i]));
  TRY(text_append(yaml, error, "]\n"));
cleanup:
  return status;
}

Status law_failure_print(const LawFailure *failure, Text *yaml, Error *error) {
  Status status;
  const LawDescription table = law_describe(failure->law);
  const ptrdiff_t n = failure->n;
  TRY(text_append(yaml, error,
                  "# The points on which a law failed, to be evaluated again: capsella laws check --replay "
                  "FILE\nlaw_failure: 1\nlaw: \"%s\"\nfile: ",
                  table.id));
  TRY(yaml_print_text(failure->law->file, yaml, error));
  TRY(text_append(yaml, error, "\nhash: \"%016" PRIx64 "\"\nmessage: ", failure->law->hash));
  TRY(yaml_print_text(failure->message, yaml, error));
  TRY(text_append(yaml, error, "\ntime: [%.17g, %.17g] # t, dt\nparameters:\n", failure->t, failure->dt));
  for (uint32_t k = 0; k < table.n_params; k++) {
    TRY(text_append(yaml, error, "  - "));
    TRY(print_row(failure->param + k * n, n, yaml, error));
  }
  TRY(text_append(yaml, error, "inputs:\n"));
  for (int row = 0; row < failure->n_rows; row++) {
    TRY(text_append(yaml, error, "  - "));
    TRY(print_row(failure->in + row * n, n, yaml, error));
  }
cleanup:
  return status;
}
