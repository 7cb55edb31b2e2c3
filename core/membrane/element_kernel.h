/* The element work of the membrane on a block of elements, one lane per element: kinematics, internal force
 * and mass. Plain loops over lanes with unit stride, so that the compiler vectorises them. */
#ifndef CAPSELLA_MEMBRANE_ELEMENT_KERNEL_H
#define CAPSELLA_MEMBRANE_ELEMENT_KERNEL_H

#include <stddef.h>

enum { LANES = 64, RULE_POINTS = 6, MASS_PAIRS = 21 };

/* Shape functions at the six rule points, and the products that the mass matrix needs. */
typedef struct {
  double N[RULE_POINTS][6];
  double dN[RULE_POINTS][6][2];
  double NN[MASS_PAIRS][RULE_POINTS]; /* N_p N_q for p <= q, in the order of mass_pair() */
} ElementBasis;

/* Index of pair (p, q), p <= q, among the 21 of the symmetric element mass matrix. */
static inline int mass_pair(int p, int q) {
  return p * 6 - p * (p - 1) / 2 + q - p;
}

/* Reference metric at the points of one block; pointers to the first lane, rows of `ld` points apart (one row
 * per rule point). */
typedef struct {
  const double *A11, *A12, *A22; /* contravariant components A^{alpha beta} */
  const double *inverse_det;     /* 1 / det(A_{alpha beta}) */
  const double *dS0;             /* weight of the point in an integral over the reference surface */
  ptrdiff_t ld;
} ReferenceMetric;

/* Scratch of one thread. */
typedef struct {
  double node[6][3][LANES];             /* current positions of the nodes of each element */
  double a[RULE_POINTS][2][3][LANES];   /* covariant base vectors a_alpha = dx/dxi_alpha (paper eq. 2.4) */
  double normal[RULE_POINTS][3][LANES]; /* a_1 x a_2 */
  double t[RULE_POINTS][2][3][LANES];   /* dS0 J T^{ab} a_b */
  double facing[RULE_POINTS][LANES];    /* normal . mean normal of the element: <= 0 in a folded element */
} ElementBlock;

/* Base vectors of n <= LANES elements from their nodes. */
void element_base_vectors(const ElementBasis *basis, int n, ElementBlock *block);

/* Invariants I1, I2 (paper eq. 2.15) and area ratio J of n <= LANES elements from their base vectors; the
 * outputs have rows of metric.ld. */
void element_kinematics(ReferenceMetric metric, int n, ElementBlock *block, double *I1, double *I2,
                        double *J);

/* Tensions of n elements (paper eq. 3.2): with phi(I1, I2) per reference area,
 *   J T^{ab} = 2 (1 - d) [phi_1 A^{ab} + phi_2 (I2 + 1) a^{ab}].
 * phi1, phi2 and d (NULL: no damage) have rows of metric.ld. */
void element_tensions(ReferenceMetric metric, int n, ElementBlock *block, const double *phi1,
                      const double *phi2, const double *d);

/* Their internal force R_p = sum_g dS0 J T^{ab} N_{p,a} a_b; force [18][force_ld] is component 3 p + c of
 * each element. */
void element_force(const ElementBasis *basis, int n, const ElementBlock *block, double *force,
                   ptrdiff_t force_ld);

/* Element mass matrices on the current surface, sum_g J dS0 N_p N_q; mass [21][mass_ld]. */
void element_mass(const ElementBasis *basis, ReferenceMetric metric, int n, const double *J, double *mass,
                  ptrdiff_t mass_ld);

/* Principal stretches l1 >= l2 from the invariants, and the principal tensions of the undamaged membrane
 * T1 = 2 (l1/l2) (phi_1 + l2^2 phi_2) and cyclic; any output may be NULL. */
void principal_values(ptrdiff_t n, const double *I1, const double *I2, const double *phi1, const double *phi2,
                      double *l1, double *l2, double *T1, double *T2);

#endif
