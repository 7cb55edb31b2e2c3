#include "run/simulation.h"

#include "base/array.h"
#include "base/file.h"
#include "base/random.h"
#include "laws/conformance.h"
#include "mesh/surface.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool simulation_is_inflation(const Simulation *s) {
  return s->scene->flow.kind == FLOW_INFLATION;
}

/* Notes what is not set up, and why. */
static void skip(Simulation *s, const char *what, ...) PRINTF_LIKE(2, 3);
static void skip(Simulation *s, const char *what, ...) {
  if (s->n_skipped == MAX_SKIPPED) return;
  char *line = s->skipped_text[s->n_skipped];
  va_list arguments;
  va_start(arguments, what);
  vsnprintf(line, sizeof s->skipped_text[0], what, arguments);
  va_end(arguments);
  s->skipped[s->n_skipped++] = line;
}

/* Lengths by a, time by 1/rate, tensions by G: a mass is G / rate^2. */
static void derive_scales(Simulation *s) {
  Scene *scene = s->scene;
  s->scales = (LawScales){1, 1, 1};
  if (!scene->flow.is_physical) return;
  const double rate = scene->flow.shear_rate.value, modulus = scene->flow.shear_modulus.value;
  s->scales.length = scene->flow.radius.value;
  s->scales.time = 1 / rate;
  s->scales.mass = modulus / (rate * rate);
  scene->flow.capillary_number = scene->flow.viscosity.value * rate * scene->flow.radius.value / modulus;
}

/* A law asked for by a relative path is written into resolved.yaml by the path that was opened, so that the
 * resolved scene runs from any folder. */
static Status keep_opened_path(SceneLaw *law, const LoadedLaw *loaded, Error *error) {
  if (!law->law || !strchr(law->law, '/')) return STATUS_OK;
  Text path = {0};
  Status status = STATUS_OK;
  const char *id = strchr(law->law, '#');
  TRY(text_append(&path, error, "%s%s", loaded->file, id ? id : ""));
  array_free(law->law);
  law->law = text_copy(path.data, error);
  if (!law->law) status = error->code;
cleanup:
  text_free(&path);
  return status;
}

static Status pin_fields(SceneLaw *law, const char *folder, Error *error) {
  Status status = STATUS_OK;
  for (size_t i = 0; i < law->n_parameters && status == STATUS_OK; i++)
    if (law->parameters[i].field) status = field_pin(law->parameters[i].field, folder, error);
  return status;
}

static Status load_criteria(Simulation *s, const LawSearch *search, const FieldPlace *place,
                            const char *folder, Log *log, Error *error) {
  Status status = STATUS_OK;
  SceneCriterion *criteria = s->scene->observe.criteria;
  const size_t n = s->scene->observe.n_criteria;
  if (n > 0) TRY(ARRAY_NEW(&s->criterion, n, error));
  for (; s->n_criteria < n; s->n_criteria++) {
    Material *criterion = &s->criterion[s->n_criteria];
    SceneLaw *law = &criteria[s->n_criteria].law;
    TRY(pin_fields(law, folder, error));
    TRY(material_criterion(criterion, s->scene, law, search, &s->scales, place, log, error));
    TRY(keep_opened_path(law, &criterion->damage, error));
  }
cleanup:
  return status;
}

static Status load_laws(Simulation *s, Log *log, Error *error) {
  Status status = STATUS_OK;
  LawSearch search = {0};
  Text folder = {0};
  FieldPlace place = {.mesh = &s->mesh};
  memcpy(place.P, s->flow.vorticity_axis, sizeof place.P);
  TRY(file_folder(&folder, s->scene->file, error));
  TRY(law_search_default(&search, folder.data, error));
  if (s->scene->membrane.check_laws) search.admit = conformance_admit;
  TRY(pin_fields(&s->scene->membrane.elastic, folder.data, error));
  TRY(pin_fields(&s->scene->membrane.damage, folder.data, error));
  TRY(material_new(&s->material, s->scene, &search, &s->scales, &place, log, error));
  TRY(keep_opened_path(&s->scene->membrane.elastic, &s->material.elastic, error));
  TRY(keep_opened_path(&s->scene->membrane.damage, &s->material.damage, error));
  TRY(load_criteria(s, &search, &place, folder.data, log, error));
  if (!material_has_damage(&s->material)) skip(s, "damage: the scene names no damage law");
cleanup:
  text_free(&folder);
  law_search_free(&search);
  return status;
}

/* Leaves the symmetries that the values of a law's parameters have. */
static Status keep_symmetric_values(Simulation *s, const LoadedLaw *law, const ParameterValues *values,
                                    Error *error) {
  Status status = STATUS_OK;
  for (uint32_t k = 0; k < values->n; k++) {
    const int before = s->symmetry.n_operations;
    if (!values->element[k]) continue;
    TRY(symmetry_keep_field(&s->symmetry, &s->mesh, values->element[k], error));
    if (s->symmetry.n_operations < before) {
      const LawDescription table = law_describe(law);
      skip(s, "%d of %d symmetries of mesh and flow: the values of %s of law %s do not have them",
           before - s->symmetry.n_operations, before, law_param(&table, k)->name, table.id);
    }
  }
cleanup:
  return status;
}

/* The group of mesh, motion and parameters.  It holds since all laws are isotropic. */
static Status find_symmetry(Simulation *s, Error *error) {
  Status status = STATUS_OK;
  if (s->scene->symmetry == SYMMETRY_OFF) {
    TRY(symmetry_none(&s->symmetry, &s->mesh, error));
    goto cleanup;
  }
  /* An ellipsoid along the axes has the symmetries of the sphere, and noise has none. */
  const double(*gradient)[3] = (const double(*)[3])s->scene->flow.gradient;
  TRY(symmetry_find(&s->symmetry, &s->mesh, s->start, simulation_is_inflation(s) ? NULL : gradient, error));
  TRY(keep_symmetric_values(s, &s->material.elastic, &s->material.elastic_values, error));
  TRY(keep_symmetric_values(s, &s->material.damage, &s->material.damage_values, error));
  for (size_t i = 0; i < s->n_criteria; i++)
    TRY(keep_symmetric_values(s, &s->criterion[i].damage, &s->criterion[i].damage_values, error));
  if (s->symmetry.n_operations > 1)
    skip(s, "%d of %d elements and %d of %d nodes: they are images of the others under %d symmetries",
         s->mesh.n_elements - s->symmetry.elements.n, s->mesh.n_elements,
         s->mesh.n_nodes - s->symmetry.nodes.n, s->mesh.n_nodes, s->symmetry.n_operations);
  const Orbits *elements = &s->symmetry.elements;
  material_keep_elements(&s->material, elements->representative, elements->n);
  for (size_t i = 0; i < s->n_criteria; i++)
    material_keep_elements(&s->criterion[i], elements->representative, elements->n);
cleanup:
  return status;
}

static Status build_mesh(Simulation *s, Error *error) {
  Status status = STATUS_OK;
  MeshRotation rotation = {.angle = s->scene->mesh.rotation_angle};
  for (int c = 0; c < 3; c++) rotation.axis[c] = s->scene->mesh.rotation_axis[c];
  TRY(mesh_sphere(&s->mesh, s->scene->mesh.subdivisions, rotation.angle != 0 ? &rotation : NULL, error));
  if (s->scene->mesh.jitter > 0) mesh_jitter(&s->mesh, s->scene->mesh.jitter, s->scene->mesh.seed);
  s->area0 = surface_area(&s->mesh, NULL, s->mesh.X);
cleanup:
  return status;
}

/* The sphere at rest stretched to the axes of the start, and shaken. */
static Status shape_start(Simulation *s, Error *error) {
  const size_t n = 3 * (size_t)s->mesh.n_nodes;
  const double *axes = s->scene->start.axes, noise = s->scene->start.noise;
  const Status status = ARRAY_NEW(&s->start, n, error);
  if (status != STATUS_OK) return status;
  memcpy(s->start, s->mesh.X, n * sizeof *s->start);
  if (!simulation_is_inflation(s)) {
    uint64_t state = (uint64_t)s->scene->start.seed;
    for (size_t i = 0; i < n; i++) {
      state = random_mix(state);
      s->start[i] = axes[i % 3] * s->start[i] + noise * random_symmetric(state);
    }
  }
  s->volume0 = surface_volume(&s->mesh, s->start);
  return STATUS_OK;
}

/* An inflation has no vorticity axis; y stands in for it, as in simple shear. */
static void describe_flow(Simulation *s) {
  static const double Y_AXIS[3] = {0, 1, 0};
  if (simulation_is_inflation(s)) {
    memcpy(s->flow.vorticity_axis, Y_AXIS, sizeof Y_AXIS);
  } else {
    flow_linear(&s->flow, (const double(*)[3])s->scene->flow.gradient);
    s->flow.strength = (BrokenLine){(const double(*)[2])s->scene->flow.strength, s->scene->flow.n_strength};
    s->flow.period = s->scene->flow.period;
  }
}

static Status build_coarse_layer(Simulation *s, Error *error) {
  Status status = STATUS_OK;
  const Scene *scene = s->scene;
  const bool has_stages = scene->time.integrator != INTEGRATOR_RK2;
  if (!has_stages || !scene->coarse_stages || scene->fluid_method == FLUID_DIRECT) return STATUS_OK;
  TRY(coarse_layer_new(&s->coarse, &s->mesh, s->system.symmetry, error));
  TRY(system_use_coarse(&s->system, s->coarse, error));
cleanup:
  return status;
}

static Status build_fluid(Simulation *s, Error *error) {
  Status status = STATUS_OK;
  const Scene *scene = s->scene;
  TRY(single_layer_new(&s->layer, &s->mesh, scene->fluid_method, error));
  if (s->symmetry.n_operations > 1) single_layer_use_symmetry(s->layer, &s->symmetry);
  const double mobility = 1 / (scene->flow.capillary_number * s->material.shear_modulus);
  TRY(system_new(&s->system, &s->mesh, s->membrane, s->layer, &s->flow, mobility, scene->flow.remove_flux,
                 error));
  if (s->symmetry.n_operations > 1) s->system.symmetry = &s->symmetry;
  s->system.volume0 = s->volume0;
  TRY(build_coarse_layer(s, error));
  const StepperOptions options = {.integrator = scene->time.integrator,
                                  .is_auto = scene->time.step_is_auto,
                                  .fixed_step = scene->time.step,
                                  .tolerance = scene->time.tolerance,
                                  .allow_unstable = scene->time.allow_unstable};
  TRY(stepper_new(&s->stepper, system_rhs(&s->system), options, error));
  flow_motion(&s->carried, &s->system, &s->stepper);
  s->motion = &s->carried.base;
cleanup:
  return status;
}

Status simulation_load_laws(Simulation *s, Scene *scene, Log *log, Error *error) {
  Status status;
  *s = (Simulation){.scene = scene};
  derive_scales(s);
  describe_flow(s);
  TRY(build_mesh(s, error));
  TRY(load_laws(s, log, error));
cleanup:
  if (status != STATUS_OK) simulation_free(s);
  return status;
}

Status simulation_new(Simulation *s, Scene *scene, Log *log, Error *error) {
  Status status = STATUS_OK;
  TRY(simulation_load_laws(s, scene, log, error));
  TRY(shape_start(s, error));
  TRY(find_symmetry(s, error));
  const MembraneMethod method = {scene->membrane.mass_solver, scene->membrane.interpolation};
  TRY(membrane_new(&s->membrane, &s->mesh, &s->symmetry, &s->material, method, error));
  if (simulation_is_inflation(s)) {
    const double longest = scene->output.history_every > 0 ? scene->output.history_every : INFINITY;
    TRY(inflation_motion(&s->inflated, &s->mesh, s->membrane, (const double(*)[2])scene->flow.path,
                         scene->flow.n_path, longest, error));
    s->motion = &s->inflated.base;
    skip(s, "fluid: the radius is imposed, no flow is computed");
  } else {
    TRY(build_fluid(s, error));
  }
cleanup:
  if (status != STATUS_OK) simulation_free(s);
  return status;
}

void simulation_free(Simulation *s) {
  inflation_motion_free(&s->inflated);
  stepper_free(&s->stepper);
  system_free(&s->system);
  single_layer_free(s->layer);
  coarse_layer_free(s->coarse);
  membrane_free(s->membrane);
  symmetry_free(&s->symmetry);
  array_free(s->start);
  mesh_free(&s->mesh);
  for (size_t i = 0; i < s->n_criteria; i++) material_free(&s->criterion[i]);
  array_free(s->criterion);
  material_free(&s->material);
  *s = (Simulation){0};
}

Status simulation_start(Simulation *s, Error *error) {
  Status status = STATUS_OK;
  if (simulation_is_inflation(s)) return inflation_start(&s->inflated, error);
  /* What the start itself damages is there from the beginning, and no growth of the first step. */
  TRY(membrane_force(s->membrane, s->start, 0, 0, s->system.R, error));
  membrane_commit(s->membrane);
  TRY(stepper_start(&s->stepper, 0, s->start, error));
cleanup:
  return status;
}
