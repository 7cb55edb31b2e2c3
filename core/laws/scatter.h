/* Random scatter over the elements of a membrane: normal scores, independent or correlated in space, and the
 * distributions that they stand for.  The same seed gives the same values on every machine with the same C
 * library. */
#ifndef CAPSELLA_LAWS_SCATTER_H
#define CAPSELLA_LAWS_SCATTER_H

#include "base/status.h"

/* score [n], each normal with mean 0 and deviation 1.
 *
 * correlation 0: independent of each other, drawn in order.
 * correlation L: a Gaussian random field in space, taken at the points [n][3], a sum of plane waves
 * (Shinozuka & Deodatis, Appl. Mech. Rev. 44 (1991)) with normal amplitudes and normal wave vectors of
 * deviation 1/L: scores at distance r have correlation exp(-r^2/(2 L^2)) over all seeds, and the field does
 * not depend on where or in which order it is asked for. */
Status scatter_scores(long long seed, double correlation, int n, const double (*point)[3], double *score,
                      Error *error);

/* The value that a distribution has at the probability of a score. */
double scatter_weibull(double score, double scale, double modulus);
double scatter_normal(double score, double mean, double deviation);
double scatter_log_normal(double score, double mean, double deviation); /* those of the value */
double scatter_uniform(double score, double from, double to);

/* The scale of a Weibull distribution with this mean. */
double scatter_weibull_scale(double mean, double modulus);

#endif
