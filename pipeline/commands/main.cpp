#include <iostream>

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "pipeline/commands/cli.h"
#include "pipeline/tasks/interruption.h"

namespace {

/// Pictures of full size go back to the system when they are freed. By itself the allocator would
/// keep them from the first one on, and cut them up for what is smaller.
void give_back_pictures() {
#ifdef __GLIBC__
  constexpr int picture_bytes = 4 << 20;
  mallopt(M_MMAP_THRESHOLD, picture_bytes);
  mallopt(M_TRIM_THRESHOLD, 2 * picture_bytes);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  give_back_pictures();
  const mien::pipeline::SignalWatch signals;
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  return mien::pipeline::run_command_line(argc, argv,
                                          {std::cout, std::cerr, is_terminal, signals.token()});
}
