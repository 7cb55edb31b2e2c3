/* Materials for tests without a scene file: a Scene with only the membrane filled in. */
#ifndef CAPSELLA_TESTS_LAW_SCENE_H
#define CAPSELLA_TESTS_LAW_SCENE_H

#include "laws/material.h"
#include <check.h>

#define PLUGINS BUILD_DIR "/plugins"
#define BROKEN  BUILD_DIR "/tests/broken"

/* The folders of the laws that ship and of the fixtures. */
static inline LawSearch test_search(void) {
  static char plugins[] = PLUGINS, broken[] = BROKEN;
  static char *folders[] = {plugins, broken};
  return (LawSearch){.folder = folders, .n = 2};
}

static const LawScales NO_SCALES = {1.0, 1.0, 1.0};

/* A parameter without unit, on line 7 of a file that does not exist. */
static inline SceneParameter number(const char *name, double value) {
  return (SceneParameter){(char *)(uintptr_t)name, {.value = value}, {"scene.yaml", 7, 20}, NULL};
}

static inline SceneLaw scene_law(const char *law, SceneParameter *parameters, size_t n) {
  return (SceneLaw){(char *)(uintptr_t)law, {"scene.yaml", 5, 8}, parameters, n};
}

static inline Status try_material(Material *material, SceneLaw elastic, SceneLaw damage, Error *error) {
  const LawSearch search = test_search();
  Scene scene = {0};
  scene.membrane.elastic = elastic;
  scene.membrane.damage = damage;
  scene.membrane.d_max = 1.0;
  return material_new(material, &scene, &search, &NO_SCALES, NULL, NULL, error);
}

/* A material that must come about. */
static inline Material make_material(SceneLaw elastic, SceneLaw damage) {
  Material material;
  Error error;
  const Status status = try_material(&material, elastic, damage, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return material;
}

#endif
