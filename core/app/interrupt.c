#include "app/interrupt.h"

#include <signal.h>
#include <stddef.h>

static volatile int interrupted;

static void interrupt(int signal_number) {
  (void)signal_number;
  interrupted = 1;
}

const volatile int *interrupt_flag(void) {
  return &interrupted;
}

void interrupt_catch(void) {
  struct sigaction action = {.sa_flags = (int)SA_RESETHAND};
  action.sa_handler = interrupt;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
}
