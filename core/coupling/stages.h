/* The stages that the stabilised Runge-Kutta methods share: the recurrence of Runge-Kutta-Chebyshev methods
 * (Sommeijer, Shampine & Verwer, J. Comput. Appl. Math. 88, 1998, eq. 2.1)
 *
 *   Y_1 = Y_0 + f0 h F_0,   Y_j = x0 Y_0 + last Y_{j-1} + before Y_{j-2} + h (f F_{j-1} + f0 F_0)
 *
 * in which every stage but the first is of order two. */
#ifndef CAPSELLA_COUPLING_STAGES_H
#define CAPSELLA_COUPLING_STAGES_H

/* Chebyshev polynomial T_j at w and its first two derivatives. */
typedef struct {
  double T, dT, d2T;
} Chebyshev;

Chebyshev chebyshev(int j, double w);

/* The factors of stage j, and where in the step it stands: 0 at its start, 1 at its end. */
typedef struct {
  double x0, last, before, f, f0;
  double time;
} StageTerms;

/* What the recurrence knows of the two stages before. */
typedef struct {
  double w0, w1;
  int j;
  Chebyshev C_before, C_last;
  double b_before, b_last, a_last;
} Stages;

/* `w0` above 1 damps; stage number `end` (at least 2) stands at the end of the step. */
Stages stages_open(double w0, int end);

/* The terms of stage 1, then 2, ... */
StageTerms stages_next(Stages *stages);

/* Y_j [n] into `next`, which may be none of the others. */
void stage_sum(const StageTerms *terms, double h, int n, const double *x0, const double *f0,
               const double *last, const double *before, const double *f, double *next);

/* After a stage: it is the last one now, the last is the one before, and the array of that is free for the
 * next. */
void stages_turn(double **before, double **last, double **next);

#endif
