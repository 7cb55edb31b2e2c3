/* A picture of the capsule as SVG: orthographic views of the curved surface coloured by a nodal field,
 * painted back to front, with a colour bar and axis arrows.  One file, no script, no font but the viewer's
 * own. */
#ifndef CAPSELLA_OBSERVE_PICTURE_H
#define CAPSELLA_OBSERVE_PICTURE_H

#include "base/status.h"
#include "base/text.h"
#include "mesh/mesh.h"
#include <stdbool.h>
#include <stddef.h>

/* An axis arrow, drawn in every view where it is not seen end-on. */
typedef struct {
  double direction[3];
  const char *label;
} PictureAxis;

typedef struct {
  double toward[3];  /* from the capsule to the eye, any length but zero */
  double up[3];      /* not along `toward` */
  const char *title; /* may be NULL */
  bool is_reference; /* of the capsule at rest: X in the place of x */
} PictureView;

/* A dot on the surface with a short label, drawn in every view on whose side it is; the labels of dots that
 * fall together stand beside one dot. */
typedef struct {
  double x[3], X[3]; /* X: in views of the capsule at rest */
  const char *label;
} PictureMark;

typedef struct {
  const Mesh *mesh;         /* of which only nodes and elements are looked at */
  const double *x;          /* [n_nodes][3] */
  const double *X;          /* [n_nodes][3]; NULL without a view of the capsule at rest */
  const double *field;      /* [n_nodes]; NULL: the plain surface, no colour bar */
  const char *label;        /* of the colour bar */
  double minimum, maximum;  /* of the colour bar; equal: the range of the field */
  const PictureView *views; /* side by side, same scale */
  size_t n_views;
  const PictureAxis *axes;
  size_t n_axes;
  const PictureMark *marks;
  size_t n_marks;
  bool marks_shine_through;  /* what is on the far side is drawn, too, faintly */
  const char *const *legend; /* lines of text right of the views */
  size_t n_legend;
} Picture;

/* For v = z e_x: the shear plane (x right, z up, seen from -y) and the view along the vorticity axis turned
 * by a quarter: seen from +z with x right and y up; and the arrows flow (e_x), gradient (e_z), vorticity
 * (e_y). */
extern const PictureView picture_shear_views[2];
extern const PictureAxis picture_shear_axes[3];

/* Appends a whole SVG document.  STATUS_INPUT: a view without direction, positions or field not finite. */
Status picture_print(const Picture *picture, Text *svg, Error *error);

#endif
