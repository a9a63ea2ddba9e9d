#include <iostream>

#include <unistd.h>

#include "pipeline/commands/cli.h"
#include "pipeline/tasks/interruption.h"

int main(int argc, char** argv) {
  const mien::pipeline::SignalWatch signals;
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  return mien::pipeline::run_command_line(argc, argv,
                                          {std::cout, std::cerr, is_terminal, signals.token()});
}
