#include <cstdlib>
#include <exception>
#include <iostream>

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "pipeline/base/documents/failure_text.h"
#include "pipeline/base/documents/printable_stream.h"
#include "pipeline/commands/cli.h"
#include "pipeline/commands/command_line.h"
#include "pipeline/commands/standard_output.h"
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

/// Of a failure that nobody could catch: one line, and no trace of the stack.
[[noreturn]] void end_at_once() {
  try {
    if (const std::exception_ptr failure = std::current_exception())
      std::rethrow_exception(failure);
  } catch (const std::exception& failure) {
    std::cerr << "mien: " << mien::pipeline::failure_text(failure) << '\n';
  } catch (...) {
    std::cerr << "mien: it failed, and nothing says why\n";
  }
  std::_Exit(mien::pipeline::exit_failed);
}

}  // namespace

int main(int argc, char** argv) {
  using mien::pipeline::PrintableStream, mien::pipeline::StreamReader;
  give_back_pictures();
  std::set_terminate(end_at_once);
  mien::pipeline::keep_standard_streams_open();
  const mien::pipeline::SignalWatch signals;
  mien::pipeline::StandardOutput output;
  PrintableStream err(std::cerr, StreamReader::terminal);
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  int code = mien::pipeline::exit_failed;
  {
    PrintableStream out(output.stream(), isatty(STDOUT_FILENO) != 0 ? StreamReader::terminal
                                                                    : StreamReader::program);
    code = mien::pipeline::run_command_line(mien::pipeline::mien_program(), argc, argv,
                                            {out, err, is_terminal, signals.token()});
  }  // what it still held is passed on
  return output.finish(code, err);
}
