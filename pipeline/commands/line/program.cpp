#include "pipeline/commands/line/program.h"

#include <cstdlib>
#include <exception>
#include <iostream>

#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "pipeline/base/documents/failure_text.h"
#include "pipeline/base/documents/printable_stream.h"
#include "pipeline/commands/line/command_line.h"
#include "pipeline/commands/line/other_programs.h"
#include "pipeline/commands/line/standard_output.h"
#include "pipeline/tasks/interruption.h"

namespace mien::pipeline {

namespace {

constexpr char examples[] = R"(Examples:
  mien run quickstart                      make everything that a manifest asks for
  mien manifests quickstart > my.yaml      the same manifest, to begin your own with
  mien check my.yaml                       what is wrong with a manifest, if anything
  mien render walk.bvh                     a video of any motion file
  mien motion info walk.bvh                what is in a motion file
)";

/// "Exit codes: 0 done, …"
std::string told_exit_codes() {
  std::string text;
  for (const ExitCode& exit : exit_codes) {
    text += (text.empty() ? "Exit codes: " : ", ") + std::to_string(exit.code) + " " + exit.meaning;
  }
  return text + ".\n";
}

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
    std::cerr << "mien: " << failure_text(failure) << '\n';
  } catch (...) {
    std::cerr << "mien: it failed, and nothing says why\n";
  }
  std::_Exit(exit_failed);
}

}  // namespace

Command program_of(std::vector<Command> commands) {
  return {.name = "mien",
          .summary =
              "mien makes human motion stimuli: from adjectives to walks, videos and comparison "
              "sheets.",
          .options = {flag("--version", {}, "Display program version information and exit")},
          .commands = std::move(commands),
          .notes = examples + ("\n" + told_exit_codes()) +
                   "Progress and faults go to standard error, results to standard output."};
}

int run_program(int argc, char** argv, const std::function<Command()>& program) {
  give_back_pictures();
  std::set_terminate(end_at_once);
  keep_standard_streams_open();
  refuse_other_version();
  become_other_program(argc, argv);
  const SignalWatch signals;
  StandardOutput output;
  PrintableStream err(std::cerr, StreamReader::terminal);
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  int code = exit_failed;
  {
    PrintableStream out(output.stream(), isatty(STDOUT_FILENO) != 0 ? StreamReader::terminal
                                                                    : StreamReader::program);
    code = run_command_line(program(), argc, argv, {out, err, is_terminal, signals.token()});
  }  // what it still held is passed on
  return output.finish(code, err);
}

}  // namespace mien::pipeline
