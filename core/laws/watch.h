/* Which law is being called: for a signal handler, or another thread, that has to tell of a law that crashes
 * or does not come back.  Each thread of a computation has a slot of its own; a NULL array is allowed and
 * records nothing. */
#ifndef CAPSELLA_LAWS_WATCH_H
#define CAPSELLA_LAWS_WATCH_H

#include <stdalign.h>
#include <stdatomic.h>
#include <stddef.h>

enum { LAW_WATCHES = 64 }; /* slots; a thread beyond them shares one */

typedef struct {
  alignas(64) _Atomic(const char *) law; /* being called; NULL: none */
  _Atomic double t;
  atomic_int element; /* first of the batch */
  atomic_uint calls;  /* so far: stands still while a law does not come back */
} LawWatch;

static inline void law_watch_enter(LawWatch *slot, const char *law, double t, int element) {
  if (!slot) return;
  atomic_store_explicit(&slot->t, t, memory_order_relaxed);
  atomic_store_explicit(&slot->element, element, memory_order_relaxed);
  atomic_fetch_add_explicit(&slot->calls, 1, memory_order_relaxed);
  atomic_store_explicit(&slot->law, law, memory_order_release);
}

static inline void law_watch_leave(LawWatch *slot) {
  if (slot) atomic_store_explicit(&slot->law, NULL, memory_order_release);
}

#endif
