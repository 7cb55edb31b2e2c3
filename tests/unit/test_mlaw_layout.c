/* ABI 1 as it was published: where every field of mlaw.h lies, and the value of every constant.
 *
 * Reordering, removing or retyping a field breaks plugins in the field and fails here.  Appending one (a new
 * minor) asks for one new line and a new size.  Offsets are those of machines with 64-bit pointers. */
#include "suite.h"
#include <mlaw/mlaw.h>
#include <string.h>

typedef struct {
  const char *name;
  size_t found, expected;
} Entry;

#define FIELD(type, field) #type "." #field, offsetof(type, field)
#define SIZE(type)         "sizeof " #type, sizeof(type)
#define VALUE(constant)    #constant, (size_t)(constant)

/* clang-format off */
static const Entry layout[] = {
    {FIELD(mlaw_error, status), 0},
    {FIELD(mlaw_error, reserved), 4},
    {FIELD(mlaw_error, point), 8},
    {FIELD(mlaw_error, text), 16},
    {SIZE(mlaw_error), 256},
    {FIELD(mlaw_param, name), 0},
    {FIELD(mlaw_param, unit), 8},
    {FIELD(mlaw_param, about), 16},
    {FIELD(mlaw_param, dim), 24},
    {FIELD(mlaw_param, flags), 28},
    {FIELD(mlaw_param, value), 32},
    {FIELD(mlaw_param, lo), 40},
    {FIELD(mlaw_param, hi), 48},
    {FIELD(mlaw_param, ok_lo), 56},
    {FIELD(mlaw_param, ok_hi), 64},
    {SIZE(mlaw_param), 72},
    {FIELD(mlaw_var, name), 0},
    {FIELD(mlaw_var, unit), 8},
    {FIELD(mlaw_var, about), 16},
    {FIELD(mlaw_var, dim), 24},
    {FIELD(mlaw_var, flags), 28},
    {FIELD(mlaw_var, init), 32},
    {SIZE(mlaw_var), 40},
    {FIELD(mlaw_field, v), 0},
    {FIELD(mlaw_field, inc), 8},
    {SIZE(mlaw_field), 16},
    {FIELD(mlaw_energy_args, size), 0},
    {FIELD(mlaw_energy_args, reserved), 4},
    {FIELD(mlaw_energy_args, n), 8},
    {FIELD(mlaw_energy_args, ld), 16},
    {FIELD(mlaw_energy_args, t), 24},
    {FIELD(mlaw_energy_args, dt), 32},
    {FIELD(mlaw_energy_args, param), 40},
    {FIELD(mlaw_energy_args, I1), 48},
    {FIELD(mlaw_energy_args, I2), 56},
    {FIELD(mlaw_energy_args, state0), 64},
    {FIELD(mlaw_energy_args, state1), 72},
    {FIELD(mlaw_energy_args, phi), 80},
    {FIELD(mlaw_energy_args, dphi), 88},
    {FIELD(mlaw_energy_args, d2phi), 96},
    {FIELD(mlaw_energy_args, err), 104},
    {SIZE(mlaw_energy_args), 112},
    {FIELD(mlaw_energy, size), 0},
    {FIELD(mlaw_energy, flags), 4},
    {FIELD(mlaw_energy, id), 8},
    {FIELD(mlaw_energy, title), 16},
    {FIELD(mlaw_energy, source), 24},
    {FIELD(mlaw_energy, params), 32},
    {FIELD(mlaw_energy, n_params), 40},
    {FIELD(mlaw_energy, param_size), 44},
    {FIELD(mlaw_energy, vars), 48},
    {FIELD(mlaw_energy, n_vars), 56},
    {FIELD(mlaw_energy, var_size), 60},
    {FIELD(mlaw_energy, check), 64},
    {FIELD(mlaw_energy, eval), 72},
    {FIELD(mlaw_energy, about), 80},
    {SIZE(mlaw_energy), 88},
    {FIELD(mlaw_damage_args, size), 0},
    {FIELD(mlaw_damage_args, n_channels), 4},
    {FIELD(mlaw_damage_args, n), 8},
    {FIELD(mlaw_damage_args, ld), 16},
    {FIELD(mlaw_damage_args, t), 24},
    {FIELD(mlaw_damage_args, dt), 32},
    {FIELD(mlaw_damage_args, param), 40},
    {FIELD(mlaw_damage_args, chan0), 48},
    {FIELD(mlaw_damage_args, chan), 56},
    {FIELD(mlaw_damage_args, d0), 64},
    {FIELD(mlaw_damage_args, state0), 72},
    {FIELD(mlaw_damage_args, state1), 80},
    {FIELD(mlaw_damage_args, f), 88},
    {FIELD(mlaw_damage_args, zeta), 96},
    {FIELD(mlaw_damage_args, dzeta), 104},
    {FIELD(mlaw_damage_args, d1), 112},
    {FIELD(mlaw_damage_args, err), 120},
    {SIZE(mlaw_damage_args), 128},
    {FIELD(mlaw_damage, size), 0},
    {FIELD(mlaw_damage, flags), 4},
    {FIELD(mlaw_damage, id), 8},
    {FIELD(mlaw_damage, title), 16},
    {FIELD(mlaw_damage, source), 24},
    {FIELD(mlaw_damage, params), 32},
    {FIELD(mlaw_damage, n_params), 40},
    {FIELD(mlaw_damage, param_size), 44},
    {FIELD(mlaw_damage, vars), 48},
    {FIELD(mlaw_damage, n_vars), 56},
    {FIELD(mlaw_damage, var_size), 60},
    {FIELD(mlaw_damage, needs), 64},
    {FIELD(mlaw_damage, reserved), 68},
    {FIELD(mlaw_damage, check), 72},
    {FIELD(mlaw_damage, threshold), 80},
    {FIELD(mlaw_damage, evolution), 88},
    {FIELD(mlaw_damage, update), 96},
    {FIELD(mlaw_damage, about), 104},
    {SIZE(mlaw_damage), 112},
    {FIELD(mlaw_plugin, size), 0},
    {FIELD(mlaw_plugin, abi_minor), 4},
    {FIELD(mlaw_plugin, host_minor_min), 6},
    {FIELD(mlaw_plugin, id), 8},
    {FIELD(mlaw_plugin, version), 16},
    {FIELD(mlaw_plugin, license), 24},
    {FIELD(mlaw_plugin, author), 32},
    {FIELD(mlaw_plugin, n_energy), 40},
    {FIELD(mlaw_plugin, n_damage), 44},
    {FIELD(mlaw_plugin, energy), 48},
    {FIELD(mlaw_plugin, damage), 56},
    {SIZE(mlaw_plugin), 64},
};

static const Entry constants[] = {
    {VALUE(MLAW_ABI_MAJOR), 1},
    {VALUE(MLAW_ABI_MINOR), 1},
    {VALUE(MLAW_OK), 0},
    {VALUE(MLAW_DOMAIN), 1},
    {VALUE(MLAW_NOCONV), 2},
    {VALUE(MLAW_BADPARAM), (size_t)-1},
    {VALUE(MLAW_BADARG), (size_t)-2},
    {VALUE(MLAW_INTERNAL), (size_t)-3},
    {VALUE(MLAW_REQUIRED), 1},
    {VALUE(MLAW_OPEN_LO), 2},
    {VALUE(MLAW_OPEN_HI), 4},
    {VALUE(MLAW_HESSIAN), 1},
    {VALUE(MLAW_Y), 0},
    {VALUE(MLAW_I1), 1},
    {VALUE(MLAW_I2), 2},
    {VALUE(MLAW_L1), 3},
    {VALUE(MLAW_L2), 4},
    {VALUE(MLAW_T1), 5},
    {VALUE(MLAW_T2), 6},
    {VALUE(MLAW_N_CHANNELS), 7},
};
/* clang-format on */

static void compare(const Entry *entry, size_t n) {
  for (size_t i = 0; i < n; i++) {
    ck_assert_msg(entry[i].found == entry[i].expected, "%s: published %zu, found %zu", entry[i].name,
                  entry[i].expected, entry[i].found);
  }
}

START_TEST(every_field_lies_where_abi_1_put_it) {
  if (sizeof(void *) == 8) compare(layout, sizeof layout / sizeof *layout);
}
END_TEST

START_TEST(every_constant_has_the_value_of_abi_1) {
  compare(constants, sizeof constants / sizeof *constants);
}
END_TEST

START_TEST(the_symbol_carries_the_major) {
  ck_assert_str_eq(MLAW_ENTRY_NAME, "mlaw_plugin_v1");
}
END_TEST

typedef struct {
  uint32_t size, first;
  double last;
} Grown;

START_TEST(a_field_is_there_when_the_size_covers_all_of_it) {
  Grown whole = {.size = sizeof whole}, partial = {.size = sizeof partial - 1};
  ck_assert(MLAW_HAS(Grown, &whole, last));
  ck_assert(!MLAW_HAS(Grown, &partial, last));
  ck_assert(MLAW_HAS(Grown, &partial, first));
}
END_TEST

START_TEST(a_failure_is_stored_with_its_point_and_cut_to_fit) {
  char text[600];
  mlaw_error err;
  memset(text, 'x', sizeof text - 1);
  text[sizeof text - 1] = '\0';
  ck_assert_int_eq(mlaw_fail(&err, MLAW_DOMAIN, 12, "too far"), MLAW_DOMAIN);
  ck_assert_int_eq(err.status, MLAW_DOMAIN);
  ck_assert_int_eq(err.point, 12);
  ck_assert_str_eq(err.text, "too far");
  mlaw_fail(&err, MLAW_INTERNAL, -1, text);
  ck_assert_uint_eq(strlen(err.text), sizeof err.text - 1);
}
END_TEST

START_TEST(a_field_is_uniform_with_stride_0_and_per_point_with_stride_1) {
  const double values[] = {1.0, 2.0, 3.0};
  ck_assert_double_eq(mlaw_at((mlaw_field){values, 0}, 2), 1.0);
  ck_assert_double_eq(mlaw_at((mlaw_field){values, 1}, 2), 3.0);
}
END_TEST

int main(void) {
  return suite_run("mlaw_layout",
                   (SuiteTests){every_field_lies_where_abi_1_put_it, every_constant_has_the_value_of_abi_1,
                                the_symbol_carries_the_major, a_field_is_there_when_the_size_covers_all_of_it,
                                a_failure_is_stored_with_its_point_and_cut_to_fit,
                                a_field_is_uniform_with_stride_0_and_per_point_with_stride_1, NULL});
}
