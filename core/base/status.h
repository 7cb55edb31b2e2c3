/* Status codes and messages: how every function of the library that can fail says so.
 *
 * A function that can fail returns a Status and takes an `Error *` as its last argument; the caller owns the
 * Error and reads it only when the status is not STATUS_OK.  The library never prints, exits or aborts.
 * Messages say what was expected, what was found, and where. */
#ifndef CAPSELLA_BASE_STATUS_H
#define CAPSELLA_BASE_STATUS_H

typedef enum {
  STATUS_OK = 0,
  STATUS_REJECT =
      1, /* this trial cannot be used; a smaller step may do (inverted element, law out of domain) */
  STATUS_FAILED = -1, /* the computation failed: exit code 1 */
  STATUS_INPUT = -2,  /* the input is wrong: exit code 2 */
  STATUS_IO = -3,     /* a file could not be read or written: exit code 1 */
  STATUS_MEMORY = -4, /* out of memory: exit code 1 */
} Status;

typedef struct {
  Status code;
  char text[2048]; /* UTF-8, no trailing newline; may hold several lines */
} Error;

#if defined(__GNUC__)
#define PRINTF_LIKE(text, first) __attribute__((format(printf, text, first)))
#else
#define PRINTF_LIKE(text, first)
#endif

/* Stores code and message; returns `code`, so that a failing function can end with `return error_set(...)`.
 */
Status error_set(Error *error, Status code, const char *format, ...) PRINTF_LIKE(3, 4);

/* Puts context in front of the message ("scene.yaml:3:5: "); returns the code already stored. */
Status error_prefix(Error *error, const char *format, ...) PRINTF_LIKE(2, 3);

/* clang's analyzer sees one file at a time, and is told here that what fails never says STATUS_OK. */
#ifdef __clang_analyzer__
#define error_set(error, code, ...) (error_set(error, code, __VA_ARGS__), (Status)(code))
#define error_prefix(error, ...)    (error_prefix(error, __VA_ARGS__), STATUS_FAILED)
#endif

/* Runs EXPR; on failure jumps to the function's `cleanup:` label with `status` set. */
#define TRY(expr)                                                                                            \
  do {                                                                                                       \
    status = (expr);                                                                                         \
    if (status != STATUS_OK) goto cleanup;                                                                   \
  } while (0)

#endif
