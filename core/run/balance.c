#include "run/balance.h"

#include "base/array.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Nodes and weights of the rule of Gauss and Lobatto on [0, 1]: exact for polynomials of degree 5. */
static const double NODE[BALANCE_NODES] = {0, 0.27639320225002103, 0.72360679774997897, 1};
static const double WEIGHT[BALANCE_NODES] = {1.0 / 12, 5.0 / 12, 5.0 / 12, 1.0 / 12};

/* No part is shorter than this share of the step, and after so many trials the rest is one part: a force that
 * does not belong to the energy would be looked at without end. */
static const double SHORTEST_PART = 1.0 / 1024;
enum { MOST_TRIALS = 64 };

Status balance_new(Balance *b, int n, Error *error) {
  Status status = STATUS_OK;
  const size_t size = (size_t)n;
  *b = (Balance){.n = n};
  TRY(ARRAY_NEW(&b->part_Y, size, error));
  TRY(ARRAY_NEW(&b->part_d, size, error));
  TRY(ARRAY_NEW(&b->last_Y, size, error));
  TRY(ARRAY_NEW(&b->last_d, size, error));
cleanup:
  if (status != STATUS_OK) balance_free(b);
  return status;
}

void balance_free(Balance *b) {
  array_free(b->part_Y);
  array_free(b->part_d);
  array_free(b->last_Y);
  array_free(b->last_d);
  *b = (Balance){0};
}

static void keep(const Balance *b, const double *from_Y, const double *from_d, double *Y, double *d) {
  if (b->n == 0) return;
  memcpy(Y, from_Y, (size_t)b->n * sizeof *Y);
  memcpy(d, from_d, (size_t)b->n * sizeof *d);
}

/* int Y dd dS0 from an instant with Y0 and d0 to this one. */
static double release(const Balance *b, const double *Y0, const double *d0, const Instant *now) {
  double sum = 0;
  for (int k = 0; k < b->n; k++) sum += 0.5 * (Y0[k] + now->Y[k]) * (now->d[k] - d0[k]) * b->area[k];
  return sum;
}

typedef struct {
  double power[BALANCE_NODES];
  double work, dissipated;
  double doubt; /* how far the energy spent up to the third node is from that in one go */
  Instant end;
} Part;

/* From `start`, whose Y and d are part_Y and part_d, to t1. */
static Status take_part(Balance *b, const Instant *start, double t1, Part *part, Error *error) {
  const double h = t1 - start->t;
  keep(b, b->part_Y, b->part_d, b->last_Y, b->last_d);
  *part = (Part){.power = {start->power}, .work = WEIGHT[0] * h * start->power};
  for (int i = 1; i < BALANCE_NODES; i++) {
    Instant *now = &part->end;
    const Status status =
        b->look(b->context, i == BALANCE_NODES - 1 ? t1 : start->t + NODE[i] * h, now, error);
    if (status != STATUS_OK) return status;
    b->looks++;
    part->power[i] = now->power;
    part->work += WEIGHT[i] * h * now->power;
    part->dissipated += release(b, b->last_Y, b->last_d, now);
    if (i == 2) part->doubt = part->dissipated - release(b, b->part_Y, b->part_d, now);
    keep(b, now->Y, now->d, b->last_Y, b->last_d);
  }
  return STATUS_OK;
}

/* Damage that jumps between the second node and the third makes work and energy spent err by the same: only
 * the doubt tells. */
static bool is_balanced(const Instant *start, const Part *part, double tolerance, double scale) {
  const double gained = part->end.stored - start->stored + part->dissipated;
  const double error = fmax(fabs(gained - part->work), fabs(part->doubt));
  return !(error > tolerance * fmax(scale, part->end.stored + part->dissipated));
}

Status balance_step(Balance *b, const Instant *start, double t1, double tolerance, double scale,
                    Error *error) {
  Status status = STATUS_OK;
  const double shortest = SHORTEST_PART * (t1 - start->t);
  double length = t1 - start->t;
  Instant from = *start;
  b->t0 = start->t;
  b->t1 = t1;
  b->work = b->dissipated = 0;
  b->looks = 0;
  keep(b, start->Y, start->d, b->part_Y, b->part_d);
  for (int trial = 1; from.t < t1; trial++) {
    Part part;
    const bool is_rest = from.t + length >= t1 - 0.5 * shortest || trial >= MOST_TRIALS;
    const double end = is_rest ? t1 : from.t + length;
    TRY(take_part(b, &from, end, &part, error));
    length = end - from.t;
    if (trial == 1) memcpy(b->power, part.power, sizeof b->power);
    if (trial < MOST_TRIALS && length > shortest && !is_balanced(&from, &part, tolerance, scale)) {
      length *= 0.5;
      continue;
    }
    b->work += part.work;
    b->dissipated += part.dissipated;
    keep(b, b->last_Y, b->last_d, b->part_Y, b->part_d);
    from = part.end;
    length *= 2;
  }
  b->stored = from.stored;
cleanup:
  return status;
}

/* Integral from 0 to u of the cubic through the values at the nodes. */
static double integral(const double power[BALANCE_NODES], double u) {
  double sum = 0;
  for (int i = 0; i < BALANCE_NODES; i++) {
    double c[BALANCE_NODES] = {1}; /* of the cubic that is 1 at node i and 0 at the others */
    for (int j = 0, degree = 0; j < BALANCE_NODES; j++) {
      if (j == i) continue;
      const double scale = 1 / (NODE[i] - NODE[j]);
      degree++;
      for (int k = degree; k >= 0; k--) c[k] = scale * ((k > 0 ? c[k - 1] : 0) - NODE[j] * c[k]);
    }
    sum += power[i] * u * (c[0] + u * (c[1] / 2 + u * (c[2] / 3 + u * c[3] / 4)));
  }
  return sum;
}

double balance_work(const Balance *b, double t) {
  const double h = b->t1 - b->t0;
  return t == b->t1 ? b->work : h * integral(b->power, (t - b->t0) / h);
}
