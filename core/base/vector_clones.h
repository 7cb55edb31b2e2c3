/* One plain loop, compiled for several instruction sets and chosen when the program starts.  Empty where the
 * compiler or a sanitizer does not go along with it. */
#ifndef CAPSELLA_BASE_VECTOR_CLONES_H
#define CAPSELLA_BASE_VECTOR_CLONES_H

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define VECTOR_CLONES
#endif

#endif
