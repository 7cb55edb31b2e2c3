/* One face for the kernels of all laws, so that a rule is tested once: a table of input rows, a table of
 * output rows, and one call.  A damage law of the explicit kind is called for threshold and then for
 * evolution.
 *
 *   energy    in: I1, I2, state0...             out: phi, phi_1, phi_2, (phi_11, phi_12, phi_22,) state1...
 *   explicit  in: Y, d0                         out: f, zeta, dzeta
 *   general   in: channels at t, at t + dt,     out: d1, state1...
 *                 d0, state0...                 (channels: those of `needs`, in the order of the enum) */
#ifndef CAPSELLA_LAWS_CONFORMANCE_KERNEL_H
#define CAPSELLA_LAWS_CONFORMANCE_KERNEL_H

#include "laws/conformance_test.h"

enum { MAX_ROWS = 32, MAX_LD = 64, MAX_PARAMS = 64, TABLE = MAX_ROWS * MAX_LD };

int kernel_inputs(const Subject *subject); /* number of rows; at most MAX_ROWS when `sizes-sane` holds */
int kernel_outputs(const Subject *subject);
const char *kernel_output_name(const Subject *subject, int row);

typedef struct {
  ptrdiff_t n, ld;
  const mlaw_field *param;
  const double *in; /* [kernel_inputs][ld] */
  double *out;      /* [kernel_outputs][ld]; rows not asked for are left alone */
  int without;      /* output row whose pointer is NULL, with those that share it; -1: all are asked for */
  double t, dt;
  mlaw_error err;
} KernelCall;

/* The law's status (MLAW_OK, ...); `call->err` is cleared before. */
int kernel_call(const Subject *subject, KernelCall *call);

/* May this output row be asked not to be written? */
bool kernel_optional(const Subject *subject, int row);
/* The rows that share one pointer with `row`: first and number. */
int kernel_group(const Subject *subject, int row, int *count);

/* Uniform fields of parameter values. */
void kernel_fields(const Subject *subject, const double *value, mlaw_field *field);

#endif
