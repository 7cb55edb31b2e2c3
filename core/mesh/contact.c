/* Triangles of the icosahedron, their children and so on down to the elements, each with a sphere around its
 * positions and one around its normals.  Pairs of triangles are followed down as long as something in one may
 * face something in the other nearby, which on a capsule without contact ends after a few levels. */
#include "mesh/contact.h"

#include "base/array.h"
#include "base/vec3.h"
#include "mesh/p2.h"
#include "mesh/winding.h"

#include <math.h>

enum { CHILDREN = 4, MAX_LEVELS = 8 };

/* Elements whose centres were nearer to each other at rest, in edges, are neighbours. */
static const double NEIGHBOURS = 3;
/* Unit normals n, m face each other when |n + m| is less: more than 120 degrees. */
static const double FACING = 1;
/* What has its foot on an element is not farther beside the axis of its triangle than so many radii, squared:
 * a film leans as the normals of a curved element do. */
static const double WIDE = 3;
/* Only across thinner films is it certain that nothing else lies between: where the surface crosses itself
 * there are some. */
static const double CROSSING = 0.5;
/* Largest sum of the shape functions of the mid-edge nodes on an element. */
static const double MIDDLES = 4.0 / 3;

typedef struct {
  double center[3], radius; /* contains the nodes */
  double normal[3], spread; /* contains the normals of the elements, taken as flat */
  double width;             /* largest of the elements */
  double bulge;             /* of an element: its surface is so near to its flat triangle */
} Patch;

struct ContactSearch {
  const Mesh *mesh;
  int n_levels;
  Patch *level[MAX_LEVELS]; /* the last one: elements */
  double (*rest)[3];        /* [n_elements] centres at rest */
  double apart2;            /* squared distance of centres at rest from which on they are no neighbours */
  const double *x;
  Contact inside, outside; /* thinnest films so far */
};

Status contact_search_new(ContactSearch **out, const Mesh *mesh, Error *error) {
  Status status = STATUS_OK;
  ContactSearch *search = NULL;
  TRY(ARRAY_NEW(&search, 1, error));
  search->mesh = mesh;
  search->n_levels = mesh->subdivisions + 1;
  for (int l = 0; l < search->n_levels; l++)
    TRY(ARRAY_NEW(&search->level[l], (size_t)mesh->n_elements >> 2 * (mesh->subdivisions - l), error));
  TRY(ARRAY_NEW(&search->rest, mesh->n_elements, error));
  for (int e = 0; e < mesh->n_elements; e++)
    for (int k = 0; k < 3; k++)
      for (int i = 0; i < 3; i++) search->rest[e][i] += mesh->X[3 * mesh->element[e][k] + i] / 3;
  const double apart = NEIGHBOURS * mesh_edge_length(mesh, mesh->X);
  search->apart2 = apart * apart;
  *out = search;
  search = NULL;
cleanup:
  contact_search_free(search);
  return status;
}

void contact_search_free(ContactSearch *search) {
  if (!search) return;
  for (int l = 0; l < search->n_levels; l++) array_free(search->level[l]);
  array_free(search->rest);
  array_free(search);
}

/* ---- patches ---- */

static double squared_distance(const double a[3], const double b[3]) {
  double d[3];
  vec3_subtract(a, b, d);
  return vec3_dot(d, d);
}

/* Height of a place over the triangle of the corners. */
static double height_over(const Patch *element, const double place[3]) {
  double offset[3];
  vec3_subtract(place, element->center, offset);
  return vec3_dot(offset, element->normal);
}

static void measure_element(const int node[6], const double *x, Patch *patch) {
  const double *corner[3] = {x + 3 * node[0], x + 3 * node[1], x + 3 * node[2]};
  double edge[2][3], longest2 = squared_distance(corner[1], corner[2]), radius2 = 0, height = 0;
  for (int k = 0; k < 2; k++) {
    vec3_subtract(corner[k + 1], corner[0], edge[k]);
    longest2 = fmax(longest2, vec3_dot(edge[k], edge[k]));
  }
  for (int i = 0; i < 3; i++) patch->center[i] = (corner[0][i] + corner[1][i] + corner[2][i]) / 3;
  for (int k = 0; k < 6; k++) radius2 = fmax(radius2, squared_distance(x + 3 * node[k], patch->center));
  patch->radius = sqrt(radius2);
  vec3_cross(edge[0], edge[1], patch->normal);
  patch->width = vec3_normalize(patch->normal) / sqrt(longest2);
  patch->spread = 0;
  for (int k = 3; k < 6; k++) height = fmax(height, fabs(height_over(patch, x + 3 * node[k])));
  patch->bulge = MIDDLES * height;
}

static void enclose(const Patch child[CHILDREN], Patch *patch) {
  patch->radius = patch->spread = patch->width = 0;
  for (int i = 0; i < 3; i++) {
    patch->center[i] =
        0.25 * (child[0].center[i] + child[1].center[i] + child[2].center[i] + child[3].center[i]);
    patch->normal[i] =
        0.25 * (child[0].normal[i] + child[1].normal[i] + child[2].normal[i] + child[3].normal[i]);
  }
  for (int c = 0; c < CHILDREN; c++) {
    patch->radius = fmax(patch->radius, vec3_distance(child[c].center, patch->center) + child[c].radius);
    patch->spread = fmax(patch->spread, vec3_distance(child[c].normal, patch->normal) + child[c].spread);
    patch->width = fmax(patch->width, child[c].width);
  }
}

static void measure_patches(ContactSearch *search) {
  const Mesh *mesh = search->mesh;
  Patch *patch = search->level[search->n_levels - 1];
  for (int e = 0; e < mesh->n_elements; e++) measure_element(mesh->element[e], search->x, &patch[e]);
  for (int l = search->n_levels - 2, n = mesh->n_elements; l >= 0; l--) {
    n /= CHILDREN;
    for (int k = 0; k < n; k++) enclose(&search->level[l + 1][CHILDREN * k], &search->level[l][k]);
  }
}

static bool may_face(const Patch *a, const Patch *b) {
  const double reach = a->radius + b->radius + fmax(a->width, b->width);
  const double facing = FACING + a->spread + b->spread;
  const double sum[3] = {a->normal[0] + b->normal[0], a->normal[1] + b->normal[1],
                         a->normal[2] + b->normal[2]};
  return vec3_dot(sum, sum) < facing * facing && squared_distance(a->center, b->center) < reach * reach;
}

/* ---- films ---- */

/* The foot of a place on an element: offset of the place from it, along the normal unless the foot lies
 * outside.  Returns whether it lies on the element, or so near to it that a curved edge may hide it. */
static bool find_foot(const int node[6], const double *x, const double place[3], double offset[3],
                      double normal[3]) {
  static const double margin = 0.05;
  enum { NEWTON = 4 };
  double xi = 1.0 / 3, eta = 1.0 / 3, N[6], dN[6][2], a[3], b[3];
  for (int step = 0;; step++) {
    p2_values(xi, eta, N);
    p2_gradients(xi, eta, dN);
    p2_interpolate(x, node, N, offset);
    for (int i = 0; i < 3; i++) offset[i] = place[i] - offset[i];
    p2_tangents(x, node, (const double(*)[2])dN, a, b);
    if (step == NEWTON) break;
    const double aa = vec3_dot(a, a), ab = vec3_dot(a, b), bb = vec3_dot(b, b);
    const double ra = vec3_dot(offset, a), rb = vec3_dot(offset, b), det = aa * bb - ab * ab;
    xi += (bb * ra - ab * rb) / det;
    eta += (aa * rb - ab * ra) / det;
  }
  vec3_cross(a, b, normal);
  return xi > -margin && eta > -margin && xi + eta < 1 + margin; /* false for NAN */
}

/* Whether the foot of the place may lie on element b, and in front of it or behind by less than the thinnest
 * film so far: by its flat triangle, and cheaply. */
static bool may_be_over(const ContactSearch *search, const Patch *b, const double place[3]) {
  const double height = height_over(b, place), distance2 = squared_distance(place, b->center);
  const double thinnest = fmin(1, (height < 0 ? &search->inside : &search->outside)->share);
  return fabs(height) < thinnest * b->width + b->bulge &&
         distance2 - height * height < WIDE * b->radius * b->radius;
}

/* The film between the nodes that element a comes first to and element b, if there is one. */
static void look_across(ContactSearch *search, int a, int b) {
  const Mesh *mesh = search->mesh;
  const Patch *patch = &search->level[search->n_levels - 1][b];
  for (int k = 0; k < 6; k++) {
    const int p = mesh->element[a][k];
    const double *place = search->x + 3 * p;
    double offset[3], normal[3];
    if (mesh->node_element[mesh->node_start[p]] != a || !may_be_over(search, patch, place)) continue;
    if (!find_foot(mesh->element[b], search->x, place, offset, normal)) continue;
    const double gap = vec3_norm(offset), share = gap / patch->width;
    Contact *film = vec3_dot(offset, normal) < 0 ? &search->inside : &search->outside;
    if (share >= 1 || share >= film->share) continue;
    *film = (Contact){.share = share, .gap = gap, .node = p, .element = b};
    for (int i = 0; i < 3; i++) film->place[i] = place[i] - 0.5 * offset[i];
  }
}

static void look_at_pair(ContactSearch *search, int l, int a, int b) {
  const Patch *patch = search->level[l];
  if (!may_face(&patch[a], &patch[b])) return;
  if (l < search->n_levels - 1) {
    for (int i = 0; i < CHILDREN; i++)
      for (int k = a == b ? i : 0; k < CHILDREN; k++)
        look_at_pair(search, l + 1, CHILDREN * a + i, CHILDREN * b + k);
  } else if (squared_distance(search->rest[a], search->rest[b]) > search->apart2) {
    look_across(search, a, b);
    look_across(search, b, a);
  }
}

/* Between two sheets that face each other with their inner sides the surface winds around once, with their
 * outer sides not at all, unless it crosses itself. */
static bool is_turned_over(const ContactSearch *search, const Contact *film, int winding) {
  return film->share < CROSSING && (int)rint(winding_number(search->mesh, search->x, film->place)) != winding;
}

Contact contact_find(ContactSearch *search, const double *x) {
  search->x = x;
  search->inside = search->outside = (Contact){.share = INFINITY, .gap = INFINITY, .node = -1, .element = -1};
  measure_patches(search);
  const int n = search->mesh->n_elements >> 2 * (search->n_levels - 1);
  for (int a = 0; a < n; a++)
    for (int b = a; b < n; b++) look_at_pair(search, 0, a, b);
  Contact contact = search->inside.share < search->outside.share ? search->inside : search->outside;
  contact.crosses = is_turned_over(search, &search->inside, 1) || is_turned_over(search, &search->outside, 0);
  return contact;
}
