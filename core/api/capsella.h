/* libcapsella: a capsule in a flow, computed inside another program.
 *
 *   Capsella *c = capsella_new();
 *   capsella_set(c, "flow.capillary_number", "0.5");
 *   if (capsella_open_file(c, "scene.yaml") != CAPSELLA_OK) puts(capsella_error(c));
 *   while (capsella_state(c) == CAPSELLA_RUNNING && capsella_step(c) == CAPSELLA_OK) ...;
 *   capsella_free(c);
 *
 * A handle is one computation from its scene to its end.  Nothing is printed, no file is written, the process
 * is never ended, and no two handles share anything: each may live in a thread of its own, but one handle
 * serves one thread at a time.  A computation uses as many OpenMP threads as the thread that calls may start
 * (omp_set_num_threads, OMP_NUM_THREADS), and its numbers do not depend on how many.
 *
 * Everything is dimensionless: lengths by the radius a, times by 1/rate, tensions and energies per area by
 * the shear modulus G_s.  Texts are UTF-8, ended by NUL, and are the library's: one that a handle gives is
 * valid until the next call with that handle, a name for ever.  A handle must not be NULL, but where that is
 * said.
 *
 * Functions and enumerators are only ever added, with a rise of CAPSELLA_API_MINOR; a caller must expect
 * values of the two enumerations that it does not know. */
#ifndef CAPSELLA_H
#define CAPSELLA_H

#include <stddef.h>

#define CAPSELLA_API_MAJOR 1
#define CAPSELLA_API_MINOR 0

#if defined(__GNUC__)
#define CAPSELLA_API __attribute__((visibility("default")))
#else
#define CAPSELLA_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What a call came to; capsella_error has the words. */
typedef enum {
  CAPSELLA_OK = 0,
  CAPSELLA_FAILED = -1, /* the computation cannot go on */
  CAPSELLA_INPUT = -2,  /* the scene is wrong or missing, or a law or file that it names */
  CAPSELLA_IO = -3,     /* the system failed at a file or a process */
  CAPSELLA_MEMORY = -4, /* out of memory */
  CAPSELLA_USAGE =
      -5 /* the call does not suit the handle: unknown name, array too short, not open yet, ... */
} CapsellaStatus;

/* Where a computation stands. */
typedef enum {
  CAPSELLA_CLOSED = 0,   /* no scene has been opened */
  CAPSELLA_RUNNING = 1,  /* a step may be taken */
  CAPSELLA_END = 2,      /* over: time.end has been reached */
  CAPSELLA_STEADY = 3,   /* over: the rates are below stop.steady */
  CAPSELLA_RUPTURED = 4, /* over: d has reached 1, with stop.rupture: stop */
  CAPSELLA_BROKEN = 5    /* a step has failed; the last good state can be read */
} CapsellaState;

typedef struct Capsella Capsella;

/* The version of the library, "0.1.0". */
CAPSELLA_API const char *capsella_version(void);

/* A handle without a scene; NULL when out of memory. */
CAPSELLA_API Capsella *capsella_new(void);

/* NULL is allowed. */
CAPSELLA_API void capsella_free(Capsella *capsella);

/* A key of the scene to be opened: "flow.capillary_number" and a piece of YAML, as `--set KEY=VALUE` of the
 * program.  It replaces what the scene says; an empty value removes the key.  Later ones win.  A mistake in
 * key or value is found on opening.  USAGE: a scene is open. */
CAPSELLA_API CapsellaStatus capsella_set(Capsella *capsella, const char *key, const char *value);

/* Reads the scene from a file, loads its laws and brings the capsule to its start, with everything that a run
 * of the program would refuse refused; keys that tell where and when to write (`output`) do nothing.  Laws
 * are looked for beside the scene, in MLAW_PLUGIN_PATH, and where the library is installed.  A law from
 * elsewhere than there is first tried in processes of its own (fork) unless the scene has
 * membrane.check_laws: false. After a failure the handle is still without a scene, and another may be opened.
 * INPUT ("file:line:column: expected ..., found ..."), IO, MEMORY, FAILED; USAGE: a scene is open already. */
CAPSELLA_API CapsellaStatus capsella_open_file(Capsella *capsella, const char *path);

/* The same for a scene in memory, YAML that ends with NUL.  `name` stands for the file in messages, and laws
 * and files that the scene names are looked for in its folder. */
CAPSELLA_API CapsellaStatus capsella_open_text(Capsella *capsella, const char *name, const char *text);

/* One step of the size that accuracy and stability allow (or time.step), to time.end at the latest.  A
 * computation that is over stays as it is, which is OK.  FAILED, MEMORY: the computation is BROKEN, and so it
 * answers to every further call.  USAGE: no scene is open. */
CAPSELLA_API CapsellaStatus capsella_step(Capsella *capsella);

/* Steps until time t, where the last step ends exactly, or until the computation is over; a time that has
 * passed does nothing.  As capsella_step; USAGE also when t is not a number. */
CAPSELLA_API CapsellaStatus capsella_advance(Capsella *capsella, double t);

CAPSELLA_API CapsellaState capsella_state(const Capsella *capsella);

/* Time of the current state, in 1/rate; 0 without a scene. */
CAPSELLA_API double capsella_time(const Capsella *capsella);

/* What went wrong in the last call that failed; "" when none has.  NULL is allowed: out of memory. */
CAPSELLA_API const char *capsella_error(const Capsella *capsella);

/* Notes and warnings so far, one a line ("warning: ..."): parameters outside their calibrated range, steps
 * beyond the stability limit, rupture. */
CAPSELLA_API const char *capsella_log(const Capsella *capsella);

/* A figure of the current state by its name (docs/embedding.md), NaN where it has no meaning: a column of
 * history.csv (t, D12, beta, L1, ..., d_max, T1_max, ...), or one of capsella_scalar_name's others.
 * USAGE: no scene is open, or no such name (the nearest is told).  FAILED: the shape cannot be measured. */
CAPSELLA_API CapsellaStatus capsella_scalar(Capsella *capsella, const char *name, double *value);

/* The names that capsella_scalar knows, from 0 on; NULL from the first index that is none. */
CAPSELLA_API const char *capsella_scalar_name(size_t index);

/* A field at the nodes, copied to values[capacity]: [n_nodes][3] for X (at rest), x, velocity and q (the
 * load of the fluid on the membrane, by G_s/a), [n_nodes] for d, Y, T1 and T2.  `count` (may be NULL)
 * receives how many numbers that is; with values NULL nothing is copied.  USAGE: no scene is open, no such
 * name, or capacity < count. */
CAPSELLA_API CapsellaStatus capsella_field(Capsella *capsella, const char *name, double *values,
                                           size_t capacity, size_t *count);

/* The names that capsella_field knows, as capsella_scalar_name. */
CAPSELLA_API const char *capsella_field_name(size_t index);

/* The elements, [n_elements][6] indices of nodes from 0 on, the same throughout: corners a b c, which wind
 * outward, then the middles of ab, bc and ca.  `nodes`, `capacity` and `count` as values of capsella_field.
 */
CAPSELLA_API CapsellaStatus capsella_elements(Capsella *capsella, int *nodes, size_t capacity, size_t *count);

#ifdef __cplusplus
}
#endif

#endif
