#include "observe/palette.h"

#include <math.h>

/* At 0, 0.1, ... 1. */
static const unsigned char viridis[11][3] = {{68, 1, 84},    {72, 36, 117},  {65, 68, 135},  {53, 95, 141},
                                             {42, 120, 142}, {33, 145, 140}, {34, 168, 132}, {68, 191, 112},
                                             {122, 209, 81}, {189, 223, 38}, {253, 231, 37}};

void palette_color(double fraction, double rgb[3]) {
  const double place = 10 * fmin(fmax(fraction, 0), 1);
  const int k = place < 9 ? (int)place : 9;
  for (int c = 0; c < 3; c++) rgb[c] = viridis[k][c] + (place - k) * (viridis[k + 1][c] - viridis[k][c]);
}

Status palette_gradient(const char *id, Text *svg, Error *error) {
  Status status;
  TRY(text_append(svg, error, "<linearGradient id=\"%s\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">\n", id));
  for (int k = 0; k <= 10; k++)
    TRY(text_append(svg, error, "<stop offset=\"%g\" stop-color=\"#%02x%02x%02x\"/>\n", 0.1 * k,
                    viridis[k][0], viridis[k][1], viridis[k][2]));
  TRY(text_append(svg, error, "</linearGradient>\n"));
cleanup:
  return status;
}
