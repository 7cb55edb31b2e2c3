/* Rows to pointers and back. */
#include "laws/conformance_kernel.h"

static int n_vars(const Subject *subject) {
  return (int)subject->table.n_vars;
}

static int n_needs(const mlaw_damage *law) {
  int count = 0;
  for (int c = 0; c < MLAW_N_CHANNELS; c++) count += (law->needs >> c) & 1u;
  return count;
}

static bool has_hessian(const Subject *subject) {
  return subject->energy && subject->energy->flags & MLAW_HESSIAN;
}

int kernel_inputs(const Subject *subject) {
  if (subject->energy) return 2 + n_vars(subject);
  return subject->damage->update ? 2 * n_needs(subject->damage) + 1 + n_vars(subject) : 2;
}

int kernel_outputs(const Subject *subject) {
  if (subject->energy) return (has_hessian(subject) ? 6 : 3) + n_vars(subject);
  return subject->damage->update ? 1 + n_vars(subject) : 3;
}

const char *kernel_output_name(const Subject *subject, int row) {
  static const char *const energy[] = {"phi", "phi_1", "phi_2", "phi_11", "phi_12", "phi_22"};
  static const char *const explicit_kind[] = {"f", "zeta", "dzeta"};
  const int own =
      kernel_outputs(subject) - (subject->damage && !subject->damage->update ? 0 : n_vars(subject));
  if (row >= own) return law_var(&subject->table, (uint32_t)(row - own))->name;
  if (subject->energy) return energy[row];
  return subject->damage->update ? "d1" : explicit_kind[row];
}

int kernel_group(const Subject *subject, int row, int *count) {
  static const int first[] = {0, 1, 1, 3, 3, 3}, size[] = {1, 2, 2, 3, 3, 3};
  *count = 1;
  if (!subject->energy || row >= (has_hessian(subject) ? 6 : 3)) return row;
  *count = size[row];
  return first[row];
}

bool kernel_optional(const Subject *subject, int row) {
  if (subject->energy) return row < (has_hessian(subject) ? 6 : 3);
  return !subject->damage->update && row == 2;
}

/* The pointer to output row `row`, or NULL when it is not asked for. */
static double *output(const Subject *subject, const KernelCall *call, int row) {
  int count;
  if (call->without >= 0 &&
      kernel_group(subject, call->without, &count) == kernel_group(subject, row, &count)) {
    return NULL;
  }
  return call->out + row * call->ld;
}

static int call_energy(const Subject *subject, KernelCall *call) {
  const int own = has_hessian(subject) ? 6 : 3;
  const mlaw_energy_args args = {.size = sizeof args,
                                 .n = call->n,
                                 .ld = call->ld,
                                 .t = call->t,
                                 .dt = call->dt,
                                 .param = call->param,
                                 .I1 = call->in,
                                 .I2 = call->in + call->ld,
                                 .state0 = n_vars(subject) ? call->in + 2 * call->ld : NULL,
                                 .state1 = n_vars(subject) ? call->out + own * call->ld : NULL,
                                 .phi = output(subject, call, 0),
                                 .dphi = output(subject, call, 1),
                                 .d2phi = has_hessian(subject) ? output(subject, call, 3) : NULL,
                                 .err = &call->err};
  return subject->energy->eval(&args);
}

static int call_explicit(const Subject *subject, KernelCall *call) {
  const double *chan[MLAW_N_CHANNELS] = {[MLAW_Y] = call->in};
  mlaw_damage_args args = {.size = sizeof args,
                           .n_channels = MLAW_N_CHANNELS,
                           .n = call->n,
                           .ld = call->ld,
                           .t = call->t,
                           .dt = call->dt,
                           .param = call->param,
                           .chan = chan,
                           .d0 = call->in + call->ld,
                           .f = call->out,
                           .err = &call->err};
  const int status = subject->damage->threshold(&args);
  if (status != MLAW_OK) return status;
  args.f = NULL;
  args.zeta = call->out + call->ld;
  args.dzeta = output(subject, call, 2);
  return subject->damage->evolution(&args);
}

static int call_general(const Subject *subject, KernelCall *call) {
  const double *chan0[MLAW_N_CHANNELS] = {0}, *chan[MLAW_N_CHANNELS] = {0};
  const int needs = n_needs(subject->damage);
  for (int c = 0, row = 0; c < MLAW_N_CHANNELS; c++) {
    if (!(subject->damage->needs >> c & 1u)) continue;
    chan0[c] = call->in + row * call->ld;
    chan[c] = call->in + (needs + row) * call->ld;
    row++;
  }
  const mlaw_damage_args args = {.size = sizeof args,
                                 .n_channels = MLAW_N_CHANNELS,
                                 .n = call->n,
                                 .ld = call->ld,
                                 .t = call->t,
                                 .dt = call->dt,
                                 .param = call->param,
                                 .chan0 = chan0,
                                 .chan = chan,
                                 .d0 = call->in + 2 * needs * call->ld,
                                 .state0 = n_vars(subject) ? call->in + (2 * needs + 1) * call->ld : NULL,
                                 .state1 = n_vars(subject) ? call->out + call->ld : NULL,
                                 .d1 = call->out,
                                 .err = &call->err};
  return subject->damage->update(&args);
}

int kernel_call(const Subject *subject, KernelCall *call) {
  call->err = (mlaw_error){.point = -1};
  if (subject->energy) return call_energy(subject, call);
  return subject->damage->update ? call_general(subject, call) : call_explicit(subject, call);
}

void kernel_fields(const Subject *subject, const double *value, mlaw_field *field) {
  for (uint32_t k = 0; k < subject->table.n_params; k++) field[k] = (mlaw_field){&value[k], 0};
}
