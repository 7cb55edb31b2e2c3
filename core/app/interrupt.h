/* Ctrl-C and SIGTERM as a flag that long work looks at. */
#ifndef CAPSELLA_APP_INTERRUPT_H
#define CAPSELLA_APP_INTERRUPT_H

/* Set to non-zero by the first signal. */
const volatile int *interrupt_flag(void);

/* From now on the first signal only sets the flag; a second one ends the process as usual. */
void interrupt_catch(void);

#endif
