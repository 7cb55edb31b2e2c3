/* VECTOR_CLONES in front of a function: the compiler makes one copy for each instruction set, and the loader
 * takes the best that the machine has.  Only where gcc can do this; elsewhere one portable copy. */
#ifndef CAPSELLA_BASE_VECTOR_CLONES_H
#define CAPSELLA_BASE_VECTOR_CLONES_H

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__)
#define VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define VECTOR_CLONES
#endif

#endif
