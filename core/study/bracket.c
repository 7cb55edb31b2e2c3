#include "study/bracket.h"

#include "study/decimal.h"
#include <math.h>

/* Round-off in sums of decimals. */
static const double SLACK = 1e-9;

static double rounded(const Bracket *bracket, double value) {
  return fmin(fmax(decimal_multiple(value, bracket->unit), bracket->low), bracket->high);
}

void bracket_start(Bracket *bracket, double low, double high, double tolerance, double guess, double reach) {
  *bracket = (Bracket){.low = low,
                       .high = high,
                       .tolerance = tolerance,
                       .unit = decimal_unit(tolerance),
                       .no = NAN,
                       .yes = NAN,
                       .guess = isnan(guess) ? 0.5 * (low + high) : fmin(fmax(guess, low), high),
                       .reach = fmax(reach, 0.5 * tolerance)};
}

bool bracket_is_closed(const Bracket *bracket) {
  return bracket->yes - bracket->no <= bracket->tolerance * (1 + SLACK); /* false for NAN */
}

double bracket_value(const Bracket *bracket) {
  return bracket_is_closed(bracket) ? decimal_digits(0.5 * (bracket->no + bracket->yes), 10) : NAN;
}

/* The first two trials are 2 reach apart after rounding too. */
static int around_guess(const Bracket *bracket, double trial[2]) {
  trial[0] = rounded(bracket, bracket->guess - bracket->reach);
  trial[1] = rounded(bracket, trial[0] + 2 * bracket->reach);
  return trial[1] > trial[0] ? 2 : 1;
}

/* Each step beyond the last trial is twice as long as the one before. */
static int outward(Bracket *bracket, double from, double sign, double trial[2]) {
  bracket->reach *= 2;
  trial[0] = rounded(bracket, from + sign * bracket->reach);
  return trial[0] != from;
}

int bracket_next(Bracket *bracket, double trial[2]) {
  if (isnan(bracket->no) && isnan(bracket->yes)) return around_guess(bracket, trial);
  if (isnan(bracket->no)) return outward(bracket, bracket->yes, -1, trial);
  if (isnan(bracket->yes)) return outward(bracket, bracket->no, 1, trial);
  if (bracket_is_closed(bracket)) return 0;
  trial[0] = rounded(bracket, 0.5 * (bracket->no + bracket->yes));
  return trial[0] > bracket->no && trial[0] < bracket->yes;
}

void bracket_learn(Bracket *bracket, double value, bool holds) {
  if (holds)
    bracket->yes = fmin(value, bracket->yes); /* fmin and fmax pass over NAN */
  else
    bracket->no = fmax(value, bracket->no);
}

int bracket_plain_trials(double low, double high, double tolerance) {
  return 2 + (int)fmax(0, ceil(log2((high - low) / tolerance) - SLACK));
}
