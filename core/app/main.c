/* The program: picks the subcommand. */
#include <stdio.h>

int main(int argc, char **argv) {
  (void)argc;
  (void)argv;
  puts("capsella " CAPSELLA_VERSION);
  return 0;
}
