/* Full packs go through the same kernel as the far points. */
#include "fluid/pack.h"

void pack_start(PointPack *pack) {
  pack->n = 0;
  for (int c = 0; c < 3; c++) {
    pack->u[c] = 0;
    pack->points.y[c] = pack->place[c];
    pack->points.f[c] = pack->place[c + 3];
  }
}

void pack_flush(PointPack *pack) {
  oseen_sum(&pack->points, 0, pack->n, (const double[3]){0, 0, 0}, pack->u);
  pack->n = 0;
}

void pack_reserve(PointPack *pack, int n) {
  if (pack->n + n > PACK_CAPACITY) pack_flush(pack);
}
