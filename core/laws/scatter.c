#include "laws/scatter.h"

#include "base/array.h"
#include "base/vec3.h"
#include <math.h>
#include <stdint.h>

static const double PI = 3.14159265358979323846;

/* ---- Random numbers ---- */

/* Uniform in (0, 1), both ends excluded (Steele, Lea & Flood 2014, "SplitMix64"). */
static double draw_uniform(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  z ^= z >> 31;
  return ((double)(z >> 11) + 0.5) * 0x1p-53;
}

/* Box & Muller 1958; the second number of the pair is not used. */
static double draw_normal(uint64_t *state) {
  const double radius = sqrt(-2 * log(draw_uniform(state)));
  return radius * cos(2 * PI * draw_uniform(state));
}

/* ---- Scores ---- */

/* With so many waves the correlation within one field is that over all seeds to about 3 %. */
enum { WAVES = 512 };

typedef struct {
  double vector[3], cosine, sine; /* amplitudes */
} Wave;

static double field_at(const Wave *wave, const double point[3]) {
  double sum = 0;
  for (int k = 0; k < WAVES; k++) {
    const double phase = vec3_dot(wave[k].vector, point);
    sum += wave[k].cosine * cos(phase) + wave[k].sine * sin(phase);
  }
  return sum / sqrt(WAVES);
}

Status scatter_scores(long long seed, double correlation, int n, const double (*point)[3], double *score,
                      Error *error) {
  uint64_t state = (uint64_t)seed;
  if (!(correlation > 0)) {
    for (int i = 0; i < n; i++) score[i] = draw_normal(&state);
    return STATUS_OK;
  }
  Wave *wave;
  Status status = ARRAY_NEW(&wave, WAVES, error);
  if (status != STATUS_OK) return status;
  for (int k = 0; k < WAVES; k++) {
    for (int c = 0; c < 3; c++) wave[k].vector[c] = draw_normal(&state) / correlation;
    wave[k].cosine = draw_normal(&state);
    wave[k].sine = draw_normal(&state);
  }
  for (int i = 0; i < n; i++) score[i] = field_at(wave, point[i]);
  array_free(wave);
  return STATUS_OK;
}

/* ---- Distributions ---- */

/* P(score <= z) for a normal score; small ones are exact too. */
static double probability(double z) {
  return 0.5 * erfc(-z / sqrt(2));
}

double scatter_weibull(double score, double scale, double modulus) {
  const double hazard = score < 0 ? -log1p(-probability(score)) : -log(probability(-score));
  return scale * pow(hazard, 1 / modulus);
}

double scatter_normal(double score, double mean, double deviation) {
  return mean + deviation * score;
}

double scatter_log_normal(double score, double mean, double deviation) {
  const double variance = log1p(deviation * deviation / (mean * mean)); /* of the logarithm */
  return mean * exp(sqrt(variance) * score - 0.5 * variance);
}

double scatter_uniform(double score, double from, double to) {
  return from + (to - from) * probability(score);
}

double scatter_weibull_scale(double mean, double modulus) {
  return mean / tgamma(1 + 1 / modulus);
}
