#include "app/guard.h"

#include "app/commands.h"
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static LawWatch watch[LAW_WATCHES];
static unsigned longest, waited;

static void say(const char *text, size_t length) {
  if (write(STDERR_FILENO, text, length) < 0) return; /* nobody is left to tell */
}

/* One line for each law that is being called; how many there are. */
static int name_laws(const char *what) {
  int laws = 0;
  for (int k = 0; k < LAW_WATCHES; k++) {
    const char *law = atomic_load(&watch[k].law);
    if (!law) continue;
    char line[256];
    const int length =
        snprintf(line, sizeof line,
                 "law %s %s at t = %.6g, element %d; the last snapshot is whole: mend the law and go "
                 "on with --resume\n",
                 law, what, atomic_load(&watch[k].t), atomic_load(&watch[k].element));
    if (length > 0) say(line, (size_t)length < sizeof line ? (size_t)length : sizeof line - 1);
    laws++;
  }
  return laws;
}

/* A crash outside of laws is one of ours, and ends the process as usual. */
static void crashed(int number) {
  char what[64];
  snprintf(what, sizeof what, "crashed (signal %d)", number);
  if (name_laws(what) > 0) _exit(EXIT_FAILED);
  raise(number);
}

/* Once a second: has any law been called for too long? */
static void look(int number) {
  static unsigned calls_before;
  (void)number;
  unsigned calls = 0;
  int laws = 0;
  for (int k = 0; k < LAW_WATCHES; k++) {
    calls += atomic_load(&watch[k].calls);
    laws += atomic_load(&watch[k].law) != NULL;
  }
  waited = laws > 0 && calls == calls_before ? waited + 1 : 0;
  calls_before = calls;
  if (waited >= longest) {
    char what[64];
    snprintf(what, sizeof what, "has not come back for %u s", waited);
    name_laws(what);
    _exit(EXIT_FAILED);
  }
  alarm(1);
}

LawWatch *guard_laws(unsigned seconds) {
  static const int CRASHES[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};
  struct sigaction crash = {.sa_flags = (int)SA_RESETHAND}, tick = {.sa_flags = SA_RESTART};
  crash.sa_handler = crashed;
  tick.sa_handler = look;
  sigemptyset(&crash.sa_mask);
  sigemptyset(&tick.sa_mask);
  for (size_t k = 0; k < sizeof CRASHES / sizeof *CRASHES; k++) sigaction(CRASHES[k], &crash, NULL);
  longest = seconds;
  if (seconds > 0 && sigaction(SIGALRM, &tick, NULL) == 0) alarm(1);
  return watch;
}
