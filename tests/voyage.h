/* A run of the library without its loop: the simulation of a scene and its record, at their start. */
#ifndef CAPSELLA_TESTS_VOYAGE_H
#define CAPSELLA_TESTS_VOYAGE_H

#include "run/record.h"
#include <check.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  Scene scene;
  Simulation simulation;
  Record record;
} Voyage;

static inline void voyage_open(Voyage *v, const char *text) {
  Error error;
  setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1);
  ck_assert_int_eq(scene_read_text(&v->scene, "scene.yaml", text, strlen(text), NULL, 0, &error), STATUS_OK);
  ck_assert_int_eq(simulation_new(&v->simulation, &v->scene, NULL, &error), STATUS_OK);
  ck_assert_int_eq(record_new(&v->record, &v->simulation, &error), STATUS_OK);
  ck_assert_int_eq(simulation_start(&v->simulation, &error), STATUS_OK);
  ck_assert_int_eq(record_begin(&v->record, false, &error), STATUS_OK);
}

static inline void voyage_close(Voyage *v) {
  record_free(&v->record);
  simulation_free(&v->simulation);
  scene_free(&v->scene);
}

#endif
