/* Levels 0 .. element_level - 1 are nested triangles, the largest first; those after element_level are
 * halves, quarters, ... of the elements. */
#include "fluid/surface_tree.h"

#include "base/array.h"
#include "base/vec3.h"
#include "fluid/piece.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* The walk starts from at least so many nodes: larger triangles are near to almost every target. */
enum { FEWEST_ON_TOP = 80 };

/* Four elements fill whole blocks whatever the rule. */
static int blocks_of_four(const SurfaceTree *tree) {
  return CHILDREN * tree->rule.n / OSEEN_LANES;
}

/* Reference position of point g of the rule on an element. */
static void reference_point(const SurfaceTree *tree, const int element[6], int g, double point[3]) {
  for (int c = 0; c < 3; c++) {
    point[c] = 0;
    for (int k = 0; k < 6; k++) {
      double N = tree->rule.block[g / OSEEN_LANES].N[k][g % OSEEN_LANES];
      point[c] += N * tree->mesh->X[3 * element[k] + c];
    }
  }
}

/* The lattice of nested triangle k of level l, and the weights of its children's sources. */
static Status new_lattice(SurfaceTree *tree, int l, int k, Error *error) {
  Status status = STATUS_OK;
  const Mesh *mesh = tree->mesh;
  TreeMoments *nested = &tree->level[l].nested;
  const TreeMoments *below = &tree->level[l + 1].nested;
  int *node = nested->lattice[k], first = CHILDREN * k, n_sources = nested->n_sources;
  bool elements_below = l + 1 == tree->element_level;
  LatticeFit fit;
  if (elements_below) {
    TRY(lattice_of_elements((const int(*)[6])(mesh->element + first), node, error));
  } else {
    TRY(lattice_of_lattices((const int(*)[LATTICE_NODES])(below->lattice + first), node, error));
  }
  TRY(lattice_fit(&fit, mesh->X, node, error));
  for (int i = 0; i < CHILDREN * n_sources; i++) {
    int child = first + i / n_sources, source = i % n_sources;
    double point[3];
    if (elements_below) {
      reference_point(tree, tree->turned[child], source, point);
    } else {
      memcpy(point, mesh->X + 3 * below->lattice[child][source], sizeof point);
    }
    lattice_weights(&fit, point, nested->weight[(size_t)first * n_sources + i]);
  }
cleanup:
  return status;
}

static Status new_level(TreeLevel *level, int n, int fan, Error *error) {
  Status status = STATUS_OK;
  *level = (TreeLevel){.n = n, .fan = fan};
  for (int c = 0; c < 3; c++) TRY(ARRAY_NEW(&level->center[c], n, error));
  TRY(ARRAY_NEW(&level->reach2, n, error));
cleanup:
  return status;
}

/* Nested triangles take their moments from free[], and move it on. */
static Status new_nested_level(SurfaceTree *tree, int l, OseenBlock **free, Error *error) {
  Status status = STATUS_OK;
  TreeLevel *level = &tree->level[l], *below = &tree->level[l + 1];
  TreeMoments *nested = &level->nested;
  int n = below->n / CHILDREN;
  TRY(new_level(level, n, CHILDREN, error));
  level->n_points = CHILDREN * below->n_points;
  level->n_blocks = level->n_points / OSEEN_LANES;
  level->points = tree->lined_points;
  TRY(ARRAY_NEW(&nested->clear, n, error));
  TRY(ARRAY_NEW(&nested->far2, n, error));
  TRY(ARRAY_NEW(&nested->run, n, error));
  for (int k = 0; k < n; k++) {
    nested->run[k][0] = (OseenRun){&level->points[(size_t)k * level->n_blocks], level->n_blocks};
  }
  if (tree->scheme.far == 0) goto cleanup;
  nested->n_sources = l + 1 == tree->element_level ? tree->rule.n : LATTICE_NODES;
  TRY(ARRAY_NEW(&nested->roughness, n, error));
  nested->moments = *free;
  *free += (size_t)n * LATTICE_BLOCKS;
  TRY(ARRAY_NEW(&nested->lattice, n, error));
  TRY(ARRAY_NEW(&nested->weight, (size_t)n * CHILDREN * nested->n_sources, error));
  for (int k = 0; k < n; k++) {
    nested->run[k][1] = (OseenRun){&nested->moments[k * LATTICE_BLOCKS], LATTICE_BLOCKS};
    TRY(new_lattice(tree, l, k, error));
  }
cleanup:
  return status;
}

static Status new_piece_level(SurfaceTree *tree, int l, Error *error) {
  Status status = STATUS_OK;
  TreeLevel *level = &tree->level[l];
  int depth = l - tree->element_level, n = tree->mesh->n_elements << depth;
  TRY(new_level(level, n, depth == 0 ? CHILDREN : CHILDREN_OF_PIECE, error));
  level->n_points = tree->rule.n;
  level->n_blocks = tree->rule.n_blocks;
  if (depth == 0) {
    level->points = tree->blocks;
  } else {
    TRY(ARRAY_NEW(&level->points, (size_t)n * level->n_blocks, error));
  }
cleanup:
  return status;
}

static int count_nested(const SurfaceTree *tree) {
  int sum = 0, n = tree->mesh->n_elements;
  for (int l = tree->element_level - 1; l >= 0; l--) sum += n /= CHILDREN;
  return sum;
}

Status tree_new(SurfaceTree *tree, const Mesh *mesh, const TreeScheme *scheme, Error *error) {
  Status status = STATUS_OK;
  *tree = (SurfaceTree){.mesh = mesh, .scheme = *scheme};
  for (int n = mesh->n_elements / CHILDREN; n >= FEWEST_ON_TOP; n /= CHILDREN) tree->element_level++;
  tree->n_levels = tree->element_level + 1 + (scheme->reach > 0 ? TREE_BISECTIONS : 0);
  piece_rule(&tree->rule, scheme->rule_points);
  const int of_elements = mesh->n_elements * tree->rule.n_blocks;
  const int lined = mesh->n_elements / CHILDREN * blocks_of_four(tree);
  tree->n_blocks = of_elements + lined + (scheme->far > 0 ? count_nested(tree) * LATTICE_BLOCKS : 0);
  TRY(ARRAY_NEW(&tree->blocks, tree->n_blocks, error));
  TRY(ARRAY_NEW(&tree->turned, mesh->n_elements, error));
  for (int e = 0; e < mesh->n_elements; e++) piece_turn(mesh->element[e], mesh->X, tree->turned[e]);
  tree->lined_points = tree->blocks + of_elements;
  OseenBlock *free = tree->lined_points + lined;
  for (int l = tree->element_level; l < tree->n_levels; l++) TRY(new_piece_level(tree, l, error));
  for (int l = tree->element_level - 1; l >= 0; l--) TRY(new_nested_level(tree, l, &free, error));
  tree->n_roots = tree->element_level > 0 ? tree->level[0].n : mesh->n_elements / CHILDREN;
  TRY(ARRAY_NEW(&tree->image, tree->n_roots, error));
cleanup:
  return status;
}

void tree_free(SurfaceTree *tree) {
  for (int l = 0; l < tree->n_levels; l++) {
    TreeLevel *level = &tree->level[l];
    for (int c = 0; c < 3; c++) array_free(level->center[c]);
    array_free(level->reach2);
    if (l > tree->element_level) array_free(level->points);
    array_free(level->nested.clear);
    array_free(level->nested.far2);
    array_free(level->nested.run);
    array_free(level->nested.roughness);
    array_free(level->nested.lattice);
    array_free(level->nested.weight);
  }
  array_free(tree->blocks);
  array_free(tree->image);
  array_free(tree->turned);
}

static void get_center(const TreeLevel *level, int k, double center[3]) {
  for (int c = 0; c < 3; c++) center[c] = level->center[c][k];
}

static void set_piece(SurfaceTree *tree, int l, int k, const Piece *piece) {
  TreeLevel *level = &tree->level[l];
  double center[3];
  level->reach2[k] = piece_reach2(piece, tree->scheme.reach, center);
  for (int c = 0; c < 3; c++) level->center[c][k] = center[c];
  piece_points(piece, &tree->rule, &level->points[(size_t)k * level->n_blocks]);
}

static void update_element(SurfaceTree *tree, int e, const double *x, const double *q) {
  Piece piece;
  piece_load(tree->turned[e], x, q, &piece);
  set_piece(tree, tree->element_level, e, &piece);
}

void tree_cut(SurfaceTree *tree, int e, const double *x, const double *q) {
  Piece piece[2][1 << TREE_BISECTIONS];
  piece_load(tree->turned[e], x, q, &piece[0][0]);
  for (int depth = 1; tree->element_level + depth < tree->n_levels; depth++) {
    Piece *above = piece[(depth + 1) % 2], *here = piece[depth % 2];
    for (int i = 0; i < 1 << depth; i += 2) piece_bisect(&above[i / 2], &here[i], &here[i + 1]);
    for (int i = 0; i < 1 << depth; i++) {
      set_piece(tree, tree->element_level + depth, (e << depth) + i, &here[i]);
    }
  }
}

/* The points of four elements, first to first + 3, without gaps. */
static void line_up(SurfaceTree *tree, int first) {
  const TreeLevel *elements = &tree->level[tree->element_level];
  OseenBlock *lined = &tree->lined_points[(size_t)first / CHILDREN * blocks_of_four(tree)];
  for (int i = 0; i < CHILDREN * tree->rule.n; i++) {
    int e = first + i / tree->rule.n, point = i % tree->rule.n;
    const OseenBlock *from = &elements->points[e * elements->n_blocks + point / OSEEN_LANES];
    OseenBlock *to = &lined[i / OSEEN_LANES];
    for (int c = 0; c < 3; c++) {
      to->y[c][i % OSEEN_LANES] = from->y[c][point % OSEEN_LANES];
      to->f[c][i % OSEEN_LANES] = from->f[c][point % OSEEN_LANES];
    }
  }
}

/* Distance from the centre of a child beyond which nothing inside is near, nor any node: an element around a
 * target is never taken as part of something larger, however bent. */
static double child_clear(const SurfaceTree *tree, int l, int k, const double *x) {
  const TreeLevel *level = &tree->level[l];
  if (l < tree->element_level) return level->nested.clear[k];
  double clear = sqrt(level->reach2[k]), center[3];
  get_center(level, k, center);
  for (int i = 0; i < 6; i++) {
    clear = fmax(clear, vec3_distance(center, x + 3 * tree->mesh->element[k][i]));
  }
  return clear;
}

/* Centre of nested triangle k, among those of its children, and from where it is clear of the target. */
static void update_sphere(SurfaceTree *tree, int l, int k, const double *x) {
  const double widen = 1 + 1e-12; /* a sphere about spheres, in spite of round-off */
  TreeLevel *level = &tree->level[l];
  const TreeLevel *below = &tree->level[l + 1];
  double center[3], child_center[3], clear = 0;
  for (int c = 0; c < 3; c++) {
    const double *four = &below->center[c][CHILDREN * k];
    level->center[c][k] = center[c] = 0.25 * (four[0] + four[1] + four[2] + four[3]);
  }
  for (int child = CHILDREN * k; child < CHILDREN * (k + 1); child++) {
    get_center(below, child, child_center);
    clear = fmax(clear, vec3_distance(center, child_center) + child_clear(tree, l + 1, child, x));
  }
  level->nested.clear[k] = widen * clear;
  level->reach2[k] = level->nested.clear[k] * level->nested.clear[k];
  level->nested.far2[k] = INFINITY;
}

/* Empty moments on the lattice; returns the largest distance of a lattice node from the centre. */
static double place_lattice(const int node[LATTICE_NODES], const double *x, const double center[3],
                            OseenBlock *moments) {
  double radius = 0;
  memset(moments, 0, LATTICE_BLOCKS * sizeof *moments);
  for (int k = 0; k < LATTICE_LANES; k++) {
    const double *position = x + 3 * node[k < LATTICE_NODES ? k : 0];
    for (int c = 0; c < 3; c++) moments[k / OSEEN_LANES].y[c][k % OSEEN_LANES] = position[c];
    radius = fmax(radius, vec3_distance(position, center));
  }
  return radius;
}

/* Moments of nested triangle k from its children's sources, and from where they will do. */
static void update_moments(SurfaceTree *tree, int l, int k, const double *x) {
  TreeLevel *level = &tree->level[l];
  TreeMoments *nested = &level->nested;
  const TreeLevel *below = &tree->level[l + 1];
  bool elements_below = l + 1 == tree->element_level;
  OseenBlock *moments = &nested->moments[k * LATTICE_BLOCKS];
  double center[3], own = 0, inherited = 0;
  get_center(level, k, center);
  double radius = place_lattice(nested->lattice[k], x, center, moments);
  for (int child = CHILDREN * k; child < CHILDREN * (k + 1); child++) {
    const OseenBlock *sources = elements_below ? &below->points[child * below->n_blocks]
                                               : &below->nested.moments[child * LATTICE_BLOCKS];
    const double(*weight)[LATTICE_LANES] =
        (const double(*)[LATTICE_LANES])(nested->weight + child * nested->n_sources);
    own = fmax(own, moment_add(weight, nested->n_sources, sources, moments));
    if (!elements_below) inherited = fmax(inherited, below->nested.roughness[child]);
  }
  nested->roughness[k] = sqrt(own) + inherited;
  double far = fmax(tree->scheme.far * radius, nested->roughness[k] / tree->scheme.rough);
  nested->far2[k] = fmax(far * far, level->reach2[k]);
  /* Targets too near for the moments take the points of four elements together, else the children's moments.
   */
  if (!elements_below) level->reach2[k] = nested->far2[k];
}

/* Nodes of a level that belong to one subtree. */
static int nodes_of_root(const SurfaceTree *tree, int l) {
  return tree->level[l].n / tree->n_roots;
}

static void update_root(SurfaceTree *tree, int root, const double *x, const double *q) {
  int n = nodes_of_root(tree, tree->element_level);
  for (int first = n * root; first < n * (root + 1); first += CHILDREN) {
    for (int i = 0; i < CHILDREN; i++) update_element(tree, first + i, x, q);
    line_up(tree, first);
  }
  for (int l = tree->element_level - 1; l >= 0; l--) {
    n = nodes_of_root(tree, l);
    for (int k = n * root; k < n * (root + 1); k++) {
      update_sphere(tree, l, k, x);
      if (tree->scheme.far > 0) update_moments(tree, l, k, x);
    }
  }
}

/* The root that all elements of `root` go onto, or -1: the roots of the icosahedron itself are no images. */
static int image_of_root(const SurfaceTree *tree, const SymmetryOperation *operation, int root) {
  const int n = nodes_of_root(tree, tree->element_level), image = operation->element[n * root] / n;
  for (int e = n * root; e < n * (root + 1); e++)
    if (operation->element[e] / n != image) return -1;
  return image;
}

void tree_use_symmetry(SurfaceTree *tree, const Symmetry *symmetry) {
  for (int root = 0; root < tree->n_roots; root++) {
    int least = root;
    for (int i = 0; i < symmetry->n_operations; i++) {
      const int image = image_of_root(tree, &symmetry->operation[i], root);
      if (image < 0 || image >= least) continue;
      tree->image[root] = &symmetry->operation[i];
      least = image;
    }
  }
}

static void reflect_node(const SurfaceTree *tree, int l, const double sign[3], int from, int to) {
  const TreeLevel *level = &tree->level[l];
  const TreeMoments *nested = &level->nested;
  for (int c = 0; c < 3; c++) level->center[c][to] = sign[c] * level->center[c][from];
  level->reach2[to] = level->reach2[from];
  if (l == tree->element_level) {
    oseen_reflect(sign, &level->points[from * level->n_blocks], level->n_blocks,
                  &level->points[to * level->n_blocks]);
    return;
  }
  nested->clear[to] = nested->clear[from];
  nested->far2[to] = nested->far2[from];
  if (tree->scheme.far == 0) return;
  nested->roughness[to] = nested->roughness[from];
  oseen_reflect(sign, &nested->moments[from * LATTICE_BLOCKS], LATTICE_BLOCKS,
                &nested->moments[to * LATTICE_BLOCKS]);
}

/* A node with all that is below it goes onto such a node: points and children may come in another order. */
static void reflect_root(SurfaceTree *tree, int root) {
  const SymmetryOperation *operation = tree->image[root];
  int n_fours = nodes_of_root(tree, tree->element_level) / CHILDREN, blocks = blocks_of_four(tree);
  for (int four = n_fours * root; four < n_fours * (root + 1); four++) {
    int from = operation->element[CHILDREN * four] / CHILDREN;
    oseen_reflect(operation->sign, &tree->lined_points[from * blocks], blocks,
                  &tree->lined_points[four * blocks]);
  }
  for (int l = tree->element_level; l >= 0; l--) {
    int n = nodes_of_root(tree, l), n_below = tree->level[tree->element_level].n / tree->level[l].n;
    for (int k = n * root; k < n * (root + 1); k++) {
      reflect_node(tree, l, operation->sign, operation->element[n_below * k] / n_below, k);
    }
  }
}

void tree_update(SurfaceTree *tree, const double *x, const double *q) {
#pragma omp parallel
  {
#pragma omp for schedule(dynamic, 1)
    for (int root = 0; root < tree->n_roots; root++) {
      if (!tree->image[root]) update_root(tree, root, x, q);
    }
#pragma omp for schedule(static)
    for (int root = 0; root < tree->n_roots; root++) {
      if (tree->image[root]) reflect_root(tree, root);
    }
  }
}
