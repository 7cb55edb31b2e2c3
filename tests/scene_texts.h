/* Pieces that tests put scenes together from. */
#ifndef CAPSELLA_TESTS_SCENE_TEXTS_H
#define CAPSELLA_TESTS_SCENE_TEXTS_H

/* The lines are counted by tests of refusals. */
#define MEMBRANE                                                                                             \
  "schema: 1\n"                                                                                              \
  "membrane:\n"                                                                                              \
  "  law: neo_hookean\n"                                                                                     \
  "  parameters: {G_s: 1.0}\n"
#define SHEAR                                                                                                \
  "flow:\n"                                                                                                  \
  "  kind: simple_shear\n"                                                                                   \
  "  capillary_number: 0.7\n"
#define END "time: {end: 10}\n"
#define PHYSICAL                                                                                             \
  "flow:\n"                                                                                                  \
  "  kind: simple_shear\n"                                                                                   \
  "  physical: {radius: 35 um, viscosity: 1 mPa.s, shear_rate: 20 1/s, shear_modulus: 0.05 N/m}\n"
#define LINEAR(gradient)                                                                                     \
  MEMBRANE "flow:\n  kind: linear\n  capillary_number: 1\n  gradient: " gradient "\n" END
#define PATH(path) MEMBRANE "flow:\n  kind: inflation\n  path: " path "\n" END

#endif
