// A law in C++17: mlaw.h is all it needs, and no C++ type crosses the boundary.
#include <cmath>
#include <mlaw/mlaw.h>

namespace {

constexpr double infinity = HUGE_VAL;

const mlaw_param params[] = {
    {"G_s", "N/m", "surface shear modulus", {1, 0, -2, 0}, MLAW_OPEN_LO, 1.0, 0.0, infinity, 0.0, infinity}};

int eval(const mlaw_energy_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->I2[i] > 1e6) return mlaw_fail(a->err, MLAW_DOMAIN, i, "area stretch beyond a thousand");
    const double G = mlaw_at(a->param[0], i), u = 1.0 / (1.0 + a->I2[i]);
    if (a->phi) a->phi[i] = 0.5 * G * (a->I1[i] - a->I2[i] * u);
    if (a->dphi) {
      a->dphi[i] = 0.5 * G;
      a->dphi[a->ld + i] = -0.5 * G * u * u;
    }
  }
  return MLAW_OK;
}

const mlaw_energy law = {sizeof(mlaw_energy),
                         0,
                         "cxx.sheet",
                         "A law in C++",
                         "none",
                         params,
                         1,
                         sizeof(mlaw_param),
                         nullptr,
                         0,
                         0,
                         nullptr,
                         eval,
                         nullptr};
const mlaw_energy *const laws[] = {&law};
const mlaw_plugin plugin = {
    sizeof(mlaw_plugin), MLAW_ABI_MINOR, 0, "cxx.sheet", "1.0", "MIT", "nobody", 1, 0, laws, nullptr};

} // namespace

const mlaw_plugin *mlaw_plugin_v1(uint32_t) {
  return &plugin;
}
