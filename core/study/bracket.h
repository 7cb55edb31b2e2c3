/* The search for the value at which a condition begins to hold, by trials that say yes or no: first around a
 * guess, then outward in growing steps until one trial says no and one above it yes, then by halving.
 *
 * Pure bookkeeping: what a trial is, the caller knows.  The answer is always between two trials that were
 * made, whatever the guess was worth. */
#ifndef CAPSELLA_STUDY_BRACKET_H
#define CAPSELLA_STUDY_BRACKET_H

#include <stdbool.h>

typedef struct {
  double low, high;    /* no trial outside */
  double tolerance;    /* the answer is known when yes - no <= tolerance */
  double unit;         /* trials are multiples of it, so that they read well */
  double no, yes;      /* the largest value with no, the smallest with yes; NAN: none yet */
  double guess, reach; /* the first trials are guess - reach and guess + reach */
} Bracket;

/* `guess` NAN: the middle; `reach` is at least half the tolerance. */
void bracket_start(Bracket *bracket, double low, double high, double tolerance, double guess, double reach);

/* The values to try next, rising, none of them tried before: their number, 0 when the search is over. */
int bracket_next(Bracket *bracket, double trial[2]);

void bracket_learn(Bracket *bracket, double value, bool holds);

/* Whether the answer lies between two trials within the tolerance. */
bool bracket_is_closed(const Bracket *bracket);

/* The middle of the bracket; NAN when it is not closed: the condition holds everywhere or nowhere in low ..
 * high, or the search is not over. */
double bracket_value(const Bracket *bracket);

/* How many trials halving low .. high takes without a guess. */
int bracket_plain_trials(double low, double high, double tolerance);

#endif
