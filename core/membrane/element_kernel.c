#include "membrane/element_kernel.h"

#include "base/vector_clones.h"
#include <math.h>

VECTOR_CLONES
void element_base_vectors(const ElementBasis *basis, int n, ElementBlock *block) {
  for (int g = 0; g < RULE_POINTS; g++)
    for (int alpha = 0; alpha < 2; alpha++)
      for (int c = 0; c < 3; c++) {
        double *restrict a = block->a[g][alpha][c];
        for (int e = 0; e < n; e++) {
          double sum = 0;
          for (int p = 0; p < 6; p++) sum += basis->dN[g][p][alpha] * block->node[p][c][e];
          a[e] = sum;
        }
      }
}

VECTOR_CLONES
void element_kinematics(ReferenceMetric metric, int n, ElementBlock *block, double *I1, double *I2,
                        double *J) {
  for (int g = 0; g < RULE_POINTS; g++) {
    double(*restrict a1)[LANES] = block->a[g][0], (*restrict a2)[LANES] = block->a[g][1];
    const ptrdiff_t row = g * metric.ld;
    for (int e = 0; e < n; e++) {
      const double a11 = a1[0][e] * a1[0][e] + a1[1][e] * a1[1][e] + a1[2][e] * a1[2][e];
      const double a12 = a1[0][e] * a2[0][e] + a1[1][e] * a2[1][e] + a1[2][e] * a2[2][e];
      const double a22 = a2[0][e] * a2[0][e] + a2[1][e] * a2[1][e] + a2[2][e] * a2[2][e];
      const double ratio = (a11 * a22 - a12 * a12) * metric.inverse_det[row + e];
      I1[row + e] = metric.A11[row + e] * a11 + 2 * metric.A12[row + e] * a12 + metric.A22[row + e] * a22 - 2;
      I2[row + e] = ratio - 1;
      J[row + e] = sqrt(ratio);
      block->normal[g][0][e] = a1[1][e] * a2[2][e] - a1[2][e] * a2[1][e];
      block->normal[g][1][e] = a1[2][e] * a2[0][e] - a1[0][e] * a2[2][e];
      block->normal[g][2][e] = a1[0][e] * a2[1][e] - a1[1][e] * a2[0][e];
    }
  }
  for (int e = 0; e < n; e++) {
    double mean[3] = {0, 0, 0};
    for (int g = 0; g < RULE_POINTS; g++)
      for (int c = 0; c < 3; c++) mean[c] += block->normal[g][c][e];
    for (int g = 0; g < RULE_POINTS; g++)
      block->facing[g][e] = mean[0] * block->normal[g][0][e] + mean[1] * block->normal[g][1][e] +
                            mean[2] * block->normal[g][2][e];
  }
}

VECTOR_CLONES
void element_tensions(ReferenceMetric metric, int n, ElementBlock *block, const double *phi1,
                      const double *phi2, const double *d) {
  for (int g = 0; g < RULE_POINTS; g++) {
    double(*restrict a1)[LANES] = block->a[g][0], (*restrict a2)[LANES] = block->a[g][1];
    double(*restrict t)[3][LANES] = block->t[g];
    const ptrdiff_t row = g * metric.ld;
    for (int e = 0; e < n; e++) {
      const double a11 = a1[0][e] * a1[0][e] + a1[1][e] * a1[1][e] + a1[2][e] * a1[2][e];
      const double a12 = a1[0][e] * a2[0][e] + a1[1][e] * a2[1][e] + a1[2][e] * a2[2][e];
      const double a22 = a2[0][e] * a2[0][e] + a2[1][e] * a2[1][e] + a2[2][e] * a2[2][e];
      const double scale = 2 * metric.dS0[row + e] * (d ? 1 - d[row + e] : 1.0);
      const double f1 = scale * phi1[row + e];
      const double f2 =
          scale * phi2[row + e] * metric.inverse_det[row + e]; /* (I2+1) a^{ab} = adj(a)/det(A) */
      const double s11 = f1 * metric.A11[row + e] + f2 * a22;
      const double s12 = f1 * metric.A12[row + e] - f2 * a12;
      const double s22 = f1 * metric.A22[row + e] + f2 * a11;
      for (int c = 0; c < 3; c++) {
        t[0][c][e] = s11 * a1[c][e] + s12 * a2[c][e];
        t[1][c][e] = s12 * a1[c][e] + s22 * a2[c][e];
      }
    }
  }
}

VECTOR_CLONES
void element_force(const ElementBasis *basis, int n, const ElementBlock *block, double *force,
                   ptrdiff_t force_ld) {
  for (int k = 0; k < 18; k++)
    for (int e = 0; e < n; e++) force[k * force_ld + e] = 0;
  for (int g = 0; g < RULE_POINTS; g++)
    for (int p = 0; p < 6; p++)
      for (int c = 0; c < 3; c++) {
        double *restrict f = force + (3 * p + c) * force_ld;
        const double *restrict t1 = block->t[g][0][c], *restrict t2 = block->t[g][1][c];
        const double d1 = basis->dN[g][p][0], d2 = basis->dN[g][p][1];
        for (int e = 0; e < n; e++) f[e] += d1 * t1[e] + d2 * t2[e];
      }
}

VECTOR_CLONES
void element_mass(const ElementBasis *basis, ReferenceMetric metric, int n, const double *J, double *mass,
                  ptrdiff_t mass_ld) {
  double dS[RULE_POINTS][LANES];
  for (int g = 0; g < RULE_POINTS; g++)
    for (int e = 0; e < n; e++) dS[g][e] = J[g * metric.ld + e] * metric.dS0[g * metric.ld + e];
  for (int k = 0; k < MASS_PAIRS; k++) {
    double *restrict m = mass + k * mass_ld;
    const double *NN = basis->NN[k];
    for (int e = 0; e < n; e++)
      m[e] = NN[0] * dS[0][e] + NN[1] * dS[1][e] + NN[2] * dS[2][e] + NN[3] * dS[3][e] + NN[4] * dS[4][e] +
             NN[5] * dS[5][e];
  }
}

VECTOR_CLONES
void principal_values(ptrdiff_t n, const double *I1, const double *I2, const double *phi1, const double *phi2,
                      double *l1, double *l2, double *T1, double *T2) {
  for (ptrdiff_t k = 0; k < n; k++) {
    const double mean = 0.5 * (I1[k] + 2), det = I2[k] + 1;
    const double spread = sqrt(fmax(mean * mean - det, 0.0));
    const double l1_squared = mean + spread, l2_squared = det / l1_squared;
    const double ratio = l1_squared / sqrt(det); /* l1 / l2 */
    if (l1) l1[k] = sqrt(l1_squared);
    if (l2) l2[k] = sqrt(l2_squared);
    if (T1) T1[k] = 2 * ratio * (phi1[k] + l2_squared * phi2[k]);
    if (T2) T2[k] = 2 / ratio * (phi1[k] + l1_squared * phi2[k]);
  }
}
