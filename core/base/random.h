/* Pseudo-random numbers that are the same on every machine: splitmix64 (Steele, Lea & Flood, OOPSLA 2014). */
#ifndef CAPSELLA_BASE_RANDOM_H
#define CAPSELLA_BASE_RANDOM_H

#include <stdint.h>

static inline uint64_t random_mix(uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/* In (-1, 1). */
static inline double random_symmetric(uint64_t bits) {
  return (double)(int32_t)(bits >> 32) * 0x1p-31;
}

#endif
