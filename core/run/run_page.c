/* The data of a run's page: its files as they are, and its snapshots. */
#include "run/run_page.h"

#include "base/file.h"
#include "config/scene.h"
#include "observe/page.h"
#include "run/page_surfaces.h"
#include <string.h>

enum { MAX_ROWS = 4000 };

/* Header, every n-th row and the last, so that there are at most MAX_ROWS or so. */
static Status thin_rows(const Text *csv, Text *thinned, Error *error) {
  Status status = STATUS_OK;
  size_t rows = 0, row = 0;
  for (size_t k = 0; k < csv->length; k++) rows += csv->data[k] == '\n';
  const size_t every = rows / MAX_ROWS + 1;
  for (const char *line = csv->data, *end; line && (end = strchr(line, '\n')); line = end + 1, row++)
    if (row == 0 || row % every == 1 % every || row + 1 == rows)
      TRY(text_append_bytes(thinned, error, line, (size_t)(end + 1 - line)));
cleanup:
  return status;
}

static Status put_history(Page *page) {
  Status status = STATUS_OK;
  Text csv = {0}, thinned = {0};
  TRY(page_read(page, "history.csv", &csv));
  if (csv.data) TRY(thin_rows(&csv, &thinned, page->error));
  json_string(&page->json, "history", thinned.data ? thinned.data : "");
cleanup:
  text_free(&csv);
  text_free(&thinned);
  return status;
}

static double capillary_number(const Scene *scene) {
  if (!scene->flow.is_physical) return scene->flow.capillary_number;
  return scene->flow.viscosity.value * scene->flow.shear_rate.value * scene->flow.radius.value /
         scene->flow.shear_modulus.value;
}

static void put_scene(Json *json, const Scene *scene, const char *resolved) {
  static const char *const flows[] = {[FLOW_SIMPLE_SHEAR] = "simple_shear",
                                      [FLOW_PLANAR_HYPERBOLIC] = "planar_hyperbolic",
                                      [FLOW_UNIAXIAL_EXTENSION] = "uniaxial_extension",
                                      [FLOW_LINEAR] = "linear",
                                      [FLOW_INFLATION] = "inflation"};
  json_string(json, "name", scene->name);
  json_open_object(json, "scene");
  json_string(json, "flow", flows[scene->flow.kind]);
  if (scene->flow.kind == FLOW_INFLATION)
    json_null(json, "capillary_number");
  else
    json_number(json, "capillary_number", capillary_number(scene));
  json_numbers(json, "gradient", scene->flow.gradient[0], 9);
  json_string(json, "elastic", scene->membrane.elastic.law);
  json_string(json, "damage", scene->membrane.has_damage ? scene->membrane.damage.law : NULL);
  json_close(json);
  json_string(json, "resolved", resolved);
}

Status run_page_write(const char *folder, Log *log, Error *error) {
  Status status = STATUS_OK;
  Page page;
  Scene scene = {0};
  Text path = {0}, resolved = {0};
  page_begin(&page, "run", folder, error);
  TRY(file_join(&path, folder, "resolved.yaml", error));
  TRY(scene_read(&scene, path.data, NULL, 0, error));
  TRY(page_read(&page, "resolved.yaml", &resolved));
  put_scene(&page.json, &scene, resolved.data);
  TRY(page_put_json(&page, "summary", "summary.json"));
  TRY(put_history(&page));
  TRY(page_put_text(&page, "criteria", "criteria.csv"));
  TRY(page_put_snapshots(&page, &scene, log));
  TRY(page_end(&page));
cleanup:
  page_free(&page);
  scene_free(&scene);
  text_free(&path);
  text_free(&resolved);
  return status;
}
