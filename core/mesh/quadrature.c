/* Triangle rules as tables of orbits, Gauss-Legendre by Newton's iteration.
 *
 * The triangle rules are those of Dunavant, Int. J. Numer. Meth. Engng 21 (1985) 1129; the published
 * constants were refined on the moment equations of the symmetric polynomials and hold to 20 digits. */
#include "mesh/quadrature.h"

#include <math.h>
#include <stddef.h>

/* The points whose barycentric coordinates are the permutations of (a, a, 1 - 2 a), of (a, b, 1 - a - b). */
/* clang-format off */
#define ORBIT_3(a) {a, a}, {1.0 - 2.0 * (a), a}, {a, 1.0 - 2.0 * (a)}
#define ORBIT_6(a, b) {a, b}, {b, a}, {a, 1.0 - (a) - (b)}, {1.0 - (a) - (b), a}, \
                      {b, 1.0 - (a) - (b)}, {1.0 - (a) - (b), b}
/* clang-format on */
#define TIMES_3(w) w, w, w
#define TIMES_6(w) w, w, w, w, w, w

static const double point_1[][2] = {{1.0 / 3.0, 1.0 / 3.0}};
static const double weight_1[] = {0.5};

static const double point_3[][2] = {ORBIT_3(1.0 / 6.0)};
static const double weight_3[] = {TIMES_3(1.0 / 6.0)};

static const double point_6[][2] = {ORBIT_3(0.44594849091596488632), ORBIT_3(0.09157621350977074346)};
static const double weight_6[] = {TIMES_3(0.11169079483900573285), TIMES_3(0.05497587182766093382)};

static const double point_7[][2] = {
    {1.0 / 3.0, 1.0 / 3.0}, ORBIT_3(0.47014206410511508977), ORBIT_3(0.10128650732345633880)};
static const double weight_7[] = {0.1125, TIMES_3(0.06619707639425309037), TIMES_3(0.06296959027241357630)};

static const double point_12[][2] = {ORBIT_3(0.24928674517091042129), ORBIT_3(0.06308901449150222834),
                                     ORBIT_6(0.31035245103378440542, 0.63650249912139864723)};
static const double weight_12[] = {TIMES_3(0.05839313786318968301), TIMES_3(0.02542245318510340846),
                                   TIMES_6(0.04142553780918678760)};

static const double point_16[][2] = {{1.0 / 3.0, 1.0 / 3.0},
                                     ORBIT_3(0.45929258829272315603),
                                     ORBIT_3(0.17056930775176020662),
                                     ORBIT_3(0.05054722831703097546),
                                     ORBIT_6(0.26311282963463811342, 0.72849239295540428124)};
static const double weight_16[] = {0.07215780383889358413, TIMES_3(0.04754581713364231240),
                                   TIMES_3(0.05160868526735912514), TIMES_3(0.01622924881159904016),
                                   TIMES_6(0.01361515708721749713)};

static const TriangleRule rules[] = {
    {1, 1, point_1, weight_1}, {3, 2, point_3, weight_3},    {6, 4, point_6, weight_6},
    {7, 5, point_7, weight_7}, {12, 6, point_12, weight_12}, {16, 8, point_16, weight_16},
};

const TriangleRule *triangle_rule(int n) {
  for (size_t k = 0; k < sizeof rules / sizeof *rules; k++)
    if (rules[k].n == n) return &rules[k];
  return NULL;
}

/* Legendre polynomial P_n at z, and its derivative. */
static double legendre(int n, double z, double *derivative) {
  double previous = 1.0, value = z;
  for (int k = 2; k <= n; k++) {
    double next = ((2 * k - 1) * z * value - (k - 1) * previous) / k;
    previous = value;
    value = next;
  }
  *derivative = n * (previous - z * value) / (1.0 - z * z);
  return value;
}

void gauss_rule(int n, double *x, double *w) {
  static const double pi = 3.14159265358979323846;
  for (int k = 0; k < (n + 1) / 2; k++) {
    double z = 2 * k + 1 == n ? 0.0 : cos(pi * (k + 0.75) / (n + 0.5)); /* root k, from z = 1 downward */
    double derivative = 0.0;
    enum { NEWTON_STEPS = 4 }; /* the start is good to 3 digits: the fourth step only cleans the last bit */
    for (int step = 0; step < NEWTON_STEPS; step++) z -= legendre(n, z, &derivative) / derivative;
    legendre(n, z, &derivative);
    x[k] = 0.5 * (1.0 - z);
    x[n - 1 - k] = 0.5 * (1.0 + z);
    w[k] = w[n - 1 - k] = 1.0 / ((1.0 - z * z) * derivative * derivative);
  }
}
