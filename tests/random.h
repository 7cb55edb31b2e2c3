/* Reproducible random numbers for tests; print the seed in the message of a failing test. */
#ifndef CAPSELLA_TESTS_RANDOM_H
#define CAPSELLA_TESTS_RANDOM_H

#include <stdint.h>

/* Uniform in (-1, 1); splitmix64. */
static inline double random_uniform(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  z ^= z >> 31;
  return (double)(z >> 11) * 0x1p-52 - 1.0;
}

static inline void random_fill(uint64_t *state, int n, double *values) {
  for (int i = 0; i < n; i++) values[i] = random_uniform(state);
}

#endif
