/* What outputs read from the membrane; nothing here is needed to advance it. */
#include "base/array.h"
#include "membrane/membrane_private.h"
#include "mesh/p2.h"
#include "mesh/quadrature.h"
#include <math.h>
#include <string.h>

/* Compression below this share of the shear modulus is round-off of a membrane at rest. */
static const double SLIGHT_COMPRESSION = 1e-6;

int membrane_points(const Membrane *m) {
  return m->n_points;
}
const MembraneHistory *membrane_accepted(const Membrane *m) {
  return &m->accepted;
}
MembraneHistory *membrane_restored(Membrane *m) {
  return &m->accepted;
}
const MembraneHistory *membrane_trial(const Membrane *m) {
  return &m->trial;
}

const LawFailure *membrane_law_failure(const Membrane *m) {
  return &m->failure;
}

MembranePoints membrane_points_view(const Membrane *m) {
  return (MembranePoints){.phi = m->phi, .J = m->J, .dS0 = m->weight, .d = m->has_damage ? m->trial.d : NULL};
}

MembraneCount membrane_count(const Membrane *m) {
  return (MembraneCount){.mass_iterations = m->mass.iterations};
}

void membrane_channels(const Membrane *m, double *const channel[MLAW_N_CHANNELS]) {
  const size_t bytes = (size_t)m->n_points * sizeof(double);
  if (channel[MLAW_Y]) memcpy(channel[MLAW_Y], m->phi, bytes);
  if (channel[MLAW_I1]) memcpy(channel[MLAW_I1], m->I1, bytes);
  if (channel[MLAW_I2]) memcpy(channel[MLAW_I2], m->I2, bytes);
  if (channel[MLAW_L1] || channel[MLAW_L2] || channel[MLAW_T1] || channel[MLAW_T2])
    principal_values(m->n_points, m->I1, m->I2, m->dphi, m->dphi + m->n_points, channel[MLAW_L1],
                     channel[MLAW_L2], channel[MLAW_T1], channel[MLAW_T2]);
}

int membrane_largest(const Membrane *m, const double *value) {
  int at = 0;
  for (int k = 1; k < m->n_points; k++)
    if (value[k] > value[at] + 1e-12 * fabs(value[at])) at = k;
  return at;
}

double membrane_damage_growth(const Membrane *m) {
  if (!m->has_damage) return 0;
  return m->trial.d[membrane_largest(m, m->trial.d)] - m->accepted.d[membrane_largest(m, m->accepted.d)];
}

/* Of the reference area, where sign * value is above a limit. */
static double area_share(const Membrane *m, const double *value, double sign, double limit) {
  double area = 0, inside = 0;
  for (int k = 0; k < m->n_points; k++) {
    area += m->weight[k];
    if (sign * value[k] > limit) inside += m->weight[k];
  }
  return inside / area;
}

double membrane_damaged_area(const Membrane *m, const double *d) {
  return area_share(m, d, 1, 0);
}

double membrane_compressed_area(const Membrane *m, const double *T2) {
  return area_share(m, T2, -1, SLIGHT_COMPRESSION * m->material->shear_modulus);
}

void membrane_principal_tensions(const Membrane *m, double *T1, double *T2) {
  principal_values(m->n_points, m->I1, m->I2, m->dphi, m->dphi + m->n_points, NULL, NULL, T1, T2);
  if (!m->has_damage) return;
  for (int k = 0; k < m->n_points; k++) {
    if (T1) T1[k] *= 1 - m->trial.d[k];
    if (T2) T2[k] *= 1 - m->trial.d[k];
  }
}

double membrane_energy(const Membrane *m) {
  double sum = 0;
  for (int k = 0; k < m->n_points; k++)
    sum += (m->has_damage ? 1 - m->trial.d[k] : 1.0) * m->phi[k] * m->weight[k];
  return sum;
}

static MembraneRelease release(const Membrane *m, const MembraneHistory *history) {
  if (!m->has_damage) return (MembraneRelease){0};
  const double *Y = m->channel_history ? history->channel[MLAW_Y] : history->Ymax;
  /* What is released at a point is its own energy, whatever drives its damage. */
  if (m->is_nonlocal) Y = history == &m->trial ? m->phi : history->Y;
  return (MembraneRelease){Y, history->d};
}

MembraneRelease membrane_release_accepted(const Membrane *m) {
  return release(m, &m->accepted);
}

MembraneRelease membrane_release_trial(const Membrane *m) {
  return release(m, &m->trial);
}

/* Adds the forces of a computed element, and of its images, at their fifteen nodes. */
static void add_images(const Membrane *m, int orbit, double force[P4_NODES][3], double *R) {
  const Symmetry *symmetry = m->symmetry;
  const int element = symmetry->elements.representative[orbit], first = element - element % P4_CHILDREN;
  for (int k = 0; k < symmetry->n_operations; k++) {
    const SymmetryOperation *operation = &symmetry->operation[k];
    /* Each image once: by the operation that the orbits name. */
    if (symmetry->elements.operation[operation->element[element]] != k) continue;
    for (int i = 0; i < P4_NODES; i++) {
      const P4Place place = m->quartic.place[i];
      const int node = operation->node[m->mesh->element[first + place.child][place.local]];
      for (int c = 0; c < 3; c++) R[3 * node + c] += operation->sign[c] * force[i][c];
    }
  }
}

void membrane_energy_gradient(const Membrane *m, const double *x, double *R) {
  if (m->interpolation == INTERPOLATION_QUADRATIC) return;
  memset(R, 0, 3 * (size_t)m->mesh->n_nodes * sizeof *R);
  ElementBlock block;
  for (int first = 0; first < m->n_elements; first += LANES) {
    const int n = membrane_block_size(m, first);
    membrane_base_vectors(m, first, n, x, &block);
    element_tensions(membrane_metric(m, first), n, &block, m->dphi + first, m->dphi + m->n_points + first,
                     m->has_damage ? m->trial.d + first : NULL);
    for (int lane = 0; lane < n; lane++) {
      double force[P4_NODES][3];
      quartic_force(&m->quartic, m->symmetry->elements.representative[first + lane], lane, &block, force);
      add_images(m, first + lane, force, R);
    }
  }
}

double membrane_dissipation(const Membrane *m) {
  if (!m->has_damage) return 0;
  const MembraneRelease before = release(m, &m->accepted), now = release(m, &m->trial);
  double sum = 0;
  for (int k = 0; k < m->n_points; k++)
    sum += 0.5 * (before.Y[k] + now.Y[k]) * (now.d[k] - before.d[k]) * m->weight[k];
  return sum;
}

void membrane_point_position(const Membrane *m, int k, const double *nodes, double position[3]) {
  const int e = m->symmetry->elements.representative[k % m->n_elements], g = k / m->n_elements;
  for (int c = 0; c < 3; c++) {
    position[c] = 0;
    for (int p = 0; p < 6; p++) position[c] += m->basis.N[g][p] * nodes[3 * m->mesh->element[e][p] + c];
  }
}

/* Least-squares plane c0 + c1 xi + c2 eta through the six values of an element, as a matrix from values to
 * nodes. */
static void plane_fit(double fit[6][RULE_POINTS]) {
  const TriangleRule *rule = triangle_rule(RULE_POINTS);
  /* The points are symmetric about the centre of the triangle, in barycentric coordinates b_i: the moments of
   * (b_i - 1/3)(b_j - 1/3) are a (delta_ij - 1/3), so that the slope in direction b_i is the moment of the
   * value / a. */
  double a = 0;
  for (int g = 0; g < RULE_POINTS; g++) {
    const double b = rule->point[g][0] - 1.0 / 3;
    a += 1.5 * b * b;
  }
  for (int p = 0; p < 6; p++) {
    const double node[3] = {1 - p2_node[p][0] - p2_node[p][1], p2_node[p][0], p2_node[p][1]};
    for (int g = 0; g < RULE_POINTS; g++) {
      const double point[3] = {1 - rule->point[g][0] - rule->point[g][1], rule->point[g][0],
                               rule->point[g][1]};
      fit[p][g] = 1.0 / RULE_POINTS;
      for (int i = 0; i < 3; i++) fit[p][g] += (node[i] - 1.0 / 3) * (point[i] - 1.0 / 3) / a;
    }
  }
}

void membrane_nodal_field(const Membrane *m, const double *point_values, double *node_values) {
  const Orbits *nodes = &m->symmetry->nodes;
  double fit[6][RULE_POINTS];
  plane_fit(fit);
  for (int i = 0; i < nodes->n; i++) {
    double sum = 0, weight = 0, lowest = INFINITY, highest = -INFINITY;
    for (int s = m->assembly.start[i]; s < m->assembly.start[i + 1]; s++) {
      const AssemblyTerm *term = &m->assembly.term[s];
      double value = 0, area = 0;
      for (int g = 0; g < RULE_POINTS; g++) {
        const int point = g * m->n_elements + term->orbit;
        value += fit[term->local][g] * point_values[point];
        area += m->dS0[point];
        lowest = fmin(lowest, point_values[point]);
        highest = fmax(highest, point_values[point]);
      }
      sum += area * value;
      weight += area;
    }
    node_values[nodes->representative[i]] = fmin(fmax(sum / weight, lowest), highest);
  }
  for (int p = 0; p < m->mesh->n_nodes; p++)
    node_values[p] = node_values[nodes->representative[nodes->orbit[p]]];
}
