/* Elements near the point are cut in four until each is small against its distance; the pieces count as
 * flat. */
#include "mesh/winding.h"

#include "base/vec3.h"
#include "mesh/p2.h"

static const double TWO_PI = 6.283185307179586;

/* A piece will do for points farther from its corners than so many of its edges... */
static const double FAR = 2;
/* ... or when it has been cut so many times. */
enum { MAX_CUTS = 7 };

/* Half the solid angle of the triangle, from the point at the origin (van Oosterom and Strackee 1983). */
static double half_angle(const double a[3], const double b[3], const double c[3]) {
  double bc[3];
  vec3_cross(b, c, bc);
  const double la = vec3_norm(a), lb = vec3_norm(b), lc = vec3_norm(c);
  const double beside = la * lb * lc + vec3_dot(a, b) * lc + vec3_dot(b, c) * la + vec3_dot(c, a) * lb;
  return atan2(vec3_dot(a, bc), beside);
}

typedef struct {
  const double *x, *point;
  const int *node;
} Seen;

/* A place on the element as seen from the point. */
static void look(const Seen *seen, const double xi[2], double offset[3]) {
  double N[6];
  p2_values(xi[0], xi[1], N);
  p2_interpolate(seen->x, seen->node, N, offset);
  for (int i = 0; i < 3; i++) offset[i] -= seen->point[i];
}

static double largest2(const double a[3], const double b[3], const double c[3]) {
  return fmax(vec3_dot(a, a), fmax(vec3_dot(b, b), vec3_dot(c, c)));
}

static double part_angle(const Seen *seen, const double xi[3][2], int cuts) {
  double corner[3][3], edge[3][3], nearest2 = INFINITY;
  for (int k = 0; k < 3; k++) {
    look(seen, xi[k], corner[k]);
    nearest2 = fmin(nearest2, vec3_dot(corner[k], corner[k]));
  }
  for (int k = 0; k < 3; k++) vec3_subtract(corner[(k + 1) % 3], corner[k], edge[k]);
  if (cuts == MAX_CUTS || nearest2 > FAR * FAR * largest2(edge[0], edge[1], edge[2]))
    return half_angle(corner[0], corner[1], corner[2]);
  double middle[3][2], sum = 0;
  for (int k = 0; k < 3; k++)
    for (int i = 0; i < 2; i++) middle[k][i] = 0.5 * (xi[k][i] + xi[(k + 1) % 3][i]);
  for (int k = 0; k < 3; k++) {
    const double *before = middle[(k + 2) % 3], *after = middle[k];
    const double part[3][2] = {{xi[k][0], xi[k][1]}, {after[0], after[1]}, {before[0], before[1]}};
    sum += part_angle(seen, part, cuts + 1);
  }
  return sum + part_angle(seen, (const double(*)[2])middle, cuts + 1);
}

double winding_number(const Mesh *mesh, const double *x, const double point[3]) {
  static const double whole[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  double sum = 0;
  for (int e = 0; e < mesh->n_elements; e++) {
    const Seen seen = {x, point, mesh->element[e]};
    sum += part_angle(&seen, whole, 0);
  }
  return sum / TWO_PI;
}
